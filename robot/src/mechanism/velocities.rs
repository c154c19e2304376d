//! Velocities and accelerations of links for many configurations.

use super::Job;
#[cfg(doc)]
use super::Mechanism;
use super::group::Group;
use super::job::{grain, things};
use super::joint::JointKind;
use super::step::Step;
use super::values::{JointNumbers, JointValues, Numbers};
use super::walk::{Joined, Task, Walk};
use dq8::Scalar;
use dq8::ShapeError;
use dq8::batch::lie_bracket;
use dq8::batch::vector;
use dq8::geometry::Twist;
use dq8::seams::Rows;
use dq8::storage::same_length;
use dq8::storage::{Element, Layout, Number};
use dq8_simd::Level;

impl<R: Scalar> Job<'_, R> {
    /// Poses and spatial twists of all links for many configurations, in one pass: what
    /// [`Mechanism::link_velocities`] gives for one.
    ///
    /// `rates` is `[configuration][rate]` in the layout of the values, `poses` and `twists` are
    /// `[configuration][link]`.
    ///
    /// # Errors
    /// If the slices hold different numbers of configurations; nothing is written.
    ///
    /// ```
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// use dq8::DualQuat;
    /// let wheel = Joint::revolute(None, DualQuat::IDENTITY, [0.0_f32, 0.0, 1.0]);
    /// let wheel = OwnedMechanism::new(&[wheel])?;
    /// let (mut poses, mut twists) = ([DualQuat::IDENTITY; 3], [[0.0; 6]; 3]);
    /// let (values, rates) = ([0.0, 1.0, 2.0], [3.0, 4.0, 5.0]);
    /// wheel.job().velocities(&values, &rates, &mut poses, &mut twists)?;
    /// assert_eq!(twists[2], [0.0, 0.0, 5.0, 0.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn velocities<T, E, C>(
        &self,
        values: &[T],
        rates: &[T],
        poses: &mut [E],
        twists: &mut [C],
    ) -> Result<(), ShapeError>
    where
        E: Element<8, Layout: Layout<Real = R>>,
        T: JointValues<E::Layout>,
        C: Element<6, Layout = E::Layout>,
    {
        let (mechanism, links, count) =
            (self.mechanism, self.mechanism.links(), self.mechanism.rates);
        let elements = mechanism.configurations::<E::Layout, T>(values, links, poses.len())?;
        T::check("rates", rates.len(), count, elements)?;
        same_length("twists", twists.len(), poses.len())?;
        let backend = self.choice.instructions();
        let run = |first, ((poses, _), (twists, _)): (Rows<E>, Rows<C>)| {
            let elements = things(poses, links, elements);
            let values = T::part(values, mechanism.values, first, elements);
            let rates = T::part(rates, count, first, elements);
            let task = Velocities { moving: Moving { poses, twists, links }, rates, count };
            backend.run(Walk::<E::Layout, _, _> { mechanism, values, elements, task });
        };
        backend.share(grain(links), ((poses, links), (twists, links)), &run);
        Ok(())
    }

    /// The same, and spatial accelerations, the derivatives of the spatial twists: acceleration(j) =
    /// acceleration(parent(j)) + Ad(pose(j)) Sⱼ second_rates(j) + ad(twist) Ad(pose(j)) Sⱼ rates(j)
    /// (Featherstone, *Rigid Body Dynamics Algorithms*, 2008, eq. 2.47). The point of a link that is at x
    /// is accelerated by a + α × x + ω × (v + ω × x), for the twist (ω, v) and the acceleration (α, a).
    ///
    /// # Errors
    /// If the slices hold different numbers of configurations; nothing is written.
    ///
    /// ```
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// use dq8::DualQuat;
    /// let out = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
    /// let arm = OwnedMechanism::new(&[
    ///     Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]),
    ///     Joint::prismatic(Some(0), out, [1.0, 0.0, 0.0]),
    /// ])?;
    /// let mut poses = [DualQuat::IDENTITY; 2];
    /// let (mut twists, mut accelerations) = ([[0.0; 6]; 2], [[0.0; 6]; 2]);
    /// let (rates, second) = ([3.0, 0.5], [0.0, 0.0]);
    /// let values = [0.0, 0.0];
    /// arm.job().accelerations(
    ///     &values, &rates, &second, &mut poses, &mut twists, &mut accelerations,
    /// )?;
    /// // The slide moves out at 0.5 on an arm that turns at 3 rad/s: ω × v, half of what Coriolis asks of a point on it.
    /// assert_eq!(accelerations[1], [0.0, 0.0, 0.0, 0.0, 1.5, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn accelerations<T, E, C>(
        &self,
        values: &[T],
        rates: &[T],
        second_rates: &[T],
        poses: &mut [E],
        twists: &mut [C],
        accelerations: &mut [C],
    ) -> Result<(), ShapeError>
    where
        E: Element<8, Layout: Layout<Real = R>>,
        T: JointValues<E::Layout>,
        C: Element<6, Layout = E::Layout>,
    {
        let (mechanism, links, count) =
            (self.mechanism, self.mechanism.links(), self.mechanism.rates);
        let elements = mechanism.configurations::<E::Layout, T>(values, links, poses.len())?;
        T::check("rates", rates.len(), count, elements)?;
        T::check("second_rates", second_rates.len(), count, elements)?;
        same_length("twists", twists.len(), poses.len())?;
        same_length("accelerations", accelerations.len(), poses.len())?;
        let backend = self.choice.instructions();
        let outputs = ((poses, links), ((twists, links), (accelerations, links)));
        let run = |first, ((poses, _), ((twists, _), (of, _))): (Rows<E>, (Rows<C>, Rows<C>))| {
            let elements = things(poses, links, elements);
            let values = T::part(values, mechanism.values, first, elements);
            let [rates, second_rates] =
                [rates, second_rates].map(|rates| T::part(rates, count, first, elements));
            let moving = Moving { poses, twists, links };
            let task = Accelerations { moving, rates, second_rates, count, accelerations: of };
            backend.run(Walk::<E::Layout, _, _> { mechanism, values, elements, task });
        };
        backend.share(grain(links), outputs, &run);
        Ok(())
    }
}

/// What is written of every link.
struct Moving<'s, E, C> {
    poses: &'s mut [E],
    twists: &'s mut [C],
    links: usize,
}

impl<E: Element<8>, C: Element<6, Layout = E::Layout>> Moving<'_, E, C> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(
        &mut self,
        level: V,
        group: Group,
        step: &Step<Number<E, 8>>,
        joined: &Joined<<E::Layout as Layout>::Register<V>>,
        twist: Twist<<E::Layout as Layout>::Register<V>>,
    ) {
        let (link, links) = (step.link as usize, self.links);
        let tile = group.tile::<E::Layout, V>(link, links);
        E::store(joined.pose.to_motion(), self.poses, tile);
        group.prefetch_next::<E::Layout, V, E>(level, self.poses, link..link + 1, links);
        C::store(twist.to_array(), self.twists, tile);
        group.prefetch_next::<E::Layout, V, C>(level, self.twists, link..link + 1, links);
    }
}

struct Velocities<'s, T, E, C> {
    moving: Moving<'s, E, C>,
    rates: &'s [T],
    count: usize,
}

impl<'s, T, E, C> Task<E::Layout> for Velocities<'s, T, E, C>
where
    T: JointValues<E::Layout>,
    E: Element<8>,
    C: Element<6, Layout = E::Layout>,
{
    const WIDE: bool = false;
    type State<V: Level> = Numbers<'s, E::Layout, T, V>;
    type Carried<V: Level> = Twist<<E::Layout as Layout>::Register<V>>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, level: V) -> Self::State<V> {
        Numbers::new(level, self.rates, self.count)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(level: V) -> Self::Carried<V> {
        Twist::from_array(vector::splat(level, [Number::<E, 8>::default(); 6]))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn begin<V: Level>(
        &mut self,
        _: V,
        group: Group,
        _: &[Step<Number<E, 8>>],
        state: &mut Self::State<V>,
    ) {
        state.turn_to(group);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(
        &mut self,
        level: V,
        group: Group,
        step: &Step<Number<E, 8>>,
        joined: &Joined<<E::Layout as Layout>::Register<V>>,
        parent: &Self::Carried<V>,
        state: &mut Self::State<V>,
    ) -> Self::Carried<V> {
        let mut twist = *parent;
        for index in 0..step.kind.rates() {
            let rate = joined.told(state.get(level, step.rate as usize + index));
            twist = twist + joined.screw(step, index).scale(rate);
        }
        self.moving.store::<V>(level, group, step, joined, twist);
        twist
    }
}

struct Accelerations<'s, T, E, C> {
    moving: Moving<'s, E, C>,
    rates: &'s [T],
    second_rates: &'s [T],
    count: usize,
    accelerations: &'s mut [C],
}

impl<'s, T, E, C> Task<E::Layout> for Accelerations<'s, T, E, C>
where
    T: JointValues<E::Layout>,
    E: Element<8>,
    C: Element<6, Layout = E::Layout>,
{
    const WIDE: bool = false;
    type State<V: Level> = [Numbers<'s, E::Layout, T, V>; 2];
    /// Twist and acceleration.
    type Carried<V: Level> = [Twist<<E::Layout as Layout>::Register<V>>; 2];

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, level: V) -> Self::State<V> {
        [
            Numbers::new(level, self.rates, self.count),
            Numbers::new(level, self.second_rates, self.count),
        ]
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(level: V) -> Self::Carried<V> {
        [Twist::from_array(vector::splat(level, [Number::<E, 8>::default(); 6])); 2]
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn begin<V: Level>(
        &mut self,
        _: V,
        group: Group,
        _: &[Step<Number<E, 8>>],
        [rates, second_rates]: &mut Self::State<V>,
    ) {
        rates.turn_to(group);
        second_rates.turn_to(group);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(
        &mut self,
        level: V,
        group: Group,
        step: &Step<Number<E, 8>>,
        joined: &Joined<<E::Layout as Layout>::Register<V>>,
        parent: &Self::Carried<V>,
        [rates, second_rates]: &mut Self::State<V>,
    ) -> Self::Carried<V> {
        let [mut twist, mut acceleration] = *parent;
        // The twist that carries the next screw along: the turn of a planar joint comes after its slides,
        // while the twist of a floating one is given in its own frame at once.
        let mut carrying = twist;
        for index in 0..step.kind.rates() {
            let which = step.rate as usize + index;
            let screw = joined.screw(step, index);
            let own = screw.scale(joined.told(rates.get(level, which)));
            acceleration = acceleration
                + screw.scale(second_rates.get(level, which))
                + lie_bracket(carrying, own);
            twist = twist + own;
            if matches!(step.kind, JointKind::Planar { .. }) {
                carrying = twist;
            }
        }
        self.moving.store::<V>(level, group, step, joined, twist);
        let (link, links) = (step.link as usize, self.moving.links);
        let tile = group.tile::<E::Layout, V>(link, links);
        C::store(acceleration.to_array(), self.accelerations, tile);
        group.prefetch_next::<E::Layout, V, C>(level, self.accelerations, link..link + 1, links);
        [twist, acceleration]
    }
}
