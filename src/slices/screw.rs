use super::map::{OfEach, OfPairs, operations};
use super::sweep::{SliceKernel, Things, motions, part, sweep};
use crate::backend::Backend;
use crate::batch::DualQuat;
use crate::geometry::{DualVector, Twist};
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Number, Register, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `logs[i]` = log σᵢ of unit motions, (θ̂/2)(l + εm): six numbers, a and then b of a +
    /// εb; see [`DualQuat::log`](crate::DualQuat::log). Twice that is the twist that leads to
    /// σᵢ in one second.
    ///
    /// # Errors
    /// If the slices differ in length; `logs` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let steps = [DualQuat::from_translation([2.0_f32, 4.0, 6.0]); 5];
    /// let (mut logs, mut back) = ([[0.0; 6]; 5], [DualQuat::ZERO; 5]);
    /// Backend::best().log(&steps, &mut logs)?;
    /// assert_eq!(logs[4], [0.0, 0.0, 0.0, 1.0, 2.0, 3.0]);
    /// Backend::best().exp(&logs, &mut back)?;
    /// assert_eq!(back, steps);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn log<M: Element<8>, P: Element<6, Layout = M::Layout>>(
        self,
        motions: &[M],
        logs: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("logs", logs.len(), motions.len())?;
        sweep(self, logs, OfEach { a: motions, operation: Log });
        Ok(())
    }

    /// `motions[i]` = exp(a + εb) of the six numbers of `logs[i]`; see
    /// [`DualQuat::exp`](crate::DualQuat::exp).
    ///
    /// # Errors
    /// If the slices differ in length; `motions` is untouched.
    #[inline]
    pub fn exp<P: Element<6>, M: Element<8, Layout = P::Layout>>(
        self,
        logs: &[P],
        motions: &mut [M],
    ) -> Result<(), ShapeError> {
        same_length("motions", motions.len(), logs.len())?;
        sweep(self, motions, OfEach { a: logs, operation: Exp });
        Ok(())
    }

    /// `twists[i]` = 2 log σᵢ of unit motions: the twist that leads to σᵢ in one second,
    /// angular part first; see [`DualQuat::to_twist`](crate::DualQuat::to_twist).
    ///
    /// # Errors
    /// If the slices differ in length; `twists` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, Twist};
    /// let steps = [DualQuat::from_translation([2.0_f32, 4.0, 6.0]); 5];
    /// let (mut twists, mut back) = ([Twist::from_array([0.0; 6]); 5], [DualQuat::ZERO; 5]);
    /// Backend::best().to_twist(&steps, &mut twists)?;
    /// assert_eq!(twists[4].linear, [2.0, 4.0, 6.0]);
    /// Backend::best().from_twist(&twists, &mut back)?;
    /// assert_eq!(back, steps);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn to_twist<M: Element<8>, P: Element<6, Layout = M::Layout>>(
        self,
        motions: &[M],
        twists: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("twists", twists.len(), motions.len())?;
        sweep(self, twists, OfEach { a: motions, operation: ToTwist });
        Ok(())
    }

    /// `motions[i]` = exp(½ξᵢ): where the twist ξᵢ leads in one second; see
    /// [`DualQuat::from_twist`](crate::DualQuat::from_twist).
    ///
    /// # Errors
    /// If the slices differ in length; `motions` is untouched.
    #[inline]
    pub fn from_twist<P: Element<6>, M: Element<8, Layout = P::Layout>>(
        self,
        twists: &[P],
        motions: &mut [M],
    ) -> Result<(), ShapeError> {
        same_length("motions", motions.len(), twists.len())?;
        sweep(self, motions, OfEach { a: twists, operation: FromTwist });
        Ok(())
    }

    /// `powers[i]` = σᵢᵗ of unit motions, with a t each; see
    /// [`DualQuat::pow`](crate::DualQuat::pow).
    ///
    /// # Errors
    /// If the slices differ in length; `powers` is untouched.
    #[inline]
    pub fn pow_each<E: Element<8>, T: Element<1, Layout = E::Layout>>(
        self,
        motions: &[E],
        t: &[T],
        powers: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("t", t.len(), motions.len())?;
        same_length("powers", powers.len(), motions.len())?;
        sweep(self, powers, OfPairs { a: motions, b: t, operation: Power });
        Ok(())
    }

    /// `later[i]` = σᵢ exp(½ξᵢ dt): where unit σᵢ is after `dt` seconds of the body twist
    /// ξᵢ; see [`DualQuat::integrate_body`](crate::DualQuat::integrate_body).
    ///
    /// # Errors
    /// If the slices differ in length; `later` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, Twist};
    /// let poses = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 3];
    /// let twists = [Twist { angular: [0.0; 3], linear: [0.0, 2.0, 0.0] }; 3];
    /// let mut later = poses;
    /// Backend::best().integrate_body(&poses, &twists, 0.5, &mut later)?;
    /// assert_eq!(later[2].translation(), [1.0, 1.0, 0.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn integrate_body<E: Element<8>, P: Element<6, Layout = E::Layout>>(
        self,
        motions: &[E],
        twists: &[P],
        dt: Number<E, 8>,
        later: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("twists", twists.len(), motions.len())?;
        same_length("later", later.len(), motions.len())?;
        sweep(self, later, Integrate { motions, twists, dt });
        Ok(())
    }
}

operations! {
    Log(motion: 8) -> 6 = {
        let log = DualQuat::from_array(motion).log();
        let ([a, b, c], [d, e, f]) = (log.real, log.dual);
        [a, b, c, d, e, f]
    };
    Exp(log: 6) -> 8 = {
        let [a, b, c, d, e, f] = log;
        DualQuat::exp(DualVector { real: [a, b, c], dual: [d, e, f] }).to_array()
    };
    ToTwist(motion: 8) -> 6 = DualQuat::from_array(motion).to_twist().to_array();
    FromTwist(twist: 6) -> 8 = DualQuat::from_twist(Twist::from_array(twist)).to_array();
}

operations! {
    Power(motion: 8, t: 1) -> 8 = DualQuat::from_array(motion).pow(t[0]).to_array();
}

struct Integrate<'s, E: Element<8>, P> {
    motions: &'s [E],
    twists: &'s [P],
    dt: Number<E, 8>,
}

impl<E: Element<8>, P: Element<6, Layout = E::Layout>> SliceKernel<E, 8> for Integrate<'_, E, P> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[E], tile: Tile) -> Things<E, V, 8> {
        let twist = P::load(level, self.twists, tile, &storage::identity())?;
        let dt = Register::<E, V, 8>::splat(level, self.dt);
        let motion = motions(level, self.motions, tile)?;
        Some(motion.integrate_body(Twist::from_array(twist), dt).to_array())
    }
    fn part(&self, elements: Range<usize>) -> Self {
        let twists = part(self.twists, elements.clone());
        Self { motions: part(self.motions, elements), twists, dt: self.dt }
    }
}
