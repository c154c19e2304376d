//! How instances lie in memory: as plain slices, or in blocks of a width. One generic test runs on
//! all of them.

use bytemuck::Pod;
use core::fmt::Debug;
use dq8::{Backend, Block, DualQuat, Float, Pose, Real, pack, unpack};
use dq8_simd::Row;
use std::sync::{Mutex, MutexGuard, PoisonError};

pub(crate) trait Layout: Pose + Pod + Debug {
    /// `[instance][joint]` as this layout keeps it.
    fn lay(joints: usize, poses: &[DualQuat<Self::Real>]) -> Vec<Self>;
    /// Back to `[instance][joint]`; what pads the last block is dropped.
    fn flat(joints: usize, instances: usize, elements: &[Self]) -> Vec<DualQuat<Self::Real>>;
    /// `value` in every component of every lane.
    fn filled(value: f64) -> Self;
    /// The components in one lane.
    fn record(&self, lane: usize) -> [f64; 8];
}

impl<R: Real + Float> Layout for DualQuat<R> {
    fn lay(_: usize, poses: &[Self]) -> Vec<Self> {
        poses.to_vec()
    }
    fn flat(_: usize, _: usize, elements: &[Self]) -> Vec<Self> {
        elements.to_vec()
    }
    fn filled(value: f64) -> Self {
        Self::from_array([<R as Real>::from_f64(value); 8])
    }
    fn record(&self, _: usize) -> [f64; 8] {
        self.to_array().map(Into::into)
    }
}

impl<R: Real, const N: usize> Layout for Block<R, N>
where
    [R; N]: Row<Real = R>,
{
    fn lay(joints: usize, poses: &[DualQuat<R>]) -> Vec<Self> {
        let instances = poses.len().checked_div(joints).unwrap_or(0);
        let mut blocks = vec![Self::filled(f64::NAN); instances.div_ceil(N) * joints];
        pack(joints, poses, &mut blocks).unwrap();
        blocks
    }
    fn flat(joints: usize, instances: usize, elements: &[Self]) -> Vec<DualQuat<R>> {
        let mut poses = vec![DualQuat::ZERO; instances * joints];
        unpack(joints, elements, &mut poses).unwrap();
        poses
    }
    fn filled(value: f64) -> Self {
        Self::splat([R::from_f64(value); 8])
    }
    fn record(&self, lane: usize) -> [f64; 8] {
        self.get(lane).unwrap().map(Into::into)
    }
}

/// To compare to the bit: NaN equals itself here, and 0 differs from −0.
pub(crate) fn bits<P: Pod>(elements: &[P]) -> &[u8] {
    bytemuck::cast_slice(elements)
}

/// While it lives, hierarchies are computed with `backend`. The limit is one for the whole process, so
/// only one test may hold it at a time, and all that compute must: two runs on different backends differ
/// in the last bits.
pub(crate) fn on(backend: Backend) -> impl Drop {
    struct Limit {
        _lock: MutexGuard<'static, ()>,
    }
    impl Drop for Limit {
        fn drop(&mut self) {
            Backend::limit(None);
        }
    }
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    // A test that failed while it held the lock has said so itself.
    let _lock = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    Backend::limit(Some(backend));
    assert_eq!(Backend::best(), backend, "this CPU has it");
    Limit { _lock }
}

/// Calls `$check` with every layout there is, on every backend of this CPU.
macro_rules! for_every_layout {
    ($check:ident $arguments:tt) => {{
        for backend in dq8::Backend::available() {
            let _limit = $crate::layout::on(backend);
            $crate::layout::for_every_layout! { @each $check $arguments
                dq8::DualQuat<f32>, dq8::DualQuat<f64>,
                dq8::Block<f32, 4>, dq8::Block<f32, 8>, dq8::Block<f32, 16>,
                dq8::Block<f64, 2>, dq8::Block<f64, 4>, dq8::Block<f64, 8>
            }
        }
    }};
    (@each $check:ident $arguments:tt $($layout:ty),*) => {
        { $($check::<$layout> $arguments;)* }
    };
}
pub(crate) use for_every_layout;
