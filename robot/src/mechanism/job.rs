//! Computing many configurations at a time: [`Job`] with its options and its check of lengths, its
//! methods for poses of links and for points on links, and
//! [`OwnedMechanism`](super::OwnedMechanism), which owns its memory.

use super::step::Step;
use super::tree::Mechanism;
use super::values::{Group, JointValues};
use super::walk::{Task, Visit, Walk};
use core::marker::PhantomData;
use core::ops::Range;
use dq8::batch::{Quat, vector};
use dq8::internal::{Choice, Outputs};
use dq8::storage::{Element, Layout, Number, whole_instances};
use dq8::{Backend, Scalar, ShapeError};
use dq8_simd::{Level, Records};
#[cfg(feature = "alloc")]
use {
    super::{Dh, DhConvention, Joint, MechanismError},
    alloc::{vec, vec::Vec},
    dq8::{Real, geometry::Screw, internal::brief, scalar::DualQuat},
};

/// A computation for many configurations of a mechanism, one per lane, with options that all have a
/// default.
///
/// `R` is the element type. `S` is the set of links: [`AllLinks`], or the links that were given to
/// [`links`](Self::links).
///
/// ```
/// use dq8::DualQuat;
/// use dq8_robot::{Joint, OwnedMechanism};
/// let up = DualQuat::from_translation([0.0_f64, 0.0, 1.0]);
/// let joints = [None, Some(0), Some(1)].map(|on| Joint::prismatic(on, up, [0.0, 0.0, 1.0]));
/// let lift = OwnedMechanism::new(&joints)?;
/// // Two configurations of three values; the third link is the tool.
/// let values = [0.0, 0.5, 0.0, 0.0, 0.0, 0.25];
/// let mut tools = [DualQuat::IDENTITY; 2];
/// lift.job().links(&[2]).poses(&values, &mut tools)?;
/// assert_eq!(tools.map(|tool| tool.translation()[2]), [3.5, 3.25]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Job<'a, R, S = AllLinks> {
    pub(crate) mechanism: Mechanism<'a, R>,
    pub(crate) links: S,
    pub(crate) choice: Choice,
}

/// The set of all links of the mechanism, for which a [`Job`] computes unless links are selected.
#[derive(Clone, Copy, Debug)]
pub struct AllLinks;

impl<'a, R: Copy> Mechanism<'a, R> {
    /// Returns a job that computes many configurations, with all options at their defaults.
    pub fn job(self) -> Job<'a, R> {
        Job { mechanism: self, links: AllLinks, choice: Choice::default() }
    }
}

impl<'a, R: Copy> Job<'a, R> {
    /// Selects these links, in this order, for the output. A link that is not selected and carries
    /// no selected link is not computed, and only poses of selected links are stored.
    pub fn links(self, links: &'a [usize]) -> Job<'a, R, &'a [usize]> {
        Job { mechanism: self.mechanism, links, choice: self.choice }
    }
}

impl<R, S> Job<'_, R, S> {
    dq8::internal::options!();
}

/// The links of a [`Job`]: [`AllLinks`], or a slice of indices.
pub trait Links: Copy + Sync {
    /// `true` if the job is over all links of the mechanism.
    const ALL: bool;
    /// Returns the indices of the selected links; empty for [`AllLinks`].
    fn some(&self) -> &[usize];
}

impl Links for AllLinks {
    const ALL: bool = true;

    fn some(&self) -> &[usize] {
        &[]
    }
}

impl Links for &[usize] {
    const ALL: bool = false;

    #[inline]
    fn some(&self) -> &[usize] {
        self
    }
}

impl<R: Scalar, S: Links> Job<'_, R, S> {
    /// Checks that the links exist, that the output with the name `what` holds a whole number of
    /// configurations with `width` elements each, and that the values are for the same number of
    /// configurations.
    pub(crate) fn check<'r, Y: Layout, T: JointValues<Y>>(
        &'r self,
        values: &'r [T],
        (what, length): (&'static str, usize),
        width: usize,
    ) -> Result<Run<'r, R, T>, ShapeError> {
        let mechanism = self.mechanism;
        self.links.some().iter().try_for_each(|&link| mechanism.check_link(link))?;
        let elements = whole_instances(what, width, length)?;
        T::check("values", values, mechanism.values, elements)?;
        Ok(Run { mechanism, backend: self.choice.instructions(), values, elements, width })
    }
}

/// The checked input of the loop over all configurations.
#[derive(Clone, Copy)]
pub(crate) struct Run<'r, R, T> {
    pub(crate) mechanism: Mechanism<'r, R>,
    backend: Backend,
    values: &'r [T],
    /// The count of configurations, or of blocks if poses are in blocks.
    pub(crate) elements: usize,
    /// The count of elements that each configuration has in the output.
    pub(crate) width: usize,
}

impl<R: Scalar, T> Run<'_, R, T> {
    /// Runs the loop over all configurations, on as many threads as the job allows. The outputs are
    /// divided into parts. The function `task` takes the index of a part's first configuration (or
    /// block) and the part. It returns the count of configurations (or blocks) in the part, and the
    /// task that writes them.
    pub(crate) fn walk<Y, O, K>(self, outputs: O, task: impl Fn(usize, O) -> (usize, K) + Sync)
    where
        Y: Layout<Real = R>,
        T: JointValues<Y>,
        O: Outputs,
        K: Task<Y>,
    {
        let Self { mechanism, values, .. } = self;
        // A part is worth some microseconds of work, and is a multiple of the largest count of
        // lanes, so that only the last part has unused lanes.
        let grain = 2048_usize.div_ceil(mechanism.links().max(1));
        let grain = grain.next_multiple_of(dq8_simd::MAX_LANES);
        self.backend.share(grain, outputs, &|first, part| {
            let (elements, task) = task(first, part);
            let values = T::part(values, mechanism.values, first, elements);
            self.backend.run(Walk::<Y, _, _> { mechanism, values, elements, task });
        });
    }

    /// Returns the count of configurations, or of blocks, in a part of the output.
    pub(crate) fn within<E>(&self, part: &[E]) -> usize {
        part.len().checked_div(self.width).unwrap_or(self.elements)
    }
}

impl<R: Scalar, S: Links> Job<'_, R, S> {
    /// Computes the poses of links for many configurations, in the frame of the base.
    /// [`Mechanism::link_poses`] computes them for one configuration.
    ///
    /// `poses` is `[configuration][link]`, plain or in blocks. It holds all links, or the links
    /// that the job selects, in the order of the selection. `values` is `[configuration][value]` in
    /// plain floats, or a slice of plain floats for each value. If poses are in blocks, it may also
    /// be `[configuration block][value]` in blocks ([`JointValues`]). Angles beyond 2¹⁷ rad
    /// (`f32`) or 2⁴⁶ rad (`f64`) give NaN.
    ///
    /// # Errors
    /// If there is no such link, `poses` does not hold a whole number of configurations, or
    /// `values` holds a different count of configurations; `poses` is untouched.
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
    /// let column = |first| values.iter().skip(first).step_by(2).copied().collect::<Vec<_>>();
    /// let columns = [0, 1].map(column);
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
        let links = self.links.some();
        let count = if S::ALL { self.mechanism.links() } else { links.len() };
        let run = self.check::<E::Layout, T>(values, ("poses", poses.len()), count)?;
        run.walk((&mut *poses, count), |_, (poses, _): (&mut [E], usize)| {
            let task = Poses::<E, S> { poses, links, count, which: PhantomData };
            (run.within(task.poses), task)
        });
        repeat(links, poses);
        Ok(())
    }
}

/// For each link that occurs more than once in `links`, copies its pose from the first place in the
/// output, which the loop has written, to the other places.
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

/// Returns the index at which a link first occurs in `links`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn place_of(links: &[usize], link: usize) -> Option<usize> {
    links.iter().position(
        #[cfg_attr(not(opt_level_0), inline(always))]
        |&other| other == link,
    )
}

/// The task that writes the poses of all links, or of the selected links.
struct Poses<'s, E, S> {
    poses: &'s mut [E],
    links: &'s [usize],
    count: usize,
    which: PhantomData<S>,
}

impl<E: Element<8>, S: Links> Task<E::Layout> for Poses<'_, E, S> {
    type State<V: Level> = ();
    type Carried<V: Level> = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, _: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(_: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn skips(&self, steps: &[Step<Number<E, 8>>], position: usize) -> bool {
        !(S::ALL || carries(steps, position, self.links))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(&mut self, visit: &Visit<'_, E::Layout, V>, (): &(), (): &mut ()) {
        let Visit { level, group, step, ref frames } = *visit;
        let (link, count) = (step.link as usize, self.count);
        if S::ALL {
            let tile = group.tile::<E::Layout, V>(link, count);
            E::store(frames.link.to_motion(), self.poses, tile);
            group.prefetch_next::<E::Layout, V, E>(level, self.poses, link..link + 1, count);
        } else if let Some(index) = place_of(self.links, link) {
            // A link that is selected more than once is written to its first place only; [`repeat`]
            // copies its pose later. With a loop over all places here, the compiler would spill the
            // registers of the pose to the stack, which would take half as much time again.
            let tile = group.tile::<E::Layout, V>(index, self.links.len());
            E::store(frames.link.to_motion(), self.poses, tile);
        }
    }
}

/// Returns `true` if the link of the step at `position`, or a link that this link carries, is among
/// `links`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn carries<R>(steps: &[Step<R>], position: usize, links: &[usize]) -> bool {
    first_carried(steps, position, links).is_some()
}

/// Returns the index of the first element of `links` that is the link of the step at `position`, or
/// is carried by that link.
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

/// The index of a link, and a point in the frame of that link.
pub(crate) type Point<R> = (usize, [R; 3]);

/// Points on links. The loop over links takes the points of each link from here.
#[derive(Clone, Copy)]
pub(crate) struct PointsByLink<'p, R> {
    pub(crate) points: &'p [Point<R>],
    in_order: bool,
    /// The index at which the points of the next link are likely to begin.
    next: usize,
}

impl<'p, R> PointsByLink<'p, R> {
    pub(crate) fn new(points: &'p [Point<R>]) -> Self {
        let in_order = points.is_sorted_by(|(a, _), (b, _)| a <= b);
        Self { points, in_order, next: 0 }
    }

    /// Returns a range of indices that holds all points of a link. If the points are not sorted by
    /// link, this is the range of all points.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn of(&mut self, link: usize) -> Range<usize> {
        if !self.in_order {
            return 0..self.points.len();
        }
        let is_of = |point: Option<&Point<R>>| matches!(point, Some((of, _)) if *of == link);
        let mut end = self.next;
        // The search before this one ended at `next`, after the last point of some link. So `next`
        // is never in the middle of one link's points.
        if !is_of(self.points.get(end)) {
            end = self.points.partition_point(|(of, _)| *of < link);
        }
        let start = end;
        while is_of(self.points.get(end)) {
            end += 1;
        }
        self.next = end;
        start..end
    }
}

impl<R: Scalar> Job<'_, R> {
    /// Computes the places of points on links, in the frame of the base, for many configurations in
    /// one pass and without poses in memory. [`Mechanism::link_points`] computes them for one
    /// configuration.
    ///
    /// Each element of `points` is the index of a link and a point in its frame. `values` is laid
    /// out as for [`poses`](Self::poses). `places` is `[configuration][point]` in the order of
    /// `points`, with elements `[R; 3]` or blocks.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let up = DualQuat::from_translation([0.0_f32, 0.0, 1.0]);
    /// let lift = OwnedMechanism::new(&[Joint::prismatic(None, up, [0.0, 0.0, 1.0])])?;
    /// let mut places = [[0.0; 3]; 4];
    /// lift.job().points(&[(0, [0.0; 3]), (0, [0.5, 0.0, 0.0])], &[0.0, 2.0], &mut places)?;
    /// assert_eq!(places[3], [0.5, 0.0, 3.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If there is no such link, `places` does not hold a whole number of configurations, or
    /// `values` holds a different count of configurations; `places` is untouched.
    pub fn points<T, E>(
        &self,
        points: &[(usize, [R; 3])],
        values: &[T],
        places: &mut [E],
    ) -> Result<(), ShapeError>
    where
        E: Element<3, Layout: Layout<Real = R>>,
        T: JointValues<E::Layout>,
    {
        points.iter().try_for_each(|&(link, _)| self.mechanism.check_link(link))?;
        let count = points.len();
        let run = self.check::<E::Layout, T>(values, ("places", places.len()), count)?;
        run.walk((places, count), |_, (places, _): (&mut [E], usize)| {
            (run.within(places), Points { places, found: PointsByLink::new(points) })
        });
        Ok(())
    }
}

struct Points<'s, E: Element<3>> {
    places: &'s mut [E],
    found: PointsByLink<'s, Number<E, 3>>,
}

/// Up to four computed places that are still to be written. The three components of one point fill
/// no register, but the twelve of four points fill three. Writing four points together takes a
/// quarter of the stores. Stores take most of the time if the output is a plain slice.
struct PointQuad<L> {
    first: usize,
    count: usize,
    places: [[L; 3]; FOUR],
}

/// The count of points that are written together.
const FOUR: usize = 4;

type Register<E, V> = <<E as Element<3>>::Layout as Layout>::Register<V>;

impl<E: Element<3>> Points<'_, E> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn write<V: Level>(&mut self, level: V, group: Group, waiting: &mut PointQuad<Register<E, V>>) {
        let (all, first) = (self.found.points.len(), waiting.first);
        let count = core::mem::take(&mut waiting.count);
        group.prefetch_next::<E::Layout, V, E>(level, self.places, first..first + count, all);
        let plain = E::plain_mut(self.places).map(<[_]>::as_flattened_mut);
        let start = 3 * (group.first * all + first);
        let row = plain.and_then(|plain| plain.get_mut(start..));
        if let (FOUR, Some(row)) = (count, row) {
            let [[a, b, c], [d, e, f], [g, h, i], [j, k, l]] = waiting.places;
            let quads = [[a, b, c, d], [e, f, g, h], [i, j, k, l]];
            if Register::<E, V>::store_rows(quads, row, 3 * all) {
                return;
            }
        }
        for (ahead, place) in waiting.places.iter().enumerate().take(count) {
            E::store(*place, self.places, group.tile::<E::Layout, V>(first + ahead, all));
        }
    }
}

impl<E: Element<3>> Task<E::Layout> for Points<'_, E> {
    type State<V: Level> = PointQuad<Register<E, V>>;
    type Carried<V: Level> = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, level: V) -> Self::State<V> {
        let zero = vector::splat(level, [Number::<E, 3>::default(); 3]);
        PointQuad { first: 0, count: 0, places: [zero; FOUR] }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(_: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(
        &mut self,
        visit: &Visit<'_, E::Layout, V>,
        (): &(),
        waiting: &mut Self::State<V>,
    ) {
        let Visit { level, group, step, ref frames } = *visit;
        let (link, points) = (step.link as usize, self.found.points);
        let some = self.found.of(link);
        if some.is_empty() {
            return;
        }
        let [hx, hy, hz] = frames.link.half;
        let origin = [hx + hx, hy + hy, hz + hz];
        let [a, b, c] = Quat::from_array(frames.link.rotation).to_matrix3();
        let columns = [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]];
        for index in some {
            let Some(&(of, point)) = points.get(index) else { return };
            if of != link {
                continue;
            }
            let [x, y, z] = vector::splat(level, point);
            let place = vector::scale_onto(columns[2], z, origin);
            let place = vector::scale_onto(columns[1], y, place);
            let place = vector::scale_onto(columns[0], x, place);
            if !E::Layout::transposes::<V>() {
                let tile = group.tile::<E::Layout, V>(index, points.len());
                E::store(place, self.places, tile);
                continue;
            }
            if index != waiting.first + waiting.count {
                self.write::<V>(level, group, waiting);
            }
            if waiting.count == 0 {
                waiting.first = index;
            }
            waiting.places[waiting.count % FOUR] = place;
            waiting.count += 1;
            if waiting.count == FOUR {
                self.write::<V>(level, group, waiting);
            }
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn end<V: Level>(
        &mut self,
        level: V,
        group: Group,
        _: &[Step<Number<E, 3>>],
        waiting: &mut Self::State<V>,
    ) {
        self.write::<V>(level, group, waiting);
    }
}

/// A [`Mechanism`] that owns its memory.
///
/// ```
/// use dq8_robot::{Joint, OwnedMechanism};
/// use dq8::DualQuat;
/// let up = DualQuat::from_translation([0.0_f32, 0.0, 1.0]);
/// let joints = [None, Some(0), Some(1)];
/// let joints = joints.map(|parent| Joint::revolute(parent, up, [1.0, 0.0, 0.0]));
/// let arm = OwnedMechanism::new(&joints)?;
/// let tool = arm.link_pose(&[0.0; 3], 2)?;
/// assert_eq!(tool.translation(), [0.0, 0.0, 3.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[cfg(feature = "alloc")]
#[derive(Clone)]
pub struct OwnedMechanism<R> {
    steps: Vec<Step<R>>,
    values: usize,
    rates: usize,
}

#[cfg(feature = "alloc")]
brief!([R] OwnedMechanism<R>: OwnedMechanism |it| {
    links: it.steps.len(), values: it.values, rates: it.rates,
});

#[cfg(feature = "alloc")]
impl<R: Real> OwnedMechanism<R> {
    /// Makes a mechanism from joints, as [`Mechanism::new`] does.
    ///
    /// # Errors
    /// The errors of [`Mechanism::new`].
    pub fn new(joints: &[Joint<R>]) -> Result<Self, MechanismError> {
        Self::of(joints.len(), |steps| Mechanism::new(joints, steps))
    }

    /// Makes a serial arm from screws, as [`Mechanism::from_screws`] does.
    ///
    /// # Errors
    /// The errors of [`Mechanism::from_screws`].
    pub fn from_screws(
        screws: &[(Screw<R>, [R; 2])],
        tool: DualQuat<R>,
    ) -> Result<Self, MechanismError> {
        Self::of(screws.len() + 1, |steps| Mechanism::from_screws(screws, tool, steps))
    }

    /// Makes a serial arm from a table of Denavit and Hartenberg, as [`Mechanism::from_dh`] does.
    ///
    /// # Errors
    /// The errors of [`Mechanism::from_dh`].
    pub fn from_dh(
        rows: &[Dh<R>],
        convention: DhConvention,
        tool: DualQuat<R>,
    ) -> Result<Self, MechanismError> {
        Self::of(rows.len() + 1, |steps| Mechanism::from_dh(rows, convention, tool, steps))
    }

    fn of(
        count: usize,
        make: impl for<'s> FnOnce(&'s mut [Step<R>]) -> Result<Mechanism<'s, R>, MechanismError>,
    ) -> Result<Self, MechanismError> {
        let mut steps = vec![Step::default(); count];
        let Mechanism { values, rates, .. } = make(&mut steps)?;
        Ok(Self { steps, values, rates })
    }

    /// Returns a job that computes many configurations, as [`Mechanism::job`] does.
    pub fn job(&self) -> Job<'_, R>
    where
        R: Copy,
    {
        self.view().job()
    }

    /// Returns the pose of one link, as [`Mechanism::link_pose`] does.
    ///
    /// # Errors
    /// The errors of [`Mechanism::link_pose`].
    pub fn link_pose(&self, values: &[R], link: usize) -> Result<DualQuat<R>, ShapeError> {
        self.view().link_pose(values, link)
    }

    /// Computes the poses of all links, as [`Mechanism::link_poses`] does.
    ///
    /// # Errors
    /// The errors of [`Mechanism::link_poses`].
    pub fn link_poses(&self, values: &[R], poses: &mut [DualQuat<R>]) -> Result<(), ShapeError> {
        self.view().link_poses(values, poses)
    }

    /// Returns a [`Mechanism`] that borrows the memory of this one. It has all other methods.
    #[must_use]
    pub fn view(&self) -> Mechanism<'_, R> {
        Mechanism { steps: &self.steps, values: self.values, rates: self.rates }
    }
}
