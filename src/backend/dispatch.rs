//! [`Backend`], the set of CPU instructions to compute with, and [`Kernel`], a computation written
//! for any such set. This file is the only place that chooses instructions.

use core::fmt;
#[cfg(feature = "reproducible")]
use core::sync::atomic::AtomicBool;
use core::sync::atomic::{AtomicU8, Ordering};
#[cfg(all(
    feature = "reproducible",
    any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "fma")
))]
use dq8_simd::Unfused;
#[cfg(target_arch = "x86_64")]
use dq8_simd::x86_64::{Avx2, Avx512};
use dq8_simd::{Level, Portable};

/// A computation that is written once for all instruction sets. [`Backend::run`] runs it. The
/// compiler makes one version of it for each instruction set.
///
/// Every function and closure that `run` calls must be `#[inline(always)]`. A function that the
/// compiler does not inline is compiled without the instructions of the level: there every lane
/// operation becomes a call, 10 to 45 times slower. [The guide](crate::guide::kernel) lists what
/// this rule forbids, and how to notice a broken one.
///
/// A kernel of your own, for motions in any layout and of any precision:
///
/// ```
/// use dq8::batch;
/// use dq8::storage::{self, Element};
/// use dq8::{Backend, DualQuat, Kernel, Level};
///
/// /// motions[i] ← √motions[i], half of each screw motion.
/// struct HalfWay<'s, E>(&'s mut [E]);
///
/// impl<E: Element<8>> Kernel for HalfWay<'_, E> {
///     type Output = ();
///     #[inline(always)]
///     fn run<V: Level>(self, level: V) {
///         for tile in storage::tiles::<E, V, 8>(self.0.len()) {
///             let padding = storage::identity();
///             let Some(lanes) = E::load(level, self.0, tile, &padding) else { return };
///             let half = batch::DualQuat::from_array(lanes).sqrt();
///             E::store(half.to_array(), self.0, tile);
///         }
///     }
/// }
///
/// let mut steps = [DualQuat::from_translation([4.0_f32, 0.0, 0.0]); 11];
/// Backend::best().run(HalfWay(&mut steps));
/// assert_eq!(steps[10].translation(), [2.0, 0.0, 0.0]);
/// ```
pub trait Kernel {
    /// The result of the computation.
    type Output;
    /// `true` if the kernel is faster with AVX-512 than with AVX2. If `false`, the AVX2 version
    /// runs on CPUs with AVX-512 too, and no AVX-512 version is compiled.
    const WIDE: bool = true;
    /// `true` if most instructions of the kernel are shuffles, as in transposes of plain arrays.
    /// Such a kernel runs with AVX-512 only on a CPU that shuffles 512 bits as quickly as 256 bits:
    /// AMD's CPUs do, Intel's do not.
    const SHUFFLES: bool = false;
    /// Computes with the lanes of `level`. Must be `#[inline(always)]`.
    fn run<V: Level>(self, level: V) -> Self::Output;
}

/// A set of instructions that this CPU has. A value of this type is the proof that the CPU has
/// them, so a program asks the CPU once, when it takes the [`best`](Self::best) backend, and never
/// again.
///
/// Jobs use the best backend unless they are given another one. The kernels over slices
/// ([`slices`](crate::slices)) are methods of the backend itself. With the feature `rayon` a
/// backend also holds a number of `threads`.
///
/// ```
/// use dq8::Backend;
/// assert!(Backend::available().any(|backend| backend == Backend::best()));
/// assert_eq!(Backend::PORTABLE.to_string(), "portable");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[must_use]
pub struct Backend {
    proof: Proof,
    #[cfg(feature = "rayon")]
    pub(crate) threads: core::num::NonZeroUsize,
}

/// The proof that the CPU has a set of instructions, in rising order. The proof of AVX-512 contains
/// the proof of AVX2, because some kernels run with AVX2 on a CPU with AVX-512 too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum Proof {
    Portable,
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512, Avx2),
    /// Exists only for targets whose portable lanes fuse multiplication and addition.
    #[cfg(all(feature = "reproducible", any(target_arch = "aarch64", target_feature = "fma")))]
    UnfusedPortable,
    #[cfg(all(feature = "reproducible", target_arch = "x86_64"))]
    UnfusedAvx2(Avx2),
    #[cfg(all(feature = "reproducible", target_arch = "x86_64"))]
    UnfusedAvx512(Avx512, Avx2),
}

/// The highest index, among the available backends, that [`Backend::best`] may choose.
static LIMIT: AtomicU8 = AtomicU8::new(u8::MAX);

/// `true` if [`Backend::best`] must be [reproducible](Backend::reproducible).
#[cfg(feature = "reproducible")]
static UNFUSED: AtomicBool = AtomicBool::new(false);

impl Backend {
    /// The instructions of the build target: SSE2 in a default x86-64 build, NEON on aarch64,
    /// simd128 on wasm. This backend fuses multiplication and addition on aarch64 and in builds
    /// with `fma`, and nowhere else, so the last bits of its results differ between machines.
    pub const PORTABLE: Self = Self::of(Proof::Portable);

    /// Makes the backend that computes on the calling thread alone.
    #[inline]
    const fn of(proof: Proof) -> Self {
        Self {
            proof,
            #[cfg(feature = "rayon")]
            threads: core::num::NonZeroUsize::MIN,
        }
    }

    /// x86-64 with AVX2 and FMA: 8 lanes of `f32`, 4 lanes of `f64`. `None` if the CPU lacks them.
    #[inline]
    #[must_use]
    pub fn avx2() -> Option<Self> {
        #[cfg(target_arch = "x86_64")]
        return Avx2::detect().map(|level| Self::of(Proof::Avx2(level)));
        #[cfg(not(target_arch = "x86_64"))]
        return None;
    }

    /// x86-64 with AVX-512 F, VL and DQ: 16 lanes of `f32`, 8 lanes of `f64`. `None` if the CPU
    /// lacks them.
    #[inline]
    #[must_use]
    pub fn avx512() -> Option<Self> {
        #[cfg(target_arch = "x86_64")]
        return Some(Self::of(Proof::Avx512(Avx512::detect()?, Avx2::detect()?)));
        #[cfg(not(target_arch = "x86_64"))]
        return None;
    }

    /// The fastest instructions of this CPU without a fused multiply-add. Results have the same
    /// bits on every machine, and take 1.0 to 1.5 times as long as with the [`best`](Self::best)
    /// backend. [The guide](crate::guide::reproducible) lists the operations that this promise
    /// covers.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, Quat};
    /// let step = DualQuat::from_rotation(Quat::from_rotation_z(0.1_f32));
    /// let mut links = [step; 100];
    /// Backend::reproducible().chain_products_in_place(&mut links);
    /// let bits = links[99].rotation().to_array().map(f32::to_bits);
    /// assert_eq!(bits, [0, 0, 0xbf75_7c15, 0x3e91_3c18]);
    /// ```
    #[cfg(feature = "reproducible")]
    pub fn reproducible() -> Self {
        Self::available().last().unwrap_or(Self::PORTABLE).unfused()
    }

    /// `true` if this backend fuses no multiply-add: then its results have the same bits on every
    /// machine.
    #[cfg(feature = "reproducible")]
    #[must_use]
    pub fn is_reproducible(self) -> bool {
        self == self.unfused()
    }

    /// This backend without its fused instructions. Tests use it to compare the bits of all levels
    /// of one CPU.
    #[cfg(feature = "reproducible")]
    #[doc(hidden)]
    #[inline]
    pub fn unfused(self) -> Self {
        let proof = match self.proof {
            #[cfg(any(target_arch = "aarch64", target_feature = "fma"))]
            Proof::Portable => Proof::UnfusedPortable,
            #[cfg(target_arch = "x86_64")]
            Proof::Avx2(level) => Proof::UnfusedAvx2(level),
            #[cfg(target_arch = "x86_64")]
            Proof::Avx512(level, narrow) => Proof::UnfusedAvx512(level, narrow),
            unfused => unfused,
        };
        Self { proof, ..self }
    }

    /// The backends that this CPU has, in rising order.
    pub fn available() -> impl Iterator<Item = Self> {
        [Some(Self::PORTABLE), Self::avx2(), Self::avx512()].into_iter().flatten()
    }

    /// The best backend that this CPU has. Detection runs once; later calls take three loads.
    #[inline]
    pub fn best() -> Self {
        let mut best = Self::PORTABLE;
        let limit = LIMIT.load(Ordering::Relaxed);
        for better in [Self::avx2(), Self::avx512()].into_iter().take(limit.into()).flatten() {
            best = better;
        }
        #[cfg(feature = "reproducible")]
        if UNFUSED.load(Ordering::Relaxed) {
            return best.unfused();
        }
        best
    }

    /// Sets, for all threads, whether [`best`](Self::best) returns the
    /// [reproducible](Self::reproducible) backend from now on. C and Python call this because their
    /// functions take no backend.
    #[cfg(feature = "reproducible")]
    #[doc(hidden)]
    pub fn set_reproducible(reproducible: bool) {
        UNFUSED.store(reproducible, Ordering::Relaxed);
    }

    /// Sets, for all threads, the highest backend that [`best`](Self::best) returns from now on;
    /// `None` removes the limit. The C interface calls this because its functions take no backend.
    #[doc(hidden)]
    pub fn limit(limit: Option<Self>) {
        let limit = match limit.map(|backend| backend.proof) {
            Some(Proof::Portable) => 0,
            #[cfg(target_arch = "x86_64")]
            Some(Proof::Avx2(_)) => 1,
            _ => u8::MAX,
        };
        LIMIT.store(limit, Ordering::Relaxed);
    }

    /// Runs `kernel` with these instructions on the calling thread.
    ///
    /// (The closures in this method must be inlined as well. Otherwise the compiler makes a
    /// function of a large closure and compiles it without the instructions of the level, which is
    /// 35 times slower.)
    #[inline]
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self.proof {
            Proof::Portable => Portable.run(
                #[inline(always)]
                || kernel.run(Portable),
            ),
            #[cfg(target_arch = "x86_64")]
            Proof::Avx512(level, _)
                if const { K::WIDE } && (!K::SHUFFLES || level.shuffles_wide()) =>
            {
                level.run(
                    #[inline(always)]
                    || kernel.run(level),
                )
            }
            #[cfg(target_arch = "x86_64")]
            Proof::Avx2(level) | Proof::Avx512(_, level) => level.run(
                #[inline(always)]
                || kernel.run(level),
            ),
            #[cfg(all(
                feature = "reproducible",
                any(target_arch = "aarch64", target_feature = "fma")
            ))]
            Proof::UnfusedPortable => kernel.run(Unfused(Portable)),
            #[cfg(all(feature = "reproducible", target_arch = "x86_64"))]
            Proof::UnfusedAvx512(level, _)
                if const { K::WIDE } && (!K::SHUFFLES || level.shuffles_wide()) =>
            {
                level.run(
                    #[inline(always)]
                    || kernel.run(Unfused(level)),
                )
            }
            #[cfg(all(feature = "reproducible", target_arch = "x86_64"))]
            Proof::UnfusedAvx2(level) | Proof::UnfusedAvx512(_, level) => level.run(
                #[inline(always)]
                || kernel.run(Unfused(level)),
            ),
        }
    }
}

impl Default for Backend {
    /// Returns the [`best`](Self::best) backend.
    fn default() -> Self {
        Self::best()
    }
}

impl Backend {
    fn name(self) -> &'static str {
        match self.proof {
            Proof::Portable => "portable",
            #[cfg(target_arch = "x86_64")]
            Proof::Avx2(_) => "AVX2",
            #[cfg(target_arch = "x86_64")]
            Proof::Avx512(..) => "AVX-512",
            #[cfg(all(
                feature = "reproducible",
                any(target_arch = "aarch64", target_feature = "fma")
            ))]
            Proof::UnfusedPortable => "portable, unfused",
            #[cfg(all(feature = "reproducible", target_arch = "x86_64"))]
            Proof::UnfusedAvx2(_) => "AVX2, unfused",
            #[cfg(all(feature = "reproducible", target_arch = "x86_64"))]
            Proof::UnfusedAvx512(..) => "AVX-512, unfused",
        }
    }
}

impl fmt::Display for Backend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Writes the name of the backend, and the number of its threads if there are several.
impl fmt::Debug for Backend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut tuple = f.debug_tuple("Backend");
        tuple.field(&format_args!("{self}"));
        #[cfg(feature = "rayon")]
        if self.threads.get() > 1 {
            tuple.field(&format_args!("{} threads", self.threads));
        }
        tuple.finish()
    }
}

/// The error for a name that no backend has, or for a backend whose instructions this CPU lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct UnavailableBackend;

impl fmt::Display for UnavailableBackend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no such backend here; this CPU has ")?;
        let mut available = Backend::available().enumerate();
        available.try_for_each(|(index, backend)| {
            write!(f, "{}{backend}", if index == 0 { "" } else { ", " })
        })
    }
}

impl core::error::Error for UnavailableBackend {}

/// Finds a backend of this CPU by its name. Case and hyphens do not matter: "avx2", "AVX2",
/// "avx512" and "AVX-512" are understood.
impl core::str::FromStr for Backend {
    type Err = UnavailableBackend;

    fn from_str(name: &str) -> Result<Self, UnavailableBackend> {
        fn letters(name: &str) -> impl Iterator<Item = u8> + '_ {
            name.bytes().filter(|&byte| byte != b'-').map(|byte| byte.to_ascii_lowercase())
        }
        let named = |backend: &Self| letters(backend.name()).eq(letters(name));
        Self::available().find(named).ok_or(UnavailableBackend)
    }
}
