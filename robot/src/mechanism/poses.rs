//! Poses of links for many configurations.

use super::Job;
#[cfg(doc)]
use super::Mechanism;
use super::group::Group;
use super::job::things;
use super::step::Step;
use super::values::JointValues;
use super::walk::{Joined, Task};
use dq8::storage::{Element, Layout, Number};
use dq8::{Scalar, ShapeError};
use dq8_simd::Level;

impl<R: Scalar> Job<'_, R> {
    /// The poses of all links of many configurations, in the frame of the base: what
    /// [`Mechanism::link_poses`] gives for one, on lanes.
    ///
    /// `poses` is `[configuration][link]`, plain or in blocks; `values` is `[configuration][value]`
    /// in plain numbers for both, or a slice of plain numbers for each value, or
    /// `[configuration block][value]` in blocks ([`JointValues`]). Angles beyond 2¹⁷ rad (`f32`)
    /// or 2⁴⁶ rad (`f64`) give NaN.
    ///
    /// # Errors
    /// If `poses` holds no whole number of configurations or `values` another number of them;
    /// `poses` is untouched.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Joint, OwnedMechanism};
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
    /// arm.job().poses(&values, &mut poses)?;
    /// let [x, y, _] = poses[2999].translation();
    /// let (a, b) = (1.998_f32, 1.998 + 1.999_f32);
    /// assert!((x - (a.cos() + b.cos())).abs() + (y - (a.sin() + b.sin())).abs() < 1e-6);
    /// // The same from a column for each angle.
    /// let columns = [0, 1].map(|first| values.iter().skip(first).step_by(2).copied().collect::<Vec<_>>());
    /// let mut same = vec![DualQuat::IDENTITY; 3000];
    /// arm.job().poses(&[&columns[0][..], &columns[1]], &mut same)?;
    /// assert_eq!(same, poses);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn poses<T, E>(&self, values: &[T], poses: &mut [E]) -> Result<(), ShapeError>
    where
        E: Element<8, Layout: Layout<Real = R>>,
        T: JointValues<E::Layout>,
    {
        self.write::<T, E, true>(&[], self.mechanism.links(), values, poses)
    }
}

impl<R: Scalar> Job<'_, R, &[usize]> {
    /// The poses of some links: `poses` is `[configuration][i]` for the links that the job names,
    /// and else as for all links.
    ///
    /// # Errors
    /// If there is no such link, `poses` holds no whole number of configurations or `values`
    /// another number of them; `poses` is untouched.
    pub fn poses<T, E>(&self, values: &[T], poses: &mut [E]) -> Result<(), ShapeError>
    where
        E: Element<8, Layout: Layout<Real = R>>,
        T: JointValues<E::Layout>,
    {
        self.check_links()?;
        self.write::<T, E, false>(self.links, self.links.len(), values, poses)?;
        repeat(self.links, poses);
        Ok(())
    }
}

impl<R: Scalar, S: Sync> Job<'_, R, S> {
    fn write<T, E, const ALL: bool>(
        &self,
        links: &[usize],
        count: usize,
        values: &[T],
        poses: &mut [E],
    ) -> Result<(), ShapeError>
    where
        E: Element<8, Layout: Layout<Real = R>>,
        T: JointValues<E::Layout>,
    {
        let elements = self.mechanism.configurations::<E::Layout, T>(values, count, poses.len())?;
        self.walk(values, (poses, count), |_, (poses, _): (&mut [E], usize)| {
            (things(poses, count, elements), Poses::<E, ALL> { poses, links, count })
        });
        Ok(())
    }
}

/// Where a link is asked for more than once, its pose to the other places.
pub(crate) fn repeat<E: Copy>(links: &[usize], poses: &mut [E]) {
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
pub(crate) fn place_of(links: &[usize], link: usize) -> Option<usize> {
    links.iter().position(
        #[cfg_attr(not(opt_level_0), inline(always))]
        |&other| other == link,
    )
}

/// The poses of all links, or of some.
struct Poses<'s, E, const ALL: bool> {
    poses: &'s mut [E],
    links: &'s [usize],
    count: usize,
}

impl<E: Element<8>, const ALL: bool> Task<E::Layout> for Poses<'_, E, ALL> {
    type State<V: Level> = ();
    type Carried<V: Level> = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, _: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(_: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn skips(&self, steps: &[Step<Number<E, 8>>], position: usize) -> bool {
        !(ALL || carries(steps, position, self.links))
    }
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
        let (link, count) = (step.link as usize, self.count);
        if ALL {
            let tile = group.tile::<E::Layout, V>(link, count);
            E::store(joined.pose.to_motion(), self.poses, tile);
            group.prefetch_next::<E::Layout, V, E>(level, self.poses, link..link + 1, count);
        } else if let Some(index) = place_of(self.links, link) {
            // The first place only, of a link that is asked for more than once: a loop around the
            // registers of a pose would keep them in memory, which takes half as long again.
            let tile = group.tile::<E::Layout, V>(index, self.links.len());
            E::store(joined.pose.to_motion(), self.poses, tile);
        }
    }
}

/// Whether the link of a step, or one that it carries, is among `links`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn carries<R>(steps: &[Step<R>], position: usize, links: &[usize]) -> bool {
    first_carried(steps, position, links).is_some()
}

/// The first place in `links` of one that is the link of a step, or that this carries.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn first_carried<R>(
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
