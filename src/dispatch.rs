//! [`Backend`]: which instructions compute. The only place that chooses.

use core::fmt;
use core::sync::atomic::{AtomicU8, Ordering};
use dq8_simd::{Level, Portable};

/// A set of instructions that the kernels over memory (hierarchies, slices) are compiled for.
///
/// Hierarchies choose the [`best`](Self::best) at run time, once a call, unless a
/// [`Job`](crate::Job) names another; the kernels over slices ([`slices`](crate::slices)) are methods
/// of the backend itself. A backend that the CPU lacks does its work with the best below it.
/// [`limit`](Self::limit) makes all of them do with less, so that tests can walk every path.
///
/// ```
/// use dq8::Backend;
/// assert!(Backend::Portable.is_available());
/// assert!(Backend::available().any(|backend| backend == Backend::best()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Backend {
    /// What the build target has: SSE2 on a default x86-64 build, NEON on aarch64, simd128 on wasm.
    Portable,
    /// x86-64 with AVX2 and FMA: 8 × `f32`, 4 × `f64`.
    Avx2,
    /// x86-64 with AVX-512 F, VL and DQ: 16 × `f32`, 8 × `f64`.
    Avx512,
}

/// A computation for any level. `run` must be `#[inline(always)]`: each level compiles it anew.
pub(crate) trait Kernel {
    type Output;
    fn run<V: Level>(self, level: V) -> Self::Output;
}

/// The best backend that may be used, as its discriminant.
static LIMIT: AtomicU8 = AtomicU8::new(u8::MAX);

impl Backend {
    const ALL: [Self; 3] = [Self::Portable, Self::Avx2, Self::Avx512];
    /// No limit: what the CPU lacks is passed over.
    pub(crate) const MOST: Self = Self::Avx512;

    /// The backends that this CPU has, in rising order, whatever the limit.
    pub fn available() -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(|backend| backend.is_available())
    }

    /// Whether this CPU has the instructions.
    #[inline]
    #[must_use]
    pub fn is_available(self) -> bool {
        match self {
            Self::Portable => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => dq8_simd::x86_64::Avx2::detect().is_some(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => dq8_simd::x86_64::Avx512::detect().is_some(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// The best backend that the CPU has and the [`limit`](Self::limit) allows. Detection happens
    /// once; afterwards this is two loads.
    #[inline]
    #[must_use]
    pub fn best() -> Self {
        let limit = LIMIT.load(Ordering::Relaxed);
        let mut best = Self::Portable;
        for backend in Self::ALL {
            if backend as u8 <= limit && backend.is_available() {
                best = backend;
            }
        }
        best
    }

    /// Pretends a lesser CPU: from now on, in all threads, no better backend than `most` is used.
    /// `None` takes the limit away.
    pub fn limit(most: Option<Self>) {
        LIMIT.store(most.map_or(u8::MAX, |backend| backend as u8), Ordering::Relaxed);
    }

    /// Runs `kernel` with this backend, or the best below it that the CPU has and the
    /// [`limit`](Self::limit) allows.
    ///
    /// The closures must be inlined as well: left to itself, the compiler keeps a large one apart,
    /// without the instructions of its level, and every lane operation becomes a call: 35 times slower.
    #[inline]
    pub(crate) fn run<K: Kernel>(self, kernel: K) -> K::Output {
        #[cfg(target_arch = "x86_64")]
        {
            use dq8_simd::x86_64::{Avx2, Avx512};
            let most = LIMIT.load(Ordering::Relaxed).min(self as u8);
            if most >= Self::Avx512 as u8
                && let Some(level) = Avx512::detect()
            {
                return level.run(
                    #[inline(always)]
                    || kernel.run(level),
                );
            }
            if most >= Self::Avx2 as u8
                && let Some(level) = Avx2::detect()
            {
                return level.run(
                    #[inline(always)]
                    || kernel.run(level),
                );
            }
        }
        Portable.run(|| kernel.run(Portable))
    }
}

impl fmt::Display for Backend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Portable => "portable",
            Self::Avx2 => "AVX2",
            Self::Avx512 => "AVX-512",
        })
    }
}
