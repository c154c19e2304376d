//! The loop of all functions on arrays.

use crate::law::{Each, Law, One, OneOrEach, Operand, store};
use crate::threads::{GRAIN, Threads};
use dq8::{Backend, Kernel, Lanes, Level, Scalar};
use std::slice;

/// Which of the three arguments has an element for each result, where the others are one for all.
pub(crate) type Which = [bool; 3];

/// The arguments of one run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arguments<'s, R, const A: usize, const B: usize, const C: usize> {
    pub(crate) a: Each<'s, R, A>,
    pub(crate) b: Each<'s, R, B>,
    pub(crate) c: Each<'s, R, C>,
}

/// Writes `law` of the arguments over `to`; on more than one thread where it pays.
pub(crate) fn sweep<R, F, const A: usize, const B: usize, const C: usize, const D: usize>(
    threads: &Threads,
    law: F,
    arguments: Arguments<'_, R, A, B, C>,
    each: Which,
    to: &mut [[R; D]],
) where
    R: Scalar + Send + Sync,
    F: Law<A, B, C, D>,
{
    let Arguments { a, b, c } = arguments;
    if !(A > 0 && each[0]) && B > 0 && each[1] && !(C > 0 && each[2]) {
        let one = a.one();
        let done = threads.split(GRAIN, to, &|(first, to)| {
            let records = b.records.get(b.first + first..).unwrap_or_default();
            let records = records.get(..to.len()).unwrap_or_default();
            law.of_one(Backend::best(), &one, records, to)
        });
        if done {
            return;
        }
    }
    // One for all, all of them: one element says what all are.
    if each == [false; 3] {
        let Some((first, rest)) = to.split_first_mut() else { return };
        operands(threads, law, Arguments { a, b, c }, [true, false, false], slice::from_mut(first));
        return rest.fill(*first);
    }
    operands(threads, law, Arguments { a, b, c }, each, to);
}

/// [`sweep`], where some argument has an element for each result.
///
/// Each combination of operands is a kernel of its own, and what the compiler works for. So there is one where a look at
/// where an argument lies costs nothing ([`Law::WIDE`], and third arguments); but what is computed of the first argument,
/// or of the first two, is computed once if they are one for all. (The constants keep it from kernels that nothing calls.)
fn operands<R, F, const A: usize, const B: usize, const C: usize, const D: usize>(
    threads: &Threads,
    law: F,
    arguments: Arguments<'_, R, A, B, C>,
    each: Which,
    to: &mut [[R; D]],
) where
    R: Scalar + Send + Sync,
    F: Law<A, B, C, D>,
{
    let Arguments { a, b, c } = arguments;
    let last = OneOrEach::of(c, each[2]);
    if const { F::WIDE && C > 0 } && (each[0] || each[1]) {
        chunks(threads, law, OneOrEach::of(a, each[0]), OneOrEach::of(b, each[1]), last, to);
    } else if const { F::WIDE && B > 0 && C == 0 } && each[0] {
        chunks(threads, law, a, OneOrEach::of(b, each[1]), last, to);
    } else if const { !F::WIDE && C > 0 } && each == [true; 3] {
        chunks(threads, law, a, b, c, to);
    } else if const { !F::WIDE && B > 0 } && each[0] && each[1] {
        chunks(threads, law, a, b, One(c.one()), to);
    } else if const { !F::WIDE || B == 0 } && each[0] {
        chunks(threads, law, a, One(b.one()), last, to);
    } else if const { C > 0 } && !each[1] {
        chunks(threads, law, One(a.one()), One(b.one()), last, to);
    } else if const { B > 0 && !(F::WIDE && C > 0) } {
        chunks(threads, law, One(a.one()), b, last, to);
    }
}

/// [`sweep`], of operands.
fn chunks<R, F, X, Y, Z, const A: usize, const B: usize, const C: usize, const D: usize>(
    threads: &Threads,
    law: F,
    a: X,
    b: Y,
    c: Z,
    to: &mut [[R; D]],
) where
    R: Scalar + Send + Sync,
    F: Law<A, B, C, D>,
    X: Operand<R, A>,
    Y: Operand<R, B>,
    Z: Operand<R, C>,
{
    let backend = Backend::best();
    threads.split(GRAIN, to, &|(first, to)| {
        backend.run(Sweep { law, a: a.from(first), b: b.from(first), c: c.from(first), to });
        true
    });
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
