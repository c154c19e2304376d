use super::Job;
use super::backward::Backward;
use super::plan::Plans;
use super::root::Roots;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Source};

impl<S, P: Plans> Job<'_, S, P> {
    /// Local poses of all joints from model ones: local(j) = model(parent(j))* · model(j). The
    /// models must be unit. With [`joints`](Self::joints), only those locals are written.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `locals` is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let pair = Hierarchy::new(&parents)?;
    /// let models = [1.0_f32, 3.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let mut locals = models;
    /// pair.job().model_to_local(&models, &mut locals)?;
    /// assert_eq!(locals[1].translation(), [2.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn model_to_local<E: Element<8>>(
        &self,
        models: &[E],
        locals: &mut [E],
    ) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        self.check::<E>("models", models.len())?;
        same_length("locals", locals.len(), models.len())?;
        self.backward(Source::Slice(models), locals);
        Ok(())
    }

    /// [`model_to_local`](Self::model_to_local) over the models themselves.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `poses` is untouched.
    #[inline]
    pub fn model_to_local_in_place<E: Element<8>>(&self, poses: &mut [E]) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        self.check::<E>("poses", poses.len())?;
        self.backward(Source::Output, poses);
        Ok(())
    }

    #[inline]
    fn backward<E: Element<8>>(&self, models: Source<'_, E>, locals: &mut [E])
    where
        S: Roots<E>,
    {
        let (run, backend) = (self.run::<E>(), self.choice.instructions());
        #[cfg(feature = "rayon")]
        if backend.many() && !run.parents.is_empty() {
            return super::parallel::backward(backend, &run, models, locals);
        }
        backend.run(Backward { run: &run, models, locals });
    }
}
