//! Poses of links for many configurations.

use super::group::Group;
use super::step::Step;
use super::tree::Mechanism;
use super::values::JointValues;
use super::walk::{Joined, Task, Walk};
use crate::dispatch::Backend;
use crate::shape::ShapeError;
use crate::storage::{Element, Layout, Number};
use dq8_simd::Level;

/// Bytes of a line of the caches.
const LINE: usize = 64;

impl Backend {
    /// The poses of all links of many configurations, in the frame of the base: what
    /// [`Mechanism::link_poses`] gives for one, on lanes.
    ///
    /// `poses` is `[configuration][link]`, plain or in blocks; `values` is `[configuration][value]` in plain
    /// numbers for both, or `[configuration block][value]` in blocks ([`JointValues`]). Rotations of up to 2¹⁷ radians (`f32`) or 2⁴⁶ (`f64`) are told; beyond, poses are NaN.
    ///
    /// # Errors
    /// If `poses` holds no whole number of configurations or `values` another number of them; `poses` is
    /// untouched.
    ///
    /// ```
    /// use dq8::mechanism::{Joint, OwnedMechanism};
    /// use dq8::{Backend, DualQuat};
    /// let out = DualQuat::from_translation([1.0_f32, 0.0, 0.0]);
    /// let joints = [
    ///     Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]),
    ///     Joint::revolute(Some(0), out, [0.0, 0.0, 1.0]),
    ///     Joint::fixed(Some(1), out),
    /// ];
    /// let arm = OwnedMechanism::new(&joints)?;
    /// // 1,000 configurations of two angles.
    /// let values: Vec<f32> = (0..2000).map(|i| 0.001 * i as f32).collect();
    /// let mut poses = vec![DualQuat::IDENTITY; 3000];
    /// Backend::best().link_poses(arm.view(), &values, &mut poses)?;
    /// let [x, y, _] = poses[2999].translation();
    /// let (a, b) = (1.998_f32, 1.998 + 1.999_f32);
    /// assert!((x - (a.cos() + b.cos())).abs() + (y - (a.sin() + b.sin())).abs() < 1e-6);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn link_poses<T: JointValues<E::Layout>, E: Element<8>>(
        self,
        mechanism: Mechanism<'_, Number<E, 8>>,
        values: &[T],
        poses: &mut [E],
    ) -> Result<(), ShapeError> {
        let elements =
            mechanism.configurations::<E::Layout, T>(values, mechanism.links(), poses.len())?;
        let task = All { poses, links: mechanism.links() };
        self.run(Walk::<E::Layout, _, _> { mechanism, values, elements, task });
        Ok(())
    }

    /// The poses of some links: `poses` is `[configuration][i]` for the links `links[i]`. Links that
    /// carry none of them are not computed; for a tool at the end of an arm nothing else is stored.
    ///
    /// # Errors
    /// As for [`link_poses`](Self::link_poses), or if there is no such link.
    ///
    /// ```
    /// use dq8::mechanism::{Joint, OwnedMechanism};
    /// use dq8::{Backend, DualQuat};
    /// let up = DualQuat::from_translation([0.0_f64, 0.0, 1.0]);
    /// let joints = [None, Some(0), Some(1)].map(|on| Joint::prismatic(on, up, [0.0, 0.0, 1.0]));
    /// let lift = OwnedMechanism::new(&joints)?;
    /// let mut tools = [DualQuat::IDENTITY; 2];
    /// let values = [0.0, 0.5, 0.0, 0.0, 0.0, 0.25];
    /// Backend::best().chosen_link_poses(lift.view(), &[2], &values, &mut tools)?;
    /// assert_eq!(tools.map(|tool| tool.translation()[2]), [3.5, 3.25]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn chosen_link_poses<T: JointValues<E::Layout>, E: Element<8>>(
        self,
        mechanism: Mechanism<'_, Number<E, 8>>,
        links: &[usize],
        values: &[T],
        poses: &mut [E],
    ) -> Result<(), ShapeError> {
        mechanism.check_links(links)?;
        let elements =
            mechanism.configurations::<E::Layout, T>(values, links.len(), poses.len())?;
        let task = Chosen { poses: &mut *poses, links };
        self.run(Walk::<E::Layout, _, _> { mechanism, values, elements, task });
        repeat(links, poses);
        Ok(())
    }
}

/// Where a link is asked for more than once, its pose to the other places.
pub(super) fn repeat<E: Copy>(links: &[usize], poses: &mut [E]) {
    for (again, &link) in links.iter().enumerate() {
        let Some(first) = place_of(links, link) else { continue };
        if first == again {
            continue;
        }
        for of_one in poses.chunks_exact_mut(links.len()) {
            let pose = of_one.get(first).copied();
            if let (Some(pose), Some(slot)) = (pose, of_one.get_mut(again)) {
                *slot = pose;
            }
        }
    }
}

/// The first place of a link.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn place_of(links: &[usize], link: usize) -> Option<usize> {
    links.iter().position(
        #[cfg_attr(not(opt_level_0), inline(always))]
        |&other| other == link,
    )
}

struct All<'s, E> {
    poses: &'s mut [E],
    links: usize,
}

impl<E: Element<8>> Task<E::Layout> for All<'_, E> {
    type State<V: Level> = ();
    type Carried<V: Level> = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, _: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(_: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(
        &mut self,
        level: V,
        group: Group,
        step: &Step<Number<E, 8>>,
        joined: &Joined<<E::Layout as Layout>::Register<V>>,
        (): &(),
        (): &mut (),
    ) {
        let link = step.link as usize;
        let tile = group.tile::<E::Layout, V>(link, self.links);
        E::store(joined.pose.to_motion(), self.poses, tile);
        // The next group's poses follow these in memory, but a step writes to as many places as there are
        // lanes, which the CPU does not foresee. A third of the time where poses do not fit the caches.
        if E::Layout::transposes::<V>() {
            let records = E::Layout::records::<V>();
            let next = (group.first + records) * self.links + link * records;
            for ahead in self.poses.iter().skip(next).take(records).step_by(LINE / size_of::<E>()) {
                level.prefetch(ahead);
            }
        }
    }
}

struct Chosen<'s, E> {
    poses: &'s mut [E],
    links: &'s [usize],
}

impl<E: Element<8>> Task<E::Layout> for Chosen<'_, E> {
    type State<V: Level> = ();
    type Carried<V: Level> = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, _: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(_: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn skips(&self, steps: &[Step<Number<E, 8>>], position: usize) -> bool {
        !carries(steps, position, self.links)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(
        &mut self,
        _: V,
        group: Group,
        step: &Step<Number<E, 8>>,
        joined: &Joined<<E::Layout as Layout>::Register<V>>,
        (): &(),
        (): &mut (),
    ) {
        // The first place only, of a link that is asked for more than once: a loop around the registers of a pose would keep
        // them in memory, which takes half as long again.
        if let Some(index) = place_of(self.links, step.link as usize) {
            let tile = group.tile::<E::Layout, V>(index, self.links.len());
            E::store(joined.pose.to_motion(), self.poses, tile);
        }
    }
}

/// Whether the link of a step, or one that it carries, is among `links`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn carries<R>(steps: &[Step<R>], position: usize, links: &[usize]) -> bool {
    first_carried(steps, position, links).is_some()
}

/// The first place in `links` of one that is the link of a step, or that this carries.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn first_carried<R>(
    steps: &[Step<R>],
    position: usize,
    links: &[usize],
) -> Option<usize> {
    let step = steps.get(position)?;
    for (index, &link) in links.iter().enumerate() {
        if (steps.get(link)?.position as usize).wrapping_sub(position) < step.size as usize {
            return Some(index);
        }
    }
    None
}
