//! The loop of all functions on arrays.

use crate::law::{Each, Law, One, Operand, store};
use crate::threads::Threads;
use dq8::{Backend, Kernel, Lanes, Level, Scalar};

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
    // What is not there has no first element either; its one element has no numbers.
    let one = (
        One(a.records.get(a.first).copied().unwrap_or([R::ZERO; A])),
        One(b.records.get(b.first).copied().unwrap_or([R::ZERO; B])),
        One(c.records.get(c.first).copied().unwrap_or([R::ZERO; C])),
    );
    let each_one = [A > 0 && each[0], B > 0 && each[1], C > 0 && each[2]];
    match each_one {
        [true, true, true] => chunks(threads, law, a, b, c, to),
        [true, true, false] => chunks(threads, law, a, b, one.2, to),
        [true, false, true] => chunks(threads, law, a, one.1, c, to),
        [true, false, false] => chunks(threads, law, a, one.1, one.2, to),
        [false, true, true] => chunks(threads, law, one.0, b, c, to),
        [false, true, false] => {
            let backend = Backend::best();
            if !threads.split(to, |first, to| {
                let records = b.records.get(b.first + first..).unwrap_or_default();
                let records = records.get(..to.len()).unwrap_or_default();
                law.of_one(backend, &one.0.0, records, to)
            }) {
                chunks(threads, law, one.0, b, one.2, to);
            }
        }
        [false, false, true] => chunks(threads, law, one.0, one.1, c, to),
        // One result, over and over: arrays without strides.
        [false, false, false] => chunks(threads, law, one.0, one.1, one.2, to),
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
    threads.split(to, |first, to| {
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
