use super::job::same_length;
use super::packing::whole_instances;
use super::{Hierarchy, Pose};
use crate::dispatch::{Backend, Kernel};
use crate::error::ShapeError;
use crate::geometry::Twist;
use crate::motion::Motion;
use dq8_simd::Level;

impl Hierarchy<'_> {
    /// Spatial twists of all joints from the rates of the joints:
    /// twist(j) = twist(parent(j)) + Ad_{model(j)} rate(j).
    ///
    /// `models` are model poses, unit; `rates` body twists of each joint relative to its parent, in
    /// the joint's own frame (for a joint of one degree of freedom, its axis times its rate);
    /// `twists` come out in the frame that the models are in, about its origin
    /// ([`Twist::velocity_at`] gives the velocity of a point). All hold one element a joint, or several
    /// whole instances one after the other.
    ///
    /// # Errors
    /// If the slices differ in length or hold no whole number of instances; `twists` is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, Twist};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let arm = Hierarchy::new(&parents)?;
    /// // Two hinges about z, at x = 0 and at x = 2, turning against each other.
    /// let models = [0.0_f32, 2.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let rates = [1.0, -1.0].map(|z| Twist { angular: [0.0, 0.0, z], linear: [0.0; 3] });
    /// let mut twists = rates;
    /// arm.velocities(&models, &rates, &mut twists)?;
    /// // The forearm does not turn, it moves in a circle.
    /// assert_eq!(twists[1], Twist { angular: [0.0; 3], linear: [0.0, 2.0, 0.0] });
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn velocities<P: Pose>(
        &self,
        models: &[P],
        rates: &[P::Twist],
        twists: &mut [P::Twist],
    ) -> Result<(), ShapeError> {
        whole_instances("models", self.joints(), models.len())?;
        same_length("rates", rates.len(), models.len())?;
        same_length("twists", twists.len(), models.len())?;
        Backend::MOST.run(Velocities { parents: self.parents(), models, rates, twists });
        Ok(())
    }

    /// The spatial Jacobian of joint `effector`: column j is the screw of joint j in the frame that
    /// the models are in, Ad_{model(j)} axis(j), for the effector and its ancestors, and zero for all
    /// other joints. The effector's spatial twist is Σ q̇ⱼ column(j).
    ///
    /// `axes` holds the screw of each joint in its own frame, the same for all instances: the body
    /// twist for a rate of 1 ((axis, 0) for a hinge, (0, axis) for a slide, both for a screw).
    /// `models` and `columns` hold one element a joint, or several whole instances one after the
    /// other.
    ///
    /// The *geometric* Jacobian of robotics, with ṗ of a point p of the effector, has the same angular
    /// rows and [`column.velocity_at(p)`](Twist::velocity_at) for the linear ones.
    ///
    /// # Errors
    /// If lengths do not fit or there is no joint `effector`; `columns` is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, Twist};
    /// let parents = [Hierarchy::ROOT, 0, 0];
    /// let fork = Hierarchy::new(&parents)?;
    /// let models = [0.0_f32, 2.0, 3.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let hinge = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
    /// let mut columns = [hinge; 3];
    /// fork.jacobian(&models, &[hinge; 3], 1, &mut columns)?;
    /// assert_eq!(columns[0].to_array(), [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    /// assert_eq!(columns[1].to_array(), [0.0, 0.0, 1.0, 0.0, -2.0, 0.0]);
    /// assert_eq!(columns[2].to_array(), [0.0; 6]); // the other branch
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn jacobian<P: Pose>(
        &self,
        models: &[P],
        axes: &[Twist<P::Real>],
        effector: usize,
        columns: &mut [P::Twist],
    ) -> Result<(), ShapeError> {
        let joints = self.joints();
        whole_instances("models", joints, models.len())?;
        same_length("axes", axes.len(), joints)?;
        same_length("columns", columns.len(), models.len())?;
        if effector >= joints {
            let range = effector..effector.saturating_add(1);
            return Err(ShapeError::Joints { range, joints });
        }
        let parents = self.parents();
        Backend::MOST.run(Screws { parents, models, axes, effector, columns });
        Ok(())
    }
}

/// The sums of [`Hierarchy::velocities`].
struct Velocities<'h, 's, P: Pose> {
    parents: &'h [u32],
    models: &'s [P],
    rates: &'s [P::Twist],
    twists: &'s mut [P::Twist],
}

impl<P: Pose> Kernel for Velocities<'_, '_, P> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { parents, models, rates, twists } = self;
        let joints = parents.len().max(1);
        let instances = models.chunks_exact(joints).zip(rates.chunks_exact(joints));
        for ((models, rates), twists) in instances.zip(twists.chunks_exact_mut(joints)) {
            for (joint, ((model, rate), &parent)) in
                models.iter().zip(rates).zip(parents).enumerate()
            {
                for part in 0..P::parts::<V>() {
                    let rate = P::load_twist(level, part, rate);
                    let mut twist = model.load(level, part).adjoint(rate);
                    // ROOT is beyond the last joint, so the check of the bound tells roots apart.
                    if let Some(parent) = twists.get(parent as usize) {
                        twist = P::load_twist(level, part, parent) + twist;
                    }
                    if let Some(slot) = twists.get_mut(joint) {
                        P::store_twist(level, part, slot, twist);
                    }
                }
            }
        }
    }
}

/// The columns of [`Hierarchy::jacobian`].
struct Screws<'h, 's, P: Pose> {
    parents: &'h [u32],
    models: &'s [P],
    axes: &'s [Twist<P::Real>],
    effector: usize,
    columns: &'s mut [P::Twist],
}

impl<P: Pose> Kernel for Screws<'_, '_, P> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { parents, models, axes, effector, columns } = self;
        let joints = parents.len().max(1);
        let none = P::splat_twist(level, Twist::from_array([P::Real::default(); 6]));
        for (models, columns) in models.chunks_exact(joints).zip(columns.chunks_exact_mut(joints)) {
            for column in columns.iter_mut() {
                for part in 0..P::parts::<V>() {
                    P::store_twist(level, part, column, none);
                }
            }
            let mut joint = effector;
            // ROOT is beyond the last joint, and ends the walk.
            while let (Some(model), Some(&axis), Some(column), Some(&parent)) =
                (models.get(joint), axes.get(joint), columns.get_mut(joint), parents.get(joint))
            {
                let axis = P::splat_twist(level, axis);
                for part in 0..P::parts::<V>() {
                    P::store_twist(level, part, column, model.load(level, part).adjoint(axis));
                }
                joint = parent as usize;
            }
        }
    }
}
