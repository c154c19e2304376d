//! What `quick` asks of a number: the one place where this crate follows the forms that floats
//! have.

use crate::lanes::Wide;
use crate::number::Recorded;
use crate::tape::{Order, compare, value};
use core::ops::BitXor;
use dq8::quick::{Four, Number, between::Even};
use dq8_simd::{Level, Portable};

impl<const S: bool> Number for Recorded<S> {
    type Four = Wide<Portable, S, 4>;
    fn power_of_two(self) -> Self {
        panic!("stretched motions have another path")
    }
    fn is_between(self, least: Self, most: Self) -> bool {
        compare(least.0, Order::LessOrEqual, self.0) & compare(self.0, Order::Less, most.0)
    }
}

/// Screw interpolation has branches, and bounds of its polynomials elsewhere.
impl<const S: bool> Even for Recorded<S> {
    const ARC: [&'static [[Self; 4]]; 2] = [&[], &[]];
    const WAVES: &'static [[Self; 4]] = &[];
}

impl<const S: bool> Four for Wide<Portable, S, 4> {
    type Number = Recorded<S>;
}

/// Signs: the other side is 0 or −0.
impl<V: Level, const S: bool> BitXor for Wide<V, S, 4> {
    type Output = Self;
    fn bitxor(self, signs: Self) -> Self {
        self.zip(signs, |number, sign| {
            let sign = value(sign.0);
            assert_eq!(sign, 0.0, "not a sign");
            if sign.is_sign_negative() { -number } else { number }
        })
    }
}
