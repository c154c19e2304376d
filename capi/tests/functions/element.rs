//! The elements of arrays: a sample, a random one, and their bits.

use dq8::simd::{Block, Row};
use dq8::{DualQuat, Quat, Real, Twist};
use dq8_capi::clip_files::Frames;
use dq8_capi::clips::{Clips, Place};
use dq8_capi::fit::FitQuality;
use dq8_capi::joint::Joint;
use dq8_capi::mechanism::{Mechanism, Step};
use dq8_capi::reach::{Goal, ReachOptions, ReachReport};
use dq8_capi::skin::Skin;
use dq8_capi::solutions::Solutions;
use dq8_capi::trajectory::Options;
use dq8_fixtures::random::Random;
use std::fmt::Debug;

pub(crate) trait Element: Copy + 'static {
    /// Element `at` of an array. Arrays with different seeds have nothing in common.
    fn sample(at: usize, seed: usize) -> Self;
    /// A random element.
    fn random(random: &mut Random) -> Self;
    /// Appends the bits, in which all NaN are the same.
    fn bits(&self, to: &mut Vec<u64>);
}

pub(crate) fn wave<R: Real>(at: usize, seed: usize) -> R {
    R::from_f64((at as f64 * 1.7 + seed as f64 * 1.1 + 0.3).sin())
}

/// The first seed of motions that are not unit.
pub(crate) const SCALED: usize = 100;

/// A record for its number of components: a unit motion for eight, a rotation and a translation for
/// seven, a rotation for four.
pub(crate) fn record<R: Real, const C: usize>(at: usize, seed: usize) -> [R; C] {
    let mut all = std::array::from_fn(|c| wave(at * 19 + c, seed));
    if let Some((rotation, rest)) = all.split_first_chunk_mut::<4>()
        && matches!(C, 4 | 7 | 8)
    {
        let turn = Quat::from_array(*rotation).normalize();
        *rotation = turn.to_array();
        if let Some(dual) = rest.first_chunk_mut::<4>() {
            let [.., x, y, z, w] =
                DualQuat::from_rotation_translation(turn, [dual[0], dual[1], dual[2]]).to_array();
            *dual = [x, y, z, w];
        }
    }
    if seed >= SCALED { all.map(|number| number * R::from_f64(3.0)) } else { all }
}

macro_rules! numbers {
    ($($R:ident $single:literal;)*) => {$(
        impl Element for $R {
            fn sample(at: usize, seed: usize) -> Self {
                wave(at, seed)
            }
            fn random(random: &mut Random) -> Self {
                random.number($single, 0.2) as $R
            }
            fn bits(&self, to: &mut Vec<u64>) {
                to.push(if self.is_nan() { u64::MAX } else { self.to_bits().into() });
            }
        }
        impl<const C: usize> Element for [$R; C] {
            fn sample(at: usize, seed: usize) -> Self {
                record(at, seed)
            }
            fn random(random: &mut Random) -> Self {
                [(); C].map(|()| $R::random(random))
            }
            fn bits(&self, to: &mut Vec<u64>) {
                self.iter().for_each(|number| number.bits(to));
            }
        }
        impl<const C: usize, const N: usize> Element for Block<[$R; N], C>
        where
            [$R; N]: Row<Real = $R>,
        {
            fn sample(at: usize, seed: usize) -> Self {
                let mut block = Block::splat([0.0; C]);
                for lane in 0..N {
                    assert!(block.set(lane, record(at * N + lane, seed)).is_ok());
                }
                block
            }
            fn random(random: &mut Random) -> Self {
                Block([(); C].map(|()| Element::random(random)))
            }
            fn bits(&self, to: &mut Vec<u64>) {
                self.0.bits(to);
            }
        }
    )*};
}
numbers! { f32 true; f64 false; }

macro_rules! rows {
    ($($R:ident)*) => {$(
        impl<const C: usize, const D: usize> Element for [[$R; C]; D] {
            fn sample(at: usize, seed: usize) -> Self {
                std::array::from_fn(|row| std::array::from_fn(|c| wave((at * D + row) * C + c, seed)))
            }
            fn random(random: &mut Random) -> Self {
                [(); D].map(|()| Element::random(random))
            }
            fn bits(&self, to: &mut Vec<u64>) {
                self.iter().for_each(|row| row.bits(to));
            }
        }
    )*};
}
rows! { f32 f64 }

macro_rules! from_array {
    ($($Type:ident $count:literal)*) => {$(
        impl<R: Real> Element for $Type<R>
        where
            [R; $count]: Element,
        {
            fn sample(at: usize, seed: usize) -> Self {
                Self::from_array(Element::sample(at, seed))
            }
            fn random(random: &mut Random) -> Self {
                Self::from_array(Element::random(random))
            }
            fn bits(&self, to: &mut Vec<u64>) {
                self.to_array().bits(to);
            }
        }
    )*};
}
from_array! { DualQuat 8 Quat 4 Twist 6 }

/// A thing all of whose bytes are zero: arrays that are read say with what else to fill them.
pub(crate) fn zeroed<T: Copy>() -> T {
    // SAFETY: called for numbers, pointers, and what has not been made.
    unsafe { std::mem::zeroed() }
}

macro_rules! things {
    ($([$($R:ident)?] $Type:ty, |$thing:ident| $shown:expr;)*) => {$(
        impl$(<$R: Copy + Debug + 'static>)? Element for $Type {
            fn sample(_: usize, _: usize) -> Self {
                zeroed()
            }
            fn random(_: &mut Random) -> Self {
                zeroed()
            }
            fn bits(&self, to: &mut Vec<u64>) {
                let $thing = self;
                to.extend(format!("{:?}", $shown).bytes().map(u64::from));
            }
        }
    )*};
}
things! {
    [] u8, |number| number;
    [] u16, |number| number;
    [] i32, |number| number;
    [] usize, |number| number;
    [] [u32; 2], |pair| pair;
    [] [u32; 6], |scratch| scratch;
    [] Place, |place| place;
    [] Options, |options| options;
    [] Frames, |frames| frames;
    [] Clips, |made| (made.joints, made.clips);
    [R] Joint<R>, |joint| joint;
    [R] Step<R>, |_step| ();
    [R] Goal<R>, |goal| goal;
    [R] ReachOptions<R>, |options| options;
    [R] ReachReport<R>, |report| report;
    [R] Solutions<R>, |found| found;
    [R] Mechanism<R>, |made| (made.links, made.values, made.rates);
    [R] FitQuality<R>, |quality| quality;
    [R] Skin<R>, |made| (made.vertices, made.influences, made.joints);
}
