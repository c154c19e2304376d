//! Locals of any form as motions in memory: a pose of a clip or of layers that is to be changed, or
//! written down, before it goes to models.

use super::Job;
use super::locals::Locals;
use super::plan::Plans;
use super::root::NoRoot;
use super::write::Write;
use crate::storage::Element;
use crate::storage::shape::ShapeError;

impl<P: Plans> Job<'_, NoRoot, P> {
    /// Local poses as motions, of locals in any form: what a clip or layers are at a time, for
    /// inverse kinematics after animation, root motion, and export.
    /// [`locals_to_model`](Self::locals_to_model) computes models without them. With
    /// [`joints`](Self::joints), only those are written.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `poses` is untouched.
    ///
    /// ```
    /// use dq8::hierarchy::{Clip, Sampled};
    /// use dq8::{DualQuat, Skeleton, law::Nlerp};
    /// let leg = Skeleton::new(&[-1, 0])?;
    /// // Two frames of two joints, of which the second bends.
    /// let bent = DualQuat::from_rotation(dq8::Quat::from_rotation_x(1.0));
    /// let keys = [DualQuat::<f32>::IDENTITY, DualQuat::IDENTITY, DualQuat::IDENTITY, bent];
    /// let pose = Sampled::new(Nlerp, Clip::new(2, &keys)?, &[0], &[0.5])?;
    /// let mut locals = [DualQuat::IDENTITY; 2];
    /// leg.job().locals(pose, &mut locals)?;
    /// // Here `Job::two_bone` puts the foot on the ground, and then:
    /// leg.job().local_to_model_in_place(&mut locals)?;
    /// assert!((locals[1].rotation().angle_to(dq8::Quat::IDENTITY) - 0.5).abs() < 1e-6);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn locals<E: Element<8>, L: Locals<E>>(
        &self,
        locals: L,
        poses: &mut [E],
    ) -> Result<(), ShapeError> {
        self.check_locals::<E, L>(&locals, poses.len())?;
        let (run, backend) = (self.run::<E>(), self.choice.instructions());
        #[cfg(feature = "rayon")]
        if backend.many() && !run.parents.is_empty() {
            super::parallel::write(backend, &run, locals, poses);
            return Ok(());
        }
        backend.run(Write { run: &run, locals, poses });
        Ok(())
    }
}
