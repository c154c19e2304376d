//! Jacobians of a link for many configurations.

use super::frame::{Frame, JacobianFrame};
use super::group::Group;
use super::poses::carries;
use super::step::Step;
use super::tree::Mechanism;
use super::values::JointValues;
use super::walk::{Joined, Task, Walk};
use crate::batch::DualQuat;
use crate::dispatch::Backend;
use crate::geometry::Twist;
use crate::shape::{ShapeError, joints_within, same_length};
use crate::storage::{Element, Layout, Number, aos, identity};
use core::marker::PhantomData;
use dq8_simd::Level;

impl Backend {
    /// The geometric Jacobian of one link, and its pose, for many configurations in one pass: what
    /// [`Mechanism::link_jacobian`] gives for one.
    ///
    /// `poses` holds one pose of the link for each configuration, `columns` is `[configuration][rate]`,
    /// columns of joints that do not carry the link are zero. Columns are `[R; 6]`, `[ωx, ωy, ωz, vx, vy,
    /// vz]`, or [`LinearFirst`](crate::storage::LinearFirst), the other way round, or [`Twist`]s, or blocks.
    /// [`World`](crate::mechanism::World) is the cheapest frame.
    ///
    /// # Errors
    /// If the slices hold different numbers of configurations, or there is no such link; nothing is
    /// written.
    ///
    /// ```
    /// use dq8::mechanism::{Joint, OwnedMechanism, WorldAligned};
    /// use dq8::{Backend, DualQuat};
    /// let out = DualQuat::from_translation([2.0_f64, 0.0, 0.0]);
    /// let joints = [
    ///     Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]),
    ///     Joint::prismatic(Some(0), out, [1.0, 0.0, 0.0]),
    /// ];
    /// let crane = OwnedMechanism::new(&joints)?;
    /// let (mut tools, mut columns) = ([DualQuat::IDENTITY; 2], [[0.0; 6]; 4]);
    /// let values = [0.0, 0.0, 0.0, 1.0];
    /// let backend = Backend::best();
    /// backend.link_jacobians(WorldAligned, crane.view(), 1, &values, &mut tools, &mut columns)?;
    /// assert_eq!(columns[2], [0.0, 0.0, 1.0, 0.0, 3.0, 0.0]);
    /// assert_eq!(columns[3], [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn link_jacobians<F, T, E, C>(
        self,
        _: F,
        mechanism: Mechanism<'_, Number<E, 8>>,
        link: usize,
        values: &[T],
        poses: &mut [E],
        columns: &mut [C],
    ) -> Result<(), ShapeError>
    where
        F: JacobianFrame,
        T: JointValues<E::Layout>,
        E: Element<8>,
        C: Element<6, Layout = E::Layout>,
    {
        joints_within(&(link..link.saturating_add(1)), mechanism.links())?;
        let elements = poses.len();
        T::check("values", values.len(), mechanism.values, elements)?;
        same_length("columns", columns.len(), elements * mechanism.rates)?;
        let mut sums = false;
        for step in mechanism.steps {
            sums |= step.mimics;
        }
        let (rates, frame) = (mechanism.rates, PhantomData::<F>);
        let task = Jacobians { poses, columns, link, rates, sums, frame };
        self.run(Walk::<E::Layout, _, _> { mechanism, values, elements, task });
        Ok(())
    }
}

struct Jacobians<'s, F, E, C> {
    poses: &'s mut [E],
    columns: &'s mut [C],
    link: usize,
    rates: usize,
    /// Whether some columns are sums: of a joint and those that mimic it.
    sums: bool,
    frame: PhantomData<F>,
}

impl<F, E, C> Task<E::Layout> for Jacobians<'_, F, E, C>
where
    F: JacobianFrame,
    E: Element<8>,
    C: Element<6, Layout = E::Layout>,
{
    /// The pose of the link.
    type State<V: Level> = [<E::Layout as Layout>::Register<V>; 8];
    type Carried<V: Level> = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, level: V) -> Self::State<V> {
        aos::splat(level, identity())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(_: V) {}

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn begin<V: Level>(
        &mut self,
        level: V,
        group: Group,
        steps: &[Step<Number<E, 8>>],
        _: &mut Self::State<V>,
    ) {
        let zero = aos::splat(level, [Number::<E, 8>::default(); 6]);
        for (position, step) in steps.iter().enumerate() {
            if !step.mimics && (self.sums || !carries(steps, position, &[self.link])) {
                for index in 0..step.kind.rates() {
                    let tile = group.tile::<E::Layout, V>(step.rate as usize + index, self.rates);
                    C::store(zero, self.columns, tile);
                }
            }
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn skips(&self, steps: &[Step<Number<E, 8>>], position: usize) -> bool {
        !carries(steps, position, &[self.link])
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(
        &mut self,
        level: V,
        group: Group,
        step: &Step<Number<E, 8>>,
        joined: &Joined<<E::Layout as Layout>::Register<V>>,
        (): &(),
        state: &mut Self::State<V>,
    ) {
        for index in 0..step.kind.rates() {
            let tile = group.tile::<E::Layout, V>(step.rate as usize + index, self.rates);
            let mut column = joined.screw(step, index);
            if self.sums
                && let Some(others) = C::load(level, self.columns, tile, &identity())
            {
                column = column + Twist::from_array(others);
            }
            C::store(column.to_array(), self.columns, tile);
        }
        if step.link as usize == self.link {
            *state = joined.pose.to_motion();
            E::store(*state, self.poses, group.tile::<E::Layout, V>(0, 1));
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn end<V: Level>(
        &mut self,
        level: V,
        group: Group,
        steps: &[Step<Number<E, 8>>],
        state: &mut Self::State<V>,
    ) {
        if F::FRAME == Frame::World {
            return;
        }
        let pose = DualQuat::from_array(*state);
        let (back, origin) = (pose.conjugate(), pose.translation());
        for (position, step) in steps.iter().enumerate() {
            if step.mimics || !(self.sums || carries(steps, position, &[self.link])) {
                continue;
            }
            for index in 0..step.kind.rates() {
                let tile = group.tile::<E::Layout, V>(step.rate as usize + index, self.rates);
                let Some(column) = C::load(level, self.columns, tile, &identity()) else { return };
                let column = Twist::from_array(column);
                let column = if F::FRAME == Frame::Body {
                    back.adjoint(column)
                } else {
                    Twist { linear: column.velocity_at(origin), ..column }
                };
                C::store(column.to_array(), self.columns, tile);
            }
        }
    }
}
