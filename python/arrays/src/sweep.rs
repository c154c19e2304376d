//! The loop of all functions on arrays.

use crate::law::{Law, Numbers, One, OneOrEach, Operand, store};
use dq8::{Backend, Kernel, Lanes, Level, Scalar};

/// Which of the three arguments has an element for each result, where the others are one for all.
pub(crate) type Which = [bool; 3];

/// What a law computes at once: the numbers of its arguments and of its results. An argument that
/// is not there has none.
pub(crate) struct Piece<'s, R> {
    pub(crate) arguments: [Numbers<'s, R>; 3],
    pub(crate) each: Which,
    pub(crate) to: &'s mut [R],
}

/// Writes `law` of the arguments of a piece, of which some has an element for each result.
///
/// Each combination of operands is a kernel of its own, and what the compiler works for. So there
/// is one where a look at where an argument lies costs nothing ([`Law::WIDE`], and third
/// arguments); but what is computed of the first argument, or of the first two, is computed once if
/// they are one for all. (The constants keep it from kernels that nothing calls.)
pub(crate) fn sweep<R, F, const A: usize, const B: usize, const C: usize, const D: usize>(
    law: F,
    piece: Piece<'_, R>,
) where
    R: Scalar,
    F: Law<A, B, C, D>,
{
    let Piece { arguments: [a, b, c], each, to } = piece;
    let (a, b, c) = (a.each::<A>(), b.each::<B>(), c.each::<C>());
    let to = to.as_chunks_mut::<D>().0;
    if !(A > 0 && each[0]) && B > 0 && each[1] && !(C > 0 && each[2]) {
        let records = b.records.get(b.first..).unwrap_or_default();
        let records = records.get(..to.len()).unwrap_or_default();
        if law.of_one(Backend::best(), &a.one(), records, to) {
            return;
        }
    }
    let last = OneOrEach::of(c, each[2]);
    if const { F::WIDE && C > 0 } && (each[0] || each[1]) {
        run(law, OneOrEach::of(a, each[0]), OneOrEach::of(b, each[1]), last, to);
    } else if const { F::WIDE && B > 0 && C == 0 } && each[0] {
        run(law, a, OneOrEach::of(b, each[1]), last, to);
    } else if const { !F::WIDE && C > 0 } && each == [true; 3] {
        run(law, a, b, c, to);
    } else if const { !F::WIDE && B > 0 } && each[0] && each[1] {
        run(law, a, b, One(c.one()), to);
    } else if const { !F::WIDE || B == 0 } && each[0] {
        run(law, a, One(b.one()), last, to);
    } else if const { C > 0 } && !each[1] {
        run(law, One(a.one()), One(b.one()), last, to);
    } else if const { B > 0 && !(F::WIDE && C > 0) } {
        run(law, One(a.one()), b, last, to);
    }
}

/// [`sweep`], of operands.
fn run<R, F, X, Y, Z, const A: usize, const B: usize, const C: usize, const D: usize>(
    law: F,
    a: X,
    b: Y,
    c: Z,
    to: &mut [[R; D]],
) where
    R: Scalar,
    F: Law<A, B, C, D>,
    X: Operand<R, A>,
    Y: Operand<R, B>,
    Z: Operand<R, C>,
{
    Backend::best().run(Sweep { law, a, b, c, to });
}

struct Sweep<'s, F, X, Y, Z, R, const A: usize, const B: usize, const C: usize, const D: usize> {
    law: F,
    a: X,
    b: Y,
    c: Z,
    to: &'s mut [[R; D]],
}

impl<R, F, X, Y, Z, const A: usize, const B: usize, const C: usize, const D: usize> Kernel
    for Sweep<'_, F, X, Y, Z, R, A, B, C, D>
where
    R: Scalar,
    F: Law<A, B, C, D>,
    X: Operand<R, A>,
    Y: Operand<R, B>,
    Z: Operand<R, C>,
{
    type Output = ();
    const WIDE: bool = F::WIDE;

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { law, a, b, c, to } = self;
        let mut first = 0;
        while let Some(rest) = to.get_mut(first..).filter(|rest| !rest.is_empty()) {
            // The lengths were checked, so these always are something; the compiler need not know.
            let Some(a) = a.load(level, first) else { return };
            let Some(b) = b.load(level, first) else { return };
            let Some(c) = c.load(level, first) else { return };
            store(law.of(a, b, c), rest);
            first += R::Lanes::<V>::LANES;
        }
    }
}
