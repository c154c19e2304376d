//! [`Implementation`]: an implementation of [`dq8::Motion`] as a table of functions on rows of
//! numbers. Here, and nowhere else, every operation is compiled for every one of them.

use crate::bound::unit_roundoff;
use crate::geometry::{self, Geometry};
use crate::lanes::{MAX_LANES, Motions, Reals, Row};
use crate::operation::{Answer, Call, Domain};
use crate::operations::Calls;
use crate::sample::Sample;
#[cfg(target_arch = "x86_64")]
use crate::sample::{Avx2, Avx512, Proof};
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
use crate::sample::{Level, Unfused};
use crate::textbook::Textbook;
#[cfg(any(target_arch = "aarch64", target_feature = "fma"))]
use dq8::simd::Portable;
use dq8::{DualQuat, batch};
use std::fmt;

/// The operations of one type, by their place in the table.
pub struct Implementation {
    pub name: &'static str,
    /// How many motions one value holds.
    pub lanes: usize,
    /// Whether the numbers are `f32`.
    pub single: bool,
    calls: &'static [Call],
    pub(crate) geometry: &'static [&'static [Option<geometry::Call>]],
}

/// Which implementation.
pub type On = &'static Implementation;

impl fmt::Debug for Implementation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl Implementation {
    const fn of<M: Geometry>(name: &'static str) -> Self {
        assert!(M::LANES <= MAX_LANES, "rows are too short");
        let calls = Calls::<M>::TABLE;
        Self { name, lanes: M::LANES, single: M::SINGLE, calls, geometry: M::GEOMETRY }
    }

    pub(crate) fn call(&self, operation: usize, given: &[Vec<Row>]) -> Answer {
        self.calls[operation](given)
    }

    /// The rows of an argument, made unit where it must be: rounded motions are so to their last
    /// place.
    pub(crate) fn in_domain(&'static self, domain: Domain, mut rows: Vec<Row>) -> Vec<Row> {
        match domain {
            // Influences are motions with their weights.
            Domain::Unit => {
                for motion in rows.chunks_mut(9) {
                    let rows = std::array::from_fn(|c| motion[c]);
                    let unit = Motions { on: self, rows }.normalize();
                    motion[..8].copy_from_slice(&unit.rows);
                }
            }
            Domain::Rotation => {
                let rotation = std::array::from_fn(|c| Reals { on: self, row: rows[c] });
                let unit = self.from_rotation(rotation).normalize().rotation();
                rows.copy_from_slice(&unit.map(|real| real.row));
            }
            Domain::Any | Domain::Other => {}
        }
        rows
    }

    /// The unit roundoff of its numbers.
    pub fn roundoff(&self) -> f64 {
        unit_roundoff(self.single)
    }

    /// The nearest of its numbers.
    pub fn round(&self, number: f64) -> f64 {
        #[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
        if self.single { f64::from(number as f32) } else { number }
    }

    /// The scalar reference of the same precision, without the quicker forms that floats have.
    pub fn scalar(&self) -> On {
        if self.single { &textbook_f32::IMPLEMENTATION } else { scalar_f64() }
    }

    /// Lane `i` from element `i`, rounded.
    pub fn reals(&'static self, lanes: &[f64]) -> Reals {
        assert!(lanes.len() == self.lanes, "{} numbers for {} lanes", lanes.len(), self.lanes);
        let row = std::array::from_fn(|i| lanes.get(i).map_or(0.0, |&number| self.round(number)));
        Reals { on: self, row }
    }

    /// The same number in every lane.
    pub fn splat(&'static self, number: f64) -> Reals {
        self.reals(&vec![number; self.lanes])
    }

    /// Lane `i` from motion `i`.
    pub fn gather(&'static self, motions: &[[f64; 8]]) -> Motions {
        Motions::from_components(std::array::from_fn(|c| {
            self.reals(&motions.iter().map(|motion| motion[c]).collect::<Vec<_>>())
        }))
    }

    /// The same motion in every lane.
    pub fn same(&'static self, motion: [f64; 8]) -> Motions {
        self.gather(&vec![motion; self.lanes])
    }

    pub fn vector(&'static self, vectors: &[[f64; 3]]) -> [Reals; 3] {
        std::array::from_fn(|c| {
            self.reals(&vectors.iter().map(|vector| vector[c]).collect::<Vec<_>>())
        })
    }

    /// The mask that holds for every lane.
    pub fn all(&self) -> u32 {
        (1 << self.lanes) - 1
    }
}

/// The oracle of all others.
pub fn scalar_f64() -> On {
    &textbook_f64::IMPLEMENTATION
}

/// For what needs the type itself: laws of quaternions and dual numbers. It is compiled for every
/// implementation again.
pub trait Visitor {
    fn visit<M: Sample>(&mut self, name: &'static str);
}

/// A module each, so that each is compiled by itself, and again only when it has changed.
macro_rules! implementations {
    ($($(#[$only:meta])* $module:ident $name:literal = $type:ty, where $there:expr;)*) => {
        $(
            $(#[$only])*
            mod $module {
                use super::*;

                pub(super) static IMPLEMENTATION: Implementation =
                    Implementation::of::<$type>($name);
            }
        )*

        /// Visits those that this machine can run, each by its type.
        pub fn visit_implementations(visitor: &mut impl Visitor) {
            $(
                $(#[$only])*
                if $there {
                    visitor.visit::<$type>($name);
                }
            )*
        }

        /// Those that this machine can run.
        pub fn implementations() -> Vec<On> {
            let mut found: Vec<On> = Vec::new();
            $(
                $(#[$only])*
                if $there {
                    found.push(&$module::IMPLEMENTATION);
                }
            )*
            found
        }
    };
}

#[rustfmt::skip]
implementations! {
    textbook_f32 "textbook f32" = DualQuat<Textbook<f32>>, where true;
    textbook_f64 "textbook f64" = DualQuat<Textbook<f64>>, where true;
    scalar_f32 "scalar f32" = DualQuat<f32>, where true;
    scalar_f64 "scalar f64" = DualQuat<f64>, where true;
    f32x1 "lanes f32x1" = batch::DualQuat<f32>, where true;
    f32x4 "lanes f32x4" = batch::DualQuat<dq8::simd::f32x4>, where true;
    f32x8 "lanes f32x8" = batch::DualQuat<dq8::simd::f32x8>, where true;
    f32x16 "lanes f32x16" = batch::DualQuat<dq8::simd::f32x16>, where true;
    f64x1 "lanes f64x1" = batch::DualQuat<f64>, where true;
    f64x2 "lanes f64x2" = batch::DualQuat<dq8::simd::f64x2>, where true;
    f64x4 "lanes f64x4" = batch::DualQuat<dq8::simd::f64x4>, where true;
    f64x8 "lanes f64x8" = batch::DualQuat<dq8::simd::f64x8>, where true;
    #[cfg(target_arch = "x86_64")]
    avx2_f32x8 "lanes AVX2 f32x8" = batch::DualQuat<<Avx2 as Level>::F32x8>, where Avx2::is_there();
    #[cfg(target_arch = "x86_64")]
    avx2_f32x16 "lanes AVX2 f32x16" = batch::DualQuat<<Avx2 as Level>::F32x16>, where Avx2::is_there();
    #[cfg(target_arch = "x86_64")]
    avx2_f64x4 "lanes AVX2 f64x4" = batch::DualQuat<<Avx2 as Level>::F64x4>, where Avx2::is_there();
    #[cfg(target_arch = "x86_64")]
    avx512_f32x8 "lanes AVX-512 f32x8" = batch::DualQuat<<Avx512 as Level>::F32x8>, where Avx512::is_there();
    #[cfg(target_arch = "x86_64")]
    avx512_f32x16 "lanes AVX-512 f32x16" = batch::DualQuat<<Avx512 as Level>::F32x16>, where Avx512::is_there();
    #[cfg(target_arch = "x86_64")]
    avx512_f64x8 "lanes AVX-512 f64x8" = batch::DualQuat<<Avx512 as Level>::F64x8>, where Avx512::is_there();
    // Elsewhere they are those above.
    #[cfg(any(target_arch = "aarch64", target_feature = "fma"))]
    unfused_f32x8 "lanes unfused f32x8" = batch::DualQuat<<Unfused<Portable> as Level>::F32x8>, where true;
    #[cfg(any(target_arch = "aarch64", target_feature = "fma"))]
    unfused_f64x4 "lanes unfused f64x4" = batch::DualQuat<<Unfused<Portable> as Level>::F64x4>, where true;
    #[cfg(target_arch = "x86_64")]
    unfused_avx2_f32x8 "lanes unfused AVX2 f32x8" = batch::DualQuat<<Unfused<Avx2> as Level>::F32x8>, where Avx2::is_there();
    #[cfg(target_arch = "x86_64")]
    unfused_avx2_f64x4 "lanes unfused AVX2 f64x4" = batch::DualQuat<<Unfused<Avx2> as Level>::F64x4>, where Avx2::is_there();
    #[cfg(target_arch = "x86_64")]
    unfused_avx512_f32x16 "lanes unfused AVX-512 f32x16" = batch::DualQuat<<Unfused<Avx512> as Level>::F32x16>, where Avx512::is_there();
    #[cfg(target_arch = "x86_64")]
    unfused_avx512_f64x8 "lanes unfused AVX-512 f64x8" = batch::DualQuat<<Unfused<Avx512> as Level>::F64x8>, where Avx512::is_there();
}
