//! Several threads (feature `rayon`): things that do not depend on each other, some to each task.

use crate::backend::Backend;

/// The options of a job: instructions, and threads.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice {
    /// The instructions; the best if `None`.
    pub backend: Option<Backend>,
    /// The number of threads; that of the backend if `None`.
    #[cfg(feature = "rayon")]
    pub threads: Option<usize>,
}

impl Choice {
    /// The instructions and threads, as a backend.
    #[inline]
    pub fn instructions(self) -> Backend {
        let backend = self.backend.unwrap_or_default();
        #[cfg(feature = "rayon")]
        if let Some(threads) = self.threads {
            return backend.threads(threads);
        }
        backend
    }
}

/// The options of a job that hold a [`Choice`], for its `impl`; and what the documentation of
/// `threads` shows besides.
#[doc(hidden)]
#[macro_export]
macro_rules! __options {
    ($(#[$example:meta])*) => {
        /// Runs with these instructions; by default with the best that the CPU has.
        pub fn backend(mut self, backend: $crate::Backend) -> Self {
            self.choice.backend = Some(backend);
            self
        }

        /// Runs on at most so many threads of rayon's current pool, whole instances, configurations
        /// or vertices to each; `usize::MAX` for all of them. Every bit of the result is the same
        /// for any number of threads.
        $(#[$example])*
        #[cfg(feature = "rayon")]
        pub fn threads(mut self, threads: usize) -> Self {
            self.choice.threads = Some(threads);
            self
        }
    };
}
pub use __options as options;

/// A slice, and how many elements a thing has.
pub type Rows<'s, E> = (&'s mut [E], usize);

/// The output of a kernel; with the feature `rayon`, cut at a thing.
#[cfg(not(feature = "rayon"))]
pub trait Outputs {}
#[cfg(not(feature = "rayon"))]
impl<O> Outputs for O {}
#[cfg(feature = "rayon")]
pub use many::Outputs;

#[cfg(not(feature = "rayon"))]
impl Backend {
    /// Calls `work` with all of `outputs`.
    #[doc(hidden)]
    #[inline]
    pub fn share<O: Outputs>(self, _grain: usize, outputs: O, work: &impl Fn(usize, O)) {
        work(0, outputs);
    }
}

#[cfg(feature = "rayon")]
mod many {
    use super::{Backend, Rows};
    use core::num::NonZeroUsize;

    impl Backend {
        /// The same instructions on at most so many threads of rayon's current pool; `usize::MAX`
        /// for all of them, and 1, which is the default, for the one that calls. Every bit of a
        /// result is the same for any number of threads.
        ///
        /// Short slices stay on one thread: a task has a few microseconds of work. Chains
        /// ([`chain_products`](Self::chain_products)) and kernels of your own ([`run`](Self::run))
        /// do so always.
        ///
        /// ```
        /// use dq8::{Backend, DualQuat};
        /// let step = vec![DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 100_000];
        /// let mut two = step.clone();
        /// Backend::best().threads(usize::MAX).mul(&step, &step, &mut two)?;
        /// assert_eq!(two[99_999].translation(), [2.0, 0.0, 0.0]);
        /// # Ok::<(), dq8::ShapeError>(())
        /// ```
        pub fn threads(mut self, threads: usize) -> Self {
            self.threads = NonZeroUsize::new(threads).unwrap_or(NonZeroUsize::MIN);
            self
        }

        /// `true` if there may be more threads than the one that calls.
        #[doc(hidden)]
        #[inline]
        #[must_use]
        pub fn many(self) -> bool {
            self.threads > NonZeroUsize::MIN
        }

        /// Calls `work` with parts of `outputs` and the number of the first thing in each, on the
        /// threads; on one, with all of them. A part has a multiple of `grain` things, but for the
        /// last.
        #[doc(hidden)]
        pub fn share<O: Outputs>(
            self,
            grain: usize,
            outputs: O,
            work: &(impl Fn(usize, O) + Sync),
        ) {
            if !self.many() {
                return work(0, outputs);
            }
            let grains = outputs.things().div_ceil(grain.max(1));
            // Where no thread of the pool may be left out, those that are done sooner take from the
            // others.
            let all = self.threads.get() >= rayon::current_num_threads();
            let tasks = if all { grains } else { grains.min(self.threads.get()) };
            Part { tasks, grains, first: 0, outputs }.share(grain, work);
        }
    }

    /// Outputs from thing `first` on, for so many tasks.
    struct Part<O> {
        tasks: usize,
        grains: usize,
        first: usize,
        outputs: O,
    }

    impl<O: Outputs> Part<O> {
        /// One task computes; more are two halves, side by side.
        fn share(self, grain: usize, work: &(impl Fn(usize, O) + Sync)) {
            let Self { tasks, grains, first, outputs } = self;
            if tasks < 2 {
                return work(first, outputs);
            }
            let left = grains * (tasks / 2) / tasks;
            let at = left * grain;
            let (begin, end) = outputs.split(at);
            let begin = Part { tasks: tasks / 2, grains: left, first, outputs: begin };
            let end = Part {
                tasks: tasks - tasks / 2,
                grains: grains - left,
                first: first + at,
                outputs: end,
            };
            rayon::join(|| begin.share(grain, work), || end.share(grain, work));
        }
    }

    /// The output of a kernel, cut at a thing.
    pub trait Outputs: Sized + Send {
        /// The number of things.
        fn things(&self) -> usize;
        /// Cuts them into those before number `at`, and the others.
        fn split(self, at: usize) -> (Self, Self);
    }

    impl<E: Send> Outputs for Rows<'_, E> {
        fn things(&self) -> usize {
            self.0.len().checked_div(self.1).unwrap_or(0)
        }
        fn split(self, at: usize) -> (Self, Self) {
            let (slice, each) = self;
            let (begin, end) = slice.split_at_mut((at * each).min(slice.len()));
            ((begin, each), (end, each))
        }
    }

    /// Two, of as many things.
    impl<A: Outputs, B: Outputs> Outputs for (A, B) {
        fn things(&self) -> usize {
            self.0.things()
        }
        fn split(self, at: usize) -> (Self, Self) {
            let ((a, c), (b, d)) = (self.0.split(at), self.1.split(at));
            ((a, b), (c, d))
        }
    }
}
