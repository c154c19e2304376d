//! The velocities and accelerations of links, computed for many configurations.

use super::job::{Job, Run};
use super::joint::JointKind;
use super::step::{JointScrews, Step};
#[cfg(doc)]
use super::tree::Mechanism;
use super::values::{CachedValues, Group, JointValues, LaneValues, Part};
use super::walk::{Task, Visit};
use dq8::batch::{lie_bracket, vector};
use dq8::geometry::Twist;
use dq8::internal::Rows;
use dq8::storage::{Element, Layout, Number, same_length};
use dq8::{Scalar, ShapeError};
use dq8_simd::Level;

impl<R: Scalar> Job<'_, R> {
    /// Computes the poses and spatial twists of all links for many configurations, in one pass.
    /// [`Mechanism::link_velocities`] computes them for one configuration, and its page defines
    /// spatial twists.
    ///
    /// `values` is `[configuration][value]` and `rates` is `[configuration][rate]`, both in the
    /// same layout ([`JointValues`]); `poses` and `twists` are `[configuration][link]`.
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
        let run = self.check_rates(values, &[rates], poses)?;
        let links = run.width;
        same_length("twists", twists.len(), poses.len())?;
        let outputs = ((poses, links), (twists, links));
        run.walk(outputs, |first, ((poses, _), (twists, _)): (Rows<E>, Rows<C>)| {
            let (elements, count) = (run.within(poses), run.mechanism.rates);
            let rates = [T::part(rates, count, first, elements)];
            (elements, Twists { poses, moved: [twists], rates, links, count })
        });
        Ok(())
    }

    /// Computes the poses, the spatial twists, and the spatial accelerations, which are the time
    /// derivatives of the twists. It does so for all links of many configurations.
    /// [`Mechanism::link_accelerations`] computes them for one configuration; its page has the
    /// formula, and the acceleration of a point of a link.
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
    /// // The slide moves out at 0.5 on an arm that turns at 3 rad/s: ω × v. The Coriolis
    /// // acceleration of a point on it is twice that.
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
        let run = self.check_rates(values, &[rates, second_rates], poses)?;
        let links = run.width;
        same_length("twists", twists.len(), poses.len())?;
        same_length("accelerations", accelerations.len(), poses.len())?;
        let outputs = ((poses, links), ((twists, links), (accelerations, links)));
        type All<'s, E, C> = (Rows<'s, E>, (Rows<'s, C>, Rows<'s, C>));
        run.walk(outputs, |first, ((poses, _), ((twists, _), (of, _))): All<E, C>| {
            let (elements, count) = (run.within(poses), run.mechanism.rates);
            let rates = [rates, second_rates].map(|rates| T::part(rates, count, first, elements));
            (elements, Twists { poses, moved: [twists, of], rates, links, count })
        });
        Ok(())
    }

    /// Checks that the poses of all links, the values and the rates are for the same count of
    /// configurations.
    fn check_rates<'r, T, E>(
        &'r self,
        values: &'r [T],
        rates: &[&[T]],
        poses: &[E],
    ) -> Result<Run<'r, R, T>, ShapeError>
    where
        E: Element<8>,
        T: JointValues<E::Layout>,
    {
        let links = self.mechanism.links();
        let run = self.check::<E::Layout, T>(values, ("poses", poses.len()), links)?;
        for (what, rates) in ["rates", "second_rates"].into_iter().zip(rates) {
            T::check(what, rates, run.mechanism.rates, run.elements)?;
        }
        Ok(run)
    }
}

/// The task that writes poses and twists (`N` = 1), or poses, twists and accelerations (`N` = 2).
/// `rates` holds the first rates, from which twists are computed, and if `N` = 2 the second rates,
/// which accelerations need too. `count` is the count of rates of a configuration.
struct Twists<'s, T, E, C, const N: usize> {
    poses: &'s mut [E],
    moved: [&'s mut [C]; N],
    rates: [Part<'s, T>; N],
    links: usize,
    count: usize,
}

impl<'s, T, E, C, const N: usize> Task<E::Layout> for Twists<'s, T, E, C, N>
where
    T: JointValues<E::Layout>,
    E: Element<8>,
    C: Element<6, Layout = E::Layout>,
{
    const WIDE: bool = false;
    type State<V: Level> = [CachedValues<'s, E::Layout, T, V>; N];
    type Carried<V: Level> = [Twist<<E::Layout as Layout>::Register<V>>; N];

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, level: V) -> Self::State<V> {
        self.rates.map(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |rates| CachedValues::new(level, rates, self.count),
        )
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(level: V) -> Self::Carried<V> {
        [Twist::from_array(vector::splat(level, [Number::<E, 8>::default(); 6])); N]
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn begin<V: Level>(
        &mut self,
        _: V,
        group: Group,
        _: &[Step<Number<E, 8>>],
        rates: &mut Self::State<V>,
    ) {
        for rates in rates {
            rates.seek(group);
        }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(
        &mut self,
        visit: &Visit<'_, E::Layout, V>,
        parent: &Self::Carried<V>,
        rates: &mut Self::State<V>,
    ) -> Self::Carried<V> {
        let Visit { level, group, step, ref frames } = *visit;
        let mut all = *parent;
        // `carrying` is the twist of the frame in which the joint's next screw is constant. A
        // planar joint turns after its slides, so the twist of the slides is added before the screw
        // of its turn. The six screws of a floating joint are all constant in one frame.
        let mut carrying = all[0];
        for index in 0..step.kind.rates() {
            let which = step.rate as usize + index;
            let rate = frames.nan_if_nowhere(rates[0].get(level, which));
            let screw = frames.screw(step, index);
            let own = screw.scale(rate);
            if N > 1 {
                let second = screw.scale(rates[N - 1].get(level, which));
                all[N - 1] = all[N - 1] + second + lie_bracket(carrying, own);
            }
            all[0] = all[0] + own;
            if matches!(step.kind, JointKind::Planar { .. }) {
                carrying = all[0];
            }
        }
        let (link, links) = (step.link as usize, self.links);
        let tile = group.tile::<E::Layout, V>(link, links);
        E::store(frames.link.to_motion(), self.poses, tile);
        group.prefetch_next::<E::Layout, V, E>(level, self.poses, link..link + 1, links);
        for (moved, of_link) in self.moved.iter_mut().zip(&all) {
            C::store(of_link.to_array(), moved, tile);
            group.prefetch_next::<E::Layout, V, C>(level, moved, link..link + 1, links);
        }
        all
    }
}
