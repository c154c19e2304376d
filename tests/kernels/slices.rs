//! Kernels over slices: in every layout, on every backend, of any length, what one motion after the
//! other is. What a kernel is, [`kernels`] says once.

use crate::inputs::{BETWEEN, HEAVIER, Inputs, LONG};
use crate::memory::{Memory, lay, read, round};
use crate::records::{entries, equal, is_finite, same_bits};
use crate::scene::rounded;
use crate::subject::for_every_subject;
use dq8::hierarchy::MatrixOrder;
use dq8::internal::{for_each_kernel, record};
use dq8::storage::Aos;
use dq8::{Backend, DualQuat, ShapeError};

type Answer = Result<Vec<Vec<f64>>, ShapeError>;

/// A kernel, where it can be the same in place, and its elements by the scalar reference in `f64`.
pub(crate) struct Kernel<L: Memory> {
    pub(crate) name: &'static str,
    /// What its errors call the slices that are to be as long as the first one, the output last.
    as_long: &'static [&'static str],
    run: fn(Backend, &Given<L>) -> Answer,
    in_place: Option<fn(Backend, &Given<L>) -> Answer>,
    by_the_book: fn(&One) -> Vec<f64>,
}

/// [`Inputs`] in one layout.
struct Given<L: Memory> {
    count: usize,
    a: Vec<L::Record<8>>,
    b: Vec<L::Record<8>>,
    long: Vec<L::Record<8>>,
    t: Vec<L::Record<1>>,
    heavier: Vec<L::Record<1>>,
    vectors: Vec<L::Record<3>>,
    planes: Vec<L::Record<4>>,
    twists: Vec<L::Record<6>>,
    one: DualQuat<L::Real>,
    between: L::Real,
    /// Elements of the output.
    room: usize,
}

/// Element `i` of [`Inputs`], under the names of [`Given`].
struct One {
    a: [f64; 8],
    b: [f64; 8],
    long: [f64; 8],
    t: [f64; 1],
    vectors: [f64; 3],
    planes: [f64; 4],
    twists: [f64; 6],
    one: DualQuat<f64>,
    between: f64,
}

impl One {
    fn new(inputs: &Inputs, i: usize, between: f64) -> Self {
        Self {
            a: inputs.a[i],
            b: inputs.b[i],
            long: inputs.a[i].map(|c| LONG * c),
            t: inputs.t[i],
            vectors: inputs.vectors[i],
            planes: inputs.planes[i],
            twists: inputs.twists[i],
            one: DualQuat::from_array(inputs.one),
            between,
        }
    }
}

impl<L: Memory> Given<L> {
    fn new(inputs: &Inputs) -> Self {
        let a = lay::<L, 8>(1, &inputs.a);
        Self {
            count: inputs.a.len(),
            room: a.len(),
            a,
            b: lay::<L, 8>(1, &inputs.b),
            long: lay::<L, 8>(1, &inputs.long()),
            t: lay::<L, 1>(1, &inputs.t),
            heavier: lay::<L, 1>(1, &vec![[HEAVIER]; inputs.a.len()]),
            vectors: lay::<L, 3>(1, &inputs.vectors),
            planes: lay::<L, 4>(1, &inputs.planes),
            twists: lay::<L, 6>(1, &inputs.twists),
            one: DualQuat::from_array(round(inputs.one)),
            between: round([BETWEEN])[0],
        }
    }

    /// Slice number `which` without its last element; false if there is no such slice.
    fn shorten(&mut self, which: usize) -> bool {
        match which {
            0 => drop((self.a.pop(), self.long.pop())),
            1 => drop(self.b.pop()),
            2 => drop(self.t.pop()),
            3 => drop(self.heavier.pop()),
            4 => drop(self.vectors.pop()),
            5 => drop(self.planes.pop()),
            6 => drop(self.twists.pop()),
            7 => self.room -= 1,
            _ => return false,
        }
        true
    }

    /// What a kernel writes; if it fails, it has written nothing.
    fn to<const C: usize>(
        &self,
        run: impl FnOnce(&mut [L::Record<C>]) -> Result<(), ShapeError>,
    ) -> Answer {
        self.over(&vec![L::filled::<C>(round([9.0])[0]); self.room], run)
    }

    /// The same over `before`.
    fn over<const C: usize>(
        &self,
        before: &[L::Record<C>],
        run: impl FnOnce(&mut [L::Record<C>]) -> Result<(), ShapeError>,
    ) -> Answer {
        let mut output = before.to_vec();
        let answer = run(&mut output);
        let [before, output] = [before, &output].map(|records| read::<L, C>(1, records));
        assert!(answer.is_ok() || output == before, "written in spite of {answer:?}");
        answer.map(|()| output.iter().take(self.count).map(|record| record.to_vec()).collect())
    }
}

impl<L: Memory> Kernel<L> {
    const fn new(
        name: &'static str,
        as_long: &'static [&'static str],
        run: fn(Backend, &Given<L>) -> Answer,
        by_the_book: fn(&One) -> Vec<f64>,
    ) -> Self {
        Self { name, as_long, run, in_place: None, by_the_book }
    }

    const fn in_place(self, in_place: Option<fn(Backend, &Given<L>) -> Answer>) -> Self {
        Self { in_place, ..self }
    }

    /// What it makes of inputs, in place too.
    pub(crate) fn compute(&self, backend: Backend, inputs: &Inputs) -> Vec<Vec<f64>> {
        let given = Given::new(inputs);
        let answer = (self.run)(backend, &given).expect("they fit");
        if let Some(in_place) = self.in_place {
            let in_place = in_place(backend, &given).expect("they fit");
            let same = in_place.iter().zip(&answer).all(|(a, b)| same_bits(a, b));
            assert!(same, "{} in place on {backend}", self.name);
        }
        answer
    }

    /// Panics unless slices shorter than the first one are refused by their names.
    pub(crate) fn are_as_long(&self, backend: Backend, inputs: &Inputs) {
        let (mut named, elements) = (Vec::new(), Given::<L>::new(inputs).room);
        for which in 0.. {
            let mut given = Given::<L>::new(inputs);
            if !given.shorten(which) {
                break;
            }
            match (self.run)(backend, &given) {
                Ok(_) => {}
                Err(ShapeError::Length { what, length, expected }) if length < expected => {
                    assert_eq!([length, expected], [elements - 1, elements], "{}", self.name);
                    named.push(what);
                }
                // The first one is too short for the others.
                Err(error) => {
                    let ShapeError::Length { length, expected, .. } = error else {
                        panic!("{error}")
                    };
                    assert_eq!([length, expected], [elements, elements - 1], "{}", self.name);
                }
            }
        }
        assert_eq!(named, self.as_long, "{}, {}", self.name, L::name());
    }
}

/// The kernels that are declared in the list: their methods, and the same formula of single things.
macro_rules! of_each {
    ($(
        $(#[doc = $brief:literal])+
        $name:ident $(as $c:literal)? [$($types:tt)*]
        ($input:ident: $kind:ident $I:ident $(, $other:ident: $others:ident $O:ident)* $(; $parameter:ident)?)
            -> $output:ident: $result:ident $Q:ident $(, in place $in_place:ident)? = $one:expr, {
            $($more:tt)*
        }
    )*) => {
        fn of_each<L: Memory>() -> Vec<Kernel<L>> {
            vec![$(
                Kernel::new(
                    stringify!($name),
                    &[$(stringify!($other),)* stringify!($output)],
                    |k, x| x.to::<{ record!($result) }>(|to| {
                        $(let $parameter = x.between;)?
                        let $input = given!(x $input $kind);
                        k.$name($input, $(given!(x $other $others),)* $($parameter,)? to)
                    }),
                    |x| {
                        let $input = record!($kind from *given!(x $input $kind));
                        $(let $other = record!($others from *given!(x $other $others));)*
                        $(let $parameter = x.between;)?
                        record!($result of $one).to_vec()
                    },
                )
                .in_place(in_place!($($in_place)? of $input $kind $(, $other $others)*)),
            )*]
        }
    };
}

/// The input of that name and kind.
macro_rules! given {
    ($x:ident motions any) => {
        &$x.long
    };
    ($x:ident b $kind:ident) => {
        &$x.b
    };
    ($x:ident $name:ident any) => {
        &$x.a
    };
    ($x:ident $name:ident unit) => {
        &$x.a
    };
    ($x:ident $name:ident number) => {
        &$x.t
    };
    ($x:ident $name:ident point) => {
        &$x.vectors
    };
    ($x:ident $name:ident vector) => {
        &$x.vectors
    };
    ($x:ident $name:ident plane) => {
        &$x.planes
    };
    // Lines, twists and logarithms.
    ($x:ident $name:ident $six:ident) => {
        &$x.twists
    };
}

/// The call in place, if there is one; without other slices it cannot fail.
macro_rules! in_place {
    (of $($inputs:tt)*) => { None };
    ($name:ident of $input:ident $kind:ident) => {
        Some(|k, x| x.over(given!(x $input $kind), |to| { k.$name(to); Ok(()) }))
    };
    ($name:ident of $input:ident $kind:ident $(, $other:ident $others:ident)+) => {
        Some(|k, x| x.over(given!(x $input $kind), |to| k.$name(to $(, given!(x $other $others))+)))
    };
}

for_each_kernel!(of_each);

/// Every kernel over slices whose elements do not see each other.
#[rustfmt::skip]
pub(crate) fn kernels<L: Memory>() -> Vec<Kernel<L>> {
    use MatrixOrder::{Columns, Rows};
    let mut all = of_each();
    all.extend([
        Kernel::new("mul_left_in_place", &[], |k, x| x.over(&x.b, |o| { k.mul_left_in_place(x.one, o); Ok(()) }),
            |x| (x.one * DualQuat::from_array(x.b)).to_array().to_vec()),
        Kernel::new("dlb", &["influence", "influence", "weights", "weights"],
            |k, x| x.to(|o| k.dlb([(&x.a[..], &x.heavier[..]), (&x.b, &x.t)], o)), |x| {
            let [a, b] = [x.a, x.b].map(DualQuat::from_array);
            DualQuat::dlb(&[(a, HEAVIER), (b, x.t[0])]).expect("two").to_array().to_vec()
        }),
        Kernel::new("transform_points", &["moved"], |k, x| x.to(|o| k.transform_points(x.one, &x.vectors, o)),
            |x| x.one.transform_point(x.vectors).to_vec())
            .in_place(Some(|k, x| x.over(&x.vectors, |o| { k.transform_points_in_place(x.one, o); Ok(()) }))),
        Kernel::new("transform_vectors", &["turned"], |k, x| x.to(|o| k.transform_vectors(x.one, &x.vectors, o)),
            |x| x.one.transform_vector(x.vectors).to_vec())
            .in_place(Some(|k, x| x.over(&x.vectors, |o| { k.transform_vectors_in_place(x.one, o); Ok(()) }))),
        Kernel::new("matrices, 3 by 4, rows", &["matrices"], |k, x| x.to::<12>(|o| k.matrices(&x.a, Rows, o)),
            |x| entries(DualQuat::from_array(x.a), Rows, 12)),
        Kernel::new("matrices, 3 by 4, columns", &["matrices"], |k, x| x.to::<12>(|o| k.matrices(&x.a, Columns, o)),
            |x| entries(DualQuat::from_array(x.a), Columns, 12)),
        Kernel::new("matrices, 4 by 4, rows", &["matrices"], |k, x| x.to::<16>(|o| k.matrices(&x.a, Rows, o)),
            |x| entries(DualQuat::from_array(x.a), Rows, 16)),
        Kernel::new("matrices, 4 by 4, columns", &["matrices"], |k, x| x.to::<16>(|o| k.matrices(&x.a, Columns, o)),
            |x| entries(DualQuat::from_array(x.a), Columns, 16)),
    ]);
    all
}

#[test]
fn slices_are_computed_as_one_motion_after_the_other() {
    // Some more than two steps of the widest lanes there are.
    for length in [0, 1, 3, 7, 8, 16, 17, 33, 37] {
        let inputs = Inputs::new(length);
        for_every_subject(|subject, backend| {
            let single = subject.single();
            let epsilon = if single { f64::from(f32::EPSILON) } else { f64::EPSILON };
            let exact = inputs.rounded(single);
            let between = rounded(single, &[[BETWEEN]])[0][0];
            for (index, kernel) in kernels::<Aos<f64>>().iter().enumerate() {
                let got = subject.slices(backend, index, &inputs);
                assert_eq!(got.len(), length);
                for (i, got) in got.iter().enumerate() {
                    let wanted = (kernel.by_the_book)(&One::new(&exact, i, between));
                    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 24.0 * epsilon;
                    assert!(
                        got.len() == wanted.len() && got.iter().zip(&wanted).all(close),
                        "{}, {} of {length}, {i}, {backend}: {got:?} is not {wanted:?}",
                        kernel.name,
                        subject.name()
                    );
                }
            }
        });
    }
}

#[test]
fn an_element_gets_the_same_bits_wherever_it_stands() {
    let inputs = Inputs::new(37);
    for_every_subject(|subject, backend| {
        for (index, kernel) in kernels::<Aos<f64>>().iter().enumerate() {
            let whole = subject.slices(backend, index, &inputs);
            for first in [1, 2, 3, 5, 8, 13, 15, 16, 21, 29, 36] {
                let rest = subject.slices(backend, index, &inputs.from(first));
                for (rest, whole) in rest.iter().zip(&whole[first..]) {
                    let what = || format!("{}, {}, {backend}", kernel.name, subject.name());
                    assert!(same_bits(rest, whole), "{}, {first}", what());
                }
            }
        }
    });
}

/// One motion that is none leaves the others as they are, whatever is computed.
#[test]
fn what_is_no_motion_is_seen_in_its_own_place_only() {
    let clean = Inputs::new(35);
    for_every_subject(|subject, backend| {
        for (index, &Kernel { name, .. }) in kernels::<Aos<f64>>().iter().enumerate() {
            let without = subject.slices(backend, index, &clean);
            for (at, component) in [(0, 3), (7, 0), (33, 5)] {
                for poison in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                    let mut inputs = clean.clone();
                    (inputs.a[at][component], inputs.b[at][component]) = (poison, poison);
                    (inputs.t[at][0], inputs.vectors[at][0]) = (poison, poison);
                    (inputs.planes[at][0], inputs.twists[at][component % 6]) = (poison, poison);
                    let with = subject.slices(backend, index, &inputs);
                    for (i, (with, without)) in with.iter().zip(&without).enumerate() {
                        let what = || format!("{name}, {}, {backend}", subject.name());
                        // A rotation does not know of a dual part.
                        let turns = ["transform_vectors_each", "angles"];
                        let knows = component < 4 || !turns.contains(&name);
                        if i != at {
                            assert!(same_bits(with, without), "{}: {at} reached {i}", what());
                        } else if knows || name == "transform_vectors" {
                            // The inverse of what is infinite may be zero.
                            let changed = !is_finite(with) || !equal(with, without);
                            assert!(changed, "{}: nothing of {poison}", what());
                        }
                    }
                }
            }
        }
        let mut zero = clean.clone();
        zero.a[7] = [0.0; 8];
        let normalize = kernels::<Aos<f64>>().iter().position(|kernel| kernel.name == "normalize");
        let units = subject.slices(backend, normalize.expect("it is there"), &zero);
        for (i, unit) in units.iter().enumerate() {
            assert_eq!(unit.iter().any(|c| c.is_nan()), i == 7, "{backend}: {i}");
        }
    });
}

/// Without optimisation each value of a kernel, and of what it inlines, has a place of its own:
/// `tests/stack.rs`.
#[test]
#[cfg(not(target_family = "wasm"))]
fn every_kernel_needs_one_mebibyte_of_stack() {
    dq8_contract::stack::within(1024, |backend| {
        let inputs = Inputs::new(37);
        for_every_subject(|subject, on| {
            for index in (0..kernels::<Aos<f64>>().len()).filter(|_| on == backend) {
                subject.slices(backend, index, &inputs);
            }
        });
    });
}

#[test]
fn slices_of_different_lengths_are_refused_and_the_output_is_untouched() {
    for_every_subject(|subject, backend| subject.slices_are_as_long(backend, &Inputs::new(35)));
    let mut out = [DualQuat::from_translation([7.0, 8.0, 9.0]); 5];
    let refused = Backend::best().mul_in_place(&mut out, &[DualQuat::<f32>::IDENTITY; 4]);
    assert_eq!(refused, Err(ShapeError::Length { what: "b", length: 4, expected: 5 }));
    assert_eq!(out, [DualQuat::from_translation([7.0, 8.0, 9.0]); 5]);
}
