//! The formulas of textbooks, for one configuration at a time and any `Real`. For `f32` and `f64`
//! these methods call the faster code of `configuration.rs`. Tests compare that code, and the
//! kernels that compute one configuration per lane, with the formulas here.

use super::configuration::{LinkJacobian, LinkPoints, LinkPose, LinkPoses};
use super::jacobians::{Frame, JacobianFrame};
use super::joint::JointKind;
use super::step::{JointFrame, JointScrews, Step};
use super::tree::Mechanism;
use dq8::geometry::Twist;
use dq8::scalar::{DualQuat, Quat, lie_bracket, vector};
use dq8::storage::same_length;
use dq8::{Real, ShapeError};

impl<R: Real> Mechanism<'_, R> {
    /// Computes the poses of all links in the frame of the base: pose(j) = pose(parent(j)) ·
    /// placement(j) · motion(j) (Denavit & Hartenberg 1955, with placements of any kind).
    ///
    /// # Errors
    /// If `values` or `poses` does not have the length that the mechanism asks for; `poses` is
    /// untouched.
    pub fn link_poses(&self, values: &[R], poses: &mut [DualQuat<R>]) -> Result<(), ShapeError> {
        same_length("values", values.len(), self.values)?;
        same_length("poses", poses.len(), self.links())?;
        let quick = LinkPoses { mechanism: self, values, poses };
        if R::quick(quick).is_some() {
            return Ok(());
        }
        for step in self.steps {
            let local = step.placement() * step.motion(values);
            let pose = match poses.get(step.parent as usize) {
                Some(&parent) => parent * local,
                None => local,
            };
            if let Some(slot) = poses.get_mut(step.link as usize) {
                *slot = pose;
            }
        }
        Ok(())
    }

    /// Returns the pose of one link in the frame of the base. Only this link and the links that
    /// carry it are computed.
    ///
    /// # Errors
    /// If `values` does not have the length that the mechanism asks for, or there is no such link.
    #[doc(alias("forward_kinematics", "fk"))]
    pub fn link_pose(&self, values: &[R], link: usize) -> Result<DualQuat<R>, ShapeError> {
        self.check(values, link)?;
        let quick = LinkPose { mechanism: self, values, link };
        if let Some(pose) = R::quick(quick) {
            return Ok(pose);
        }
        let mut pose = DualQuat::IDENTITY;
        let mut link = link;
        while let Some(step) = self.step(link) {
            pose = step.placement() * step.motion(values) * pose;
            link = step.parent as usize;
        }
        Ok(pose)
    }

    /// Computes the places of points on links, in the frame of the base. Each element of `points`
    /// is the index of a link and the coordinates of a point in its frame. The points may be in any
    /// order, but the method is faster if they are sorted by link.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let out = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
    /// let arm = OwnedMechanism::new(&[
    ///     Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]),
    ///     Joint::prismatic(Some(0), out, [1.0, 0.0, 0.0]),
    /// ])?;
    /// let (elbow, tip) = ((0, [1.0, 0.0, 0.0]), (1, [0.5, 0.0, 0.25]));
    /// let mut places = [[0.0; 3]; 2];
    /// arm.view().link_points(&[0.0, 2.0], &[elbow, tip], &mut places)?;
    /// assert_eq!(places, [[1.0, 0.0, 0.0], [3.5, 0.0, 0.25]]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If `values` does not have the length that the mechanism asks for, there are not as many
    /// places as points, or there is no such link; `places` is untouched.
    pub fn link_points(
        &self,
        values: &[R],
        points: &[(usize, [R; 3])],
        places: &mut [[R; 3]],
    ) -> Result<(), ShapeError> {
        same_length("values", values.len(), self.values)?;
        same_length("places", places.len(), points.len())?;
        points.iter().try_for_each(|&(link, _)| self.check_link(link))?;
        let quick = LinkPoints { mechanism: self, values, points, places: &mut *places };
        if R::quick(quick).is_some() {
            return Ok(());
        }
        for (&(mut link, mut place), slot) in points.iter().zip(places) {
            while let Some(step) = self.step(link) {
                place = (step.placement() * step.motion(values)).transform_point(place);
                link = step.parent as usize;
            }
            *slot = place;
        }
        Ok(())
    }

    /// Computes the geometric Jacobian of a link, with a column for each rate of the mechanism, and
    /// returns the pose of the link. The twist of the link is Σ column(i) · rate(i); columns of
    /// joints that do not carry the link are zero.
    ///
    /// Column j is Ad(pose of the link in the frame of joint j)⁻¹ Sⱼ in the frame
    /// [`Body`](super::Body), where Sⱼ is the joint's own body twist (Lynch & Park 2017, eq.
    /// 5.18). The first argument selects the frame by its type:
    ///
    /// ```
    /// use dq8_robot::{Joint, OwnedMechanism, World, WorldAligned};
    /// use dq8::{DualQuat, Twist};
    /// let out = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
    /// let joints = [
    ///     Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]),
    ///     Joint::fixed(Some(0), out),
    /// ];
    /// let arm = OwnedMechanism::new(&joints)?;
    /// let mut column = [Twist::from_array([0.0; 6])];
    /// arm.view().link_jacobian(WorldAligned, &[0.0], 1, &mut column)?;
    /// assert_eq!(column[0].to_array(), [0.0, 0.0, 1.0, 0.0, 1.0, 0.0]);
    /// // The point of the link that is at the origin of the base does not move.
    /// arm.view().link_jacobian(World, &[0.0], 1, &mut column)?;
    /// assert_eq!(column[0].to_array(), [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If `values` or `columns` does not have the length that the mechanism asks for, or there is
    /// no such link; `columns` is untouched.
    pub fn link_jacobian<F: JacobianFrame>(
        &self,
        _: F,
        values: &[R],
        link: usize,
        columns: &mut [Twist<R>],
    ) -> Result<DualQuat<R>, ShapeError> {
        self.check(values, link)?;
        same_length("columns", columns.len(), self.rates)?;
        let (mechanism, frame) = (self, F::FRAME);
        let quick = LinkJacobian { mechanism, values, link, frame, columns: &mut *columns };
        if let Some(pose) = R::quick(quick) {
            return Ok(pose);
        }
        columns.fill(Twist::from_array([R::ZERO; 6]));
        // The loop goes from the link toward the base. `tail` is the pose of `link` in the frame of
        // the link that the present joint carries.
        let mut tail = DualQuat::IDENTITY;
        let mut joint = link;
        while let Some(step) = self.step(joint) {
            let own = columns.get_mut(step.rate as usize..).unwrap_or_default();
            for (index, column) in own.iter_mut().take(step.kind.rates()).enumerate() {
                // A joint and the joints that mimic it share one column, so the column is a sum.
                *column = *column + tail.conjugate().adjoint(step.body_twist(index, values));
            }
            tail = step.placement() * step.motion(values) * tail;
            joint = step.parent as usize;
        }
        let to_frame = match F::FRAME {
            Frame::Body => return Ok(tail),
            Frame::World => tail,
            Frame::WorldAligned => DualQuat::from_rotation(tail.rotation()),
        };
        for column in columns {
            *column = to_frame.adjoint(*column);
        }
        Ok(tail)
    }

    /// Computes the poses and the spatial twists of all links: twist(j) = twist(parent(j)) +
    /// Ad(pose(j)) Sⱼ rates(j). Sⱼ holds the body twists of joint j. Spatial twists are in the
    /// axes of the base and about its origin; [`Twist::velocity_at`] gives the velocity of a point.
    ///
    /// # Errors
    /// If a slice does not have the length that the mechanism asks for; nothing is written.
    pub fn link_velocities(
        &self,
        values: &[R],
        rates: &[R],
        poses: &mut [DualQuat<R>],
        twists: &mut [Twist<R>],
    ) -> Result<(), ShapeError> {
        same_length("rates", rates.len(), self.rates)?;
        same_length("twists", twists.len(), self.links())?;
        self.link_poses(values, poses)?;
        for step in self.steps {
            let Some(pose) = poses.get(step.link as usize) else { continue };
            let zero = Twist::from_array([R::ZERO; 6]);
            let own = step.own_twists(values, rates).fold(zero, |sum, own| sum + own);
            let mut twist = pose.adjoint(own);
            if let Some(parent) = twists.get(step.parent as usize) {
                twist = *parent + twist;
            }
            if let Some(slot) = twists.get_mut(step.link as usize) {
                *slot = twist;
            }
        }
        Ok(())
    }

    /// Computes the poses, the spatial twists and the spatial accelerations of all links.
    /// Accelerations are the time derivatives of twists: acceleration(j) =
    /// acceleration(parent(j)) + Ad(pose(j)) Sⱼ second_rates(j) + ad(twist) Ad(pose(j)) Sⱼ
    /// rates(j) (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, eq. 2.47). The point of a
    /// link that is at x is accelerated by a + α × x + ω × (v + ω × x), for the twist (ω, v)
    /// and the acceleration (α, a).
    ///
    /// # Errors
    /// If a slice does not have the length that the mechanism asks for; nothing is written.
    pub fn link_accelerations(
        &self,
        values: &[R],
        rates: &[R],
        second_rates: &[R],
        poses: &mut [DualQuat<R>],
        twists: &mut [Twist<R>],
        accelerations: &mut [Twist<R>],
    ) -> Result<(), ShapeError> {
        same_length("second_rates", second_rates.len(), self.rates)?;
        same_length("accelerations", accelerations.len(), self.links())?;
        self.link_velocities(values, rates, poses, twists)?;
        let zero = Twist::from_array([R::ZERO; 6]);
        for step in self.steps {
            let Some(pose) = poses.get(step.link as usize) else { continue };
            let parent = step.parent as usize;
            let mut acceleration = accelerations.get(parent).copied().unwrap_or(zero);
            let own = step.own_twists(values, second_rates).fold(zero, |sum, own| sum + own);
            acceleration = acceleration + pose.adjoint(own);
            // `carrying` is the twist of the frame in which the joint's next screw is constant.
            // This is the frame of the parent. For the turn of a planar joint, the twist of the
            // joint's two slides is added to it.
            let mut carrying = twists.get(parent).copied().unwrap_or(zero);
            let own_rates = rates.get(step.rate as usize..).unwrap_or_default().iter();
            for (index, &rate) in own_rates.take(step.kind.rates()).enumerate() {
                let moving = pose.adjoint(step.body_twist(index, values)).scale(rate);
                acceleration = acceleration + lie_bracket(carrying, moving);
                if let JointKind::Planar { .. } = step.kind {
                    carrying = carrying + moving;
                }
            }
            if let Some(slot) = accelerations.get_mut(step.link as usize) {
                *slot = acceleration;
            }
        }
        Ok(())
    }

    fn check(&self, values: &[R], link: usize) -> Result<(), ShapeError> {
        same_length("values", values.len(), self.values)?;
        self.check_link(link)
    }
}

impl<R: Real> Step<R> {
    /// Returns `C` consecutive values of `all`, from index `first` on. If values are missing, which
    /// the check of lengths rules out, the result is NaN.
    pub(crate) fn numbers<const C: usize>(first: u32, all: &[R]) -> [R; C] {
        let rest = all.get(first as usize..).unwrap_or_default();
        rest.first_chunk().copied().unwrap_or([R::NAN; C])
    }

    /// Returns value `index` of the joint, an angle or a distance. For a joint that mimics another,
    /// this is the followed value times `multiplier` plus `offset`.
    pub(crate) fn number(&self, index: usize, values: &[R]) -> R {
        let [number] = Self::numbers(self.value + index as u32, values);
        // Joints with more than one value mimic no other joint, so only value 0 can have a rule.
        if index == 0 { number * self.multiplier + self.offset } else { number }
    }

    /// Returns the translation by the distances x and y in the plane of a planar joint, in the
    /// frame of the joint.
    pub(crate) fn in_plane(&self, [x, y]: [R; 2]) -> [R; 3] {
        let [first, second] = self.plane;
        vector::add(vector::scale(first, x), vector::scale(second, y))
    }

    /// Returns the pose of the link in the frame of its joint, computed from the values of a
    /// configuration.
    pub(crate) fn motion(&self, mut values: &[R]) -> DualQuat<R> {
        let rest = Motion { rotation: None, translation: None };
        match rest.link_frame(self, &mut values) {
            Motion { rotation: None, translation: None } => DualQuat::IDENTITY,
            Motion { rotation: Some(rotation), translation: None } => {
                DualQuat::from_rotation(rotation)
            }
            Motion { rotation: None, translation: Some(translation) } => {
                DualQuat::from_translation(translation)
            }
            Motion { rotation: Some(rotation), translation: Some(translation) } => {
                DualQuat::from_rotation_translation(rotation, translation)
            }
        }
    }

    /// Returns the body twist that rate `index` of the joint gives to its link. On firmware the
    /// function is not inlined, so that the image contains its code once.
    #[cfg_attr(target_os = "none", inline(never))]
    fn body_twist(&self, index: usize, values: &[R]) -> Twist<R> {
        BodyScrews(values).screw(self, index)
    }

    /// Returns the body twist of each rate of this joint, scaled by the rate, in the order of the
    /// rates.
    fn own_twists(&self, values: &[R], rates: &[R]) -> impl Iterator<Item = Twist<R>> {
        // For a joint without rates the index is `NONE`, so the slice is empty.
        let rates = rates.get(self.rate as usize..).unwrap_or_default().iter();
        let own = rates.take(self.kind.rates()).enumerate();
        own.map(move |(index, &rate)| self.body_twist(index, values).scale(rate))
    }
}

/// The motion of a joint. A part that is `None` is the identity, and needs no multiplication.
#[derive(Clone, Copy)]
struct Motion<R> {
    rotation: Option<Quat<R>>,
    translation: Option<[R; 3]>,
}

impl<R: Real> JointFrame<R, &[R]> for Motion<R> {
    type Number = R;

    fn number(self, number: R) -> R {
        number
    }

    fn numbers<const C: usize>(self, step: &Step<R>, values: &mut &[R]) -> [R; C] {
        Step::numbers(step.value, values)
    }

    fn value(self, step: &Step<R>, index: usize, values: &mut &[R]) -> R {
        step.number(index, values)
    }

    fn half_angle(self, angle: R) -> [R; 2] {
        let half = angle * R::HALF;
        [half.cos(), half.sin()]
    }

    fn turn(self, step: &Step<R>, [cos, sin]: [R; 2]) -> Self {
        Self { rotation: Some(Quat::from_parts(vector::scale(step.axis, sin), cos)), ..self }
    }

    fn slide(self, step: &Step<R>, distance: R) -> Self {
        Self { translation: Some(vector::scale(step.axis, distance)), ..self }
    }

    fn slide_in_plane(self, step: &Step<R>, distances: [R; 2]) -> Self {
        Self { translation: Some(step.in_plane(distances)), ..self }
    }

    fn float(self, _: &Step<R>, [x, y, z, w, tx, ty, tz]: [R; 7]) -> Self {
        let turn = Quat::from_xyzw(x, y, z, w).normalize();
        Self { rotation: Some(turn), translation: Some([tx, ty, tz]) }
    }
}

/// The body twists of joints, in the frames of their links, computed from the values of a
/// configuration.
struct BodyScrews<'v, R>(&'v [R]);

impl<R: Real> JointScrews<R> for BodyScrews<'_, R> {
    type Number = R;

    fn number(&self, number: R) -> R {
        number
    }

    fn axis(&self, step: &Step<R>) -> [R; 3] {
        step.axis
    }

    fn plane_axis(&self, step: &Step<R>, index: usize) -> [R; 3] {
        let turn = Quat::from_axis_angle(step.axis, step.number(2, self.0));
        turn.conjugate().rotate(step.plane[index % 2])
    }

    fn link_axis(&self, _: &Step<R>, index: usize) -> [R; 3] {
        let mut unit = [R::ZERO; 3];
        unit[index % 3] = R::ONE;
        unit
    }

    fn hinge(&self, axis: [R; 3]) -> Twist<R> {
        Twist { angular: axis, linear: [R::ZERO; 3] }
    }

    fn thread(&self, axis: [R; 3], pitch: R) -> Twist<R> {
        Twist { angular: axis, linear: vector::scale(axis, pitch) }
    }

    fn link_hinge(&self, _: &Step<R>, axis: [R; 3]) -> Twist<R> {
        self.hinge(axis)
    }
}
