//! [`Law`]: what is computed for each element; [`Operand`]: where its arguments come from.

use dq8::simd::Records;
use dq8::{Backend, Lanes, Level, Scalar, storage};

/// A function of up to three arguments of `A`, `B` and `C` numbers, whose result has `D`. An
/// argument of no numbers is not there.
pub trait Law<const A: usize, const B: usize, const C: usize, const D: usize>:
    Copy + Send + Sync
{
    /// Whether it computes so much per number that AVX-512 is faster, although the transposes in
    /// and out are slower there, and that two or three kernels are as fast as one for each
    /// combination of operands.
    const WIDE: bool = false;

    /// On lanes.
    fn of<L: Lanes>(self, a: [L; A], b: [L; B], c: [L; C]) -> [L; D];

    /// Of one first argument and many second ones, where there is a quicker way than lanes of the
    /// same; false if there is none.
    fn of_one<R: Scalar>(
        self,
        backend: Backend,
        a: &[R; A],
        b: &[[R; B]],
        to: &mut [[R; D]],
    ) -> bool {
        let _ = (backend, a, b, to);
        false
    }
}

/// Where a kernel reads an argument.
pub trait Operand<R: Scalar, const C: usize>: Copy + Send + Sync {
    /// The elements from `first` on, one per lane.
    fn load<V: Level>(self, level: V, first: usize) -> Option<[R::Lanes<V>; C]>;
    /// The elements from `first` on.
    fn from(self, first: usize) -> Self;
}

/// The same for all elements.
#[derive(Clone, Copy, Debug)]
pub struct One<R, const C: usize>(pub [R; C]);

impl<R: Scalar, const C: usize> Operand<R, C> for One<R, C> {
    #[inline(always)]
    fn load<V: Level>(self, level: V, _: usize) -> Option<[R::Lanes<V>; C]> {
        let mut lanes = [R::Lanes::<V>::splat(level, R::ZERO); C];
        let mut c = 0;
        while c < C {
            lanes[c] = R::Lanes::<V>::splat(level, self.0[c]);
            c += 1;
        }
        Some(lanes)
    }
    #[inline(always)]
    fn from(self, _: usize) -> Self {
        self
    }
}

/// One for each element; or so many, over and over.
#[derive(Clone, Copy, Debug)]
pub struct Each<'s, R, const C: usize> {
    /// Where they begin over again, some follow that are the first ones: a register may read beyond
    /// the end.
    pub records: &'s [[R; C]],
    /// After how many they begin over again.
    pub period: usize,
    /// The first one of the run.
    pub first: usize,
}

impl<'s, R: Scalar, const C: usize> Each<'s, R, C> {
    /// So many, once.
    pub fn of(records: &'s [[R; C]]) -> Self {
        Self { records, period: usize::MAX, first: 0 }
    }

    /// The first one; of what is not there, zeros.
    pub fn one(self) -> [R; C] {
        self.records.get(self.first).copied().unwrap_or([R::ZERO; C])
    }
}

impl<R: Scalar, const C: usize> Operand<R, C> for Each<'_, R, C> {
    #[inline(always)]
    fn load<V: Level>(self, level: V, first: usize) -> Option<[R::Lanes<V>; C]> {
        let mut at = self.first + first;
        // Divisions are slow, and most arguments do not begin over again.
        if at >= self.period {
            at %= self.period;
        }
        load(level, self.records.get(at..)?)
    }
    #[inline(always)]
    fn from(self, first: usize) -> Self {
        Self { first: self.first + first, ..self }
    }
}

/// [`Each`], whatever there is in an element.
#[derive(Clone, Copy, Debug)]
pub struct Numbers<'s, R> {
    /// Element after element.
    pub numbers: &'s [R],
    /// As in [`Each`].
    pub period: usize,
    /// As in [`Each`].
    pub first: usize,
}

impl<'s, R> Numbers<'s, R> {
    /// So many, once.
    pub fn of(numbers: &'s [R]) -> Self {
        Self { numbers, period: usize::MAX, first: 0 }
    }

    /// Those of elements of `C` numbers.
    pub fn each<const C: usize>(self) -> Each<'s, R, C> {
        let Self { numbers, period, first } = self;
        // An argument that is not there has elements of no numbers.
        let records = if C == 0 { &[] } else { numbers.as_chunks().0 };
        Each { records, period, first }
    }

    /// The elements from `first` on.
    pub fn from(self, first: usize) -> Self {
        Self { first: self.first + first, ..self }
    }
}

/// One for all elements or one for each: told while it runs, so that there is one kernel for both.
/// For what computes so much that this does not count.
#[derive(Clone, Copy, Debug)]
pub struct OneOrEach<'s, R, const C: usize> {
    one: [R; C],
    each: Each<'s, R, C>,
    is_each: bool,
}

impl<'s, R: Scalar, const C: usize> OneOrEach<'s, R, C> {
    /// The first of `each`, or all of them; of what is not there, zeros.
    pub fn of(each: Each<'s, R, C>, is_each: bool) -> Self {
        Self { one: each.one(), each, is_each: C > 0 && is_each }
    }
}

impl<R: Scalar, const C: usize> Operand<R, C> for OneOrEach<'_, R, C> {
    #[inline(always)]
    fn load<V: Level>(self, level: V, first: usize) -> Option<[R::Lanes<V>; C]> {
        if self.is_each { self.each.load(level, first) } else { One(self.one).load(level, first) }
    }
    #[inline(always)]
    fn from(self, first: usize) -> Self {
        Self { each: self.each.from(first), ..self }
    }
}

/// Element `i` of `from` in lane `i`; what changes nothing in the lanes that are left.
#[inline(always)]
pub fn load<R: Scalar, V: Level, const C: usize>(
    level: V,
    from: &[[R; C]],
) -> Option<[R::Lanes<V>; C]> {
    // Single numbers need no transpose, and a vector of them is one load.
    if C == 1 {
        let numbers = from.as_flattened();
        let lanes = match numbers.get(..R::Lanes::<V>::LANES) {
            Some(full) => {
                let mut array = R::Lanes::<V>::splat(level, R::ZERO).to_array();
                array.as_mut().copy_from_slice(full);
                R::Lanes::<V>::load(level, &array)
            }
            None => R::Lanes::<V>::load_partial(level, numbers, R::ZERO),
        };
        return Some([lanes; C]);
    }
    Some(R::Lanes::<V>::load_records(level, from, storage::identity()))
}

/// Lane `i` to element `i` of `to`.
#[inline(always)]
pub fn store<L: Lanes, const D: usize>(components: [L; D], to: &mut [[L::Real; D]]) {
    if let [lanes] = components.as_slice() {
        let numbers = to.as_flattened_mut();
        match numbers.get_mut(..L::LANES) {
            Some(full) => full.copy_from_slice(lanes.to_array().as_ref()),
            None => lanes.store_partial(numbers),
        }
        return;
    }
    L::store_records(components, to);
}
