//! Work on several threads (feature `rayon`): the output is split into parts that do not depend on
//! each other, and each task computes one part.

use crate::backend::Backend;

/// The options that all jobs have: instructions and threads.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice {
    /// The backend to compute with; the best backend if `None`.
    pub backend: Option<Backend>,
    /// The number of threads; the backend's number if `None`.
    #[cfg(feature = "rayon")]
    pub threads: Option<usize>,
}

impl Choice {
    /// Returns the backend to compute with, which holds the number of threads.
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

/// Defines the methods `backend` and `threads` inside the `impl` of a job with a field
/// `choice: Choice`. The parameter is an example for the documentation of `threads`.
#[doc(hidden)]
#[macro_export]
macro_rules! __options {
    ($(#[$example:meta])*) => {
        /// Sets the instructions to compute with; the default is the best backend of the CPU.
        pub fn backend(mut self, backend: $crate::Backend) -> Self {
            self.choice.backend = Some(backend);
            self
        }

        /// Sets the largest number of threads of rayon's current pool to run on; `usize::MAX` means
        /// all of them. Each thread computes whole instances, configurations or vertices. Every bit
        /// of the result is the same for any number of threads.
        $(#[$example])*
        #[cfg(feature = "rayon")]
        pub fn threads(mut self, threads: usize) -> Self {
            self.choice.threads = Some(threads);
            self
        }
    };
}
pub use __options as options;

/// A slice, and the number of its elements that make one *thing*, such as an instance, a
/// configuration or a vertex. Threads never share a thing.
pub type Rows<'s, E> = (&'s mut [E], usize);

/// The output of a kernel. With the feature `rayon` it can be split between two things, such as
/// instances or vertices.
#[cfg(not(feature = "rayon"))]
pub trait Outputs {}
#[cfg(not(feature = "rayon"))]
impl<O> Outputs for O {}
#[cfg(feature = "rayon")]
pub use many::Outputs;

#[cfg(not(feature = "rayon"))]
impl Backend {
    /// Calls `work` once, with all of `outputs`, because there is one thread.
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
        /// Returns the same instructions on at most `threads` threads of rayon's current pool.
        /// `usize::MAX` means all threads of the pool; 1, the default, means the calling thread.
        /// Every bit of a result is the same for any number of threads.
        ///
        /// Short slices stay on one thread, because a task must have a few microseconds of work.
        /// Chains ([`chain_products`](Self::chain_products)) and your own kernels
        /// ([`run`](Self::run)) always stay on one thread.
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

        /// `true` if threads other than the calling thread may compute.
        #[doc(hidden)]
        #[inline]
        #[must_use]
        pub fn many(self) -> bool {
            self.threads > NonZeroUsize::MIN
        }

        /// Splits `outputs` into parts of whole things, such as instances or vertices. Calls `work`
        /// on several threads, with the index of the first thing of a part, and the part. With one
        /// thread it calls `work` once, with all of `outputs`. The number of things in a part is a
        /// multiple of `grain`, except for the last part.
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
            // If the whole pool may be used, each task has only `grain` things: a thread that ends
            // early takes tasks from other threads.
            let all = self.threads.get() >= rayon::current_num_threads();
            let tasks = if all { grains } else { grains.min(self.threads.get()) };
            Part { tasks, grains, first: 0, outputs }.share(grain, work);
        }
    }

    /// A part of the outputs, from the thing with index `first` on, which `tasks` tasks will
    /// compute.
    struct Part<O> {
        tasks: usize,
        grains: usize,
        first: usize,
        outputs: O,
    }

    impl<O: Outputs> Part<O> {
        /// Computes the part if it is for one task. Otherwise splits it into two halves, which run
        /// in parallel.
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

    /// The output of a kernel, which can be split between two things, such as instances or
    /// vertices.
    pub trait Outputs: Sized + Send {
        /// Returns the number of things, such as instances.
        fn things(&self) -> usize;
        /// Splits the output into the first `at` things and the remaining things.
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

    /// A pair of outputs with the same number of things (such as instances). Both are split before
    /// the same thing.
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
