use crate::number::Scalar;
use core::marker::PhantomData;

/// The filling of lanes without a thing: the motion, rotation or matrix that changes nothing, and
/// zero for vectors and numbers. Computing with it is never slow, as it is with garbage.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn identity<R: Scalar, const C: usize>() -> [R; C] {
    Identity::<R, C>::RECORD
}

/// A constant, so that nothing is built where it is passed on.
struct Identity<R, const C: usize>(PhantomData<R>);

impl<R: Scalar, const C: usize> Identity<R, C> {
    const RECORD: [R; C] = {
        // Ones lie this far apart, from this place on.
        let (mut one, apart) = match C {
            4 | 7 | 8 => (3, C),
            12 | 16 => (0, 5),
            _ => (C, 1),
        };
        let mut record = [R::ZERO; C];
        while one < C {
            record[one] = R::ONE;
            one += apart;
        }
        record
    };
}
