//! [`Case`]: one element of input, what any operation may ask for; [`Arguments`]: cases dealt out
//! to the lanes of an implementation.

use crate::bound::largest;
use crate::implementation::On;
use crate::lanes::{Motions, Reals};
use dq8::{
    Line, Plane, Twist,
    geometry::{DualVector, Screw, Wrench},
};

macro_rules! deck {
    ($($(#[$about:meta])* $field:ident: $numbers:ty = $lanes:ty;)*) => {
        /// One element of input, in `f64`; implementations round it to their own type.
        #[derive(Clone, Copy, Debug)]
        pub struct Case { $($(#[$about])* pub $field: $numbers,)* }

        /// [`Case`]s dealt out to the lanes of an implementation.
        #[derive(Clone, Copy, Debug)]
        pub struct Arguments { pub on: On, $($(#[$about])* pub $field: $lanes,)* }

        /// How many numbers a [`Case`] holds.
        pub const NUMBERS: usize = 0 $(+ size_of::<$numbers>() / size_of::<f64>())*;

        impl Case {
            pub fn to_numbers(&self) -> [f64; NUMBERS] {
                let mut flat: Vec<f64> = Vec::with_capacity(NUMBERS);
                $(self.$field.put(&mut flat);)*
                flat.try_into().expect("as many as a case holds")
            }

            /// Any numbers at all.
            pub fn of_numbers(numbers: &[f64; NUMBERS]) -> Self {
                let mut rest = numbers.iter().copied();
                let mut next = || rest.next().expect("as many as a case holds");
                Self { $($field: <$numbers>::take(&mut next),)* }
            }
        }

        impl Arguments {
            /// Lane `i` from case `i`; lanes without a case repeat the first.
            pub fn new(on: On, cases: &[Case]) -> Self {
                let dealt: Vec<_> = (0..on.lanes)
                    .map(|lane| cases.get(lane).unwrap_or(&cases[0]).to_numbers())
                    .collect();
                let mut column = 0;
                let mut next = || {
                    column += 1;
                    on.reals(&dealt.iter().map(|case| case[column - 1]).collect::<Vec<_>>())
                };
                Self { on, $($field: <$lanes>::take(&mut next),)* }
            }
        }
    };
}

deck! {
    a: [f64; 8] = Motions;
    b: [f64; 8] = Motions;
    c: [f64; 8] = Motions;
    d: [f64; 8] = Motions;
    /// How a changes by unit of time.
    derivative: [f64; 8] = Motions;
    s: f64 = Reals;
    t: f64 = Reals;
    dt: f64 = Reals;
    /// Of a shell about a body.
    radius: f64 = Reals;
    tolerance: f64 = Reals;
    v: [f64; 3] = [Reals; 3];
    w: [f64; 3] = [Reals; 3];
    weights: [f64; 4] = [Reals; 4];
    /// For `from_matrix3x4`.
    rows: [[f64; 4]; 3] = [[Reals; 4]; 3];
    /// For `from_screw`: direction, moment, angle, slide.
    screw: [f64; 8] = Screw<Reals>;
    /// Twists, angular part first; the first is where Jacobians are taken.
    x: [f64; 6] = Twist<Reals>;
    y: [f64; 6] = Twist<Reals>;
    /// Force, torque.
    wrench: [f64; 6] = Wrench<Reals>;
}

impl Case {
    /// Every number rounded as `on` does.
    pub fn rounded(&self, on: On) -> Self {
        Self::of_numbers(&self.to_numbers().map(|number| on.round(number)))
    }

    pub fn poses(&self) -> [[f64; 8]; 4] {
        [self.a, self.b, self.c, self.d]
    }

    /// |p| itself may be no number though p is one: scalar has nothing to divide by then.
    pub fn is_at_the_end(&self, single: bool) -> bool {
        self.a[..4].iter().any(|c| c.abs() > 0.5 * largest(single))
    }

    /// |ω| of the first twist.
    pub fn angle(&self) -> f64 {
        length(&self.x[..3])
    }
}

/// |v|, of numbers whose squares may be none.
pub fn length(components: &[f64]) -> f64 {
    components.iter().fold(0.0, |length: f64, c| length.hypot(*c))
}

impl Arguments {
    /// The motions normalized, for the laws of unit ones: rounded ones are unit to their last
    /// place.
    pub fn unit(self) -> Self {
        let [a, b, c, d] = [self.a, self.b, self.c, self.d].map(Motions::normalize);
        Self { a, b, c, d, ..self }
    }

    pub fn poses(&self) -> [Motions; 4] {
        [self.a, self.b, self.c, self.d]
    }

    pub fn with_poses(self, [a, b, c, d]: [Motions; 4]) -> Self {
        Self { a, b, c, d, ..self }
    }

    pub fn line(&self) -> Line<Reals> {
        Line { direction: self.v, moment: self.w }
    }

    pub fn plane(&self) -> Plane<Reals> {
        Plane { normal: self.v, offset: self.s }
    }

    pub fn influences(&self) -> [(Motions, Reals); 4] {
        let [wa, wb, wc, wd] = self.weights;
        [(self.a, wa), (self.b, wb), (self.c, wc), (self.d, wd)]
    }
}

/// Numbers in a row: all of them out, or in.
pub trait Flat<T>: Sized {
    fn put(&self, flat: &mut Vec<T>);
    fn take(next: &mut impl FnMut() -> T) -> Self;
}

impl<T: Copy> Flat<T> for T {
    fn put(&self, flat: &mut Vec<T>) {
        flat.push(*self);
    }
    fn take(next: &mut impl FnMut() -> T) -> Self {
        next()
    }
}

impl<T: Copy, const N: usize> Flat<T> for [T; N] {
    fn put(&self, flat: &mut Vec<T>) {
        flat.extend_from_slice(self);
    }
    fn take(next: &mut impl FnMut() -> T) -> Self {
        std::array::from_fn(|_| next())
    }
}

macro_rules! flat_rows {
    ($($columns:literal)*) => {$(
        impl<T: Copy, const N: usize> Flat<T> for [[T; $columns]; N] {
            fn put(&self, flat: &mut Vec<T>) {
                flat.extend_from_slice(self.as_flattened());
            }
            fn take(next: &mut impl FnMut() -> T) -> Self {
                std::array::from_fn(|_| Flat::take(next))
            }
        }
    )*};
}

flat_rows! { 3 4 }

macro_rules! flat {
    ($($type:ident { $($field:ident),* })*) => {$(
        impl<T: Copy> Flat<T> for $type<T> {
                    fn put(&self, flat: &mut Vec<T>) {
                $(self.$field.put(flat);)*
            }
                    fn take(next: &mut impl FnMut() -> T) -> Self {
                Self { $($field: Flat::take(next)),* }
            }
        }
    )*};
}

flat! {
    Line { direction, moment }
    Plane { normal, offset }
    Screw { axis, angle, slide }
    DualVector { real, dual }
    Twist { angular, linear }
    Wrench { force, torque }
}
