//! Points that links carry: spheres of a collision model, feet, sensors.

use super::Job;
use super::configuration::{Found, LinkPoints, Point};
use super::group::Group;
use super::job::things;
use super::step::Step;
use super::tree::Mechanism;
use super::values::JointValues;
use super::walk::{Joined, Task};
use dq8::batch::{Quat, vector};
use dq8::storage::{Element, Layout, Number, same_length, whole_instances};
use dq8::{Real, Scalar, ShapeError};
use dq8_simd::{Level, Records};

impl<R: Real> Mechanism<'_, R> {
    /// Where points on links are, in the frame of the base. `points` name the link and the place in
    /// its frame, in any order; in the order of the links they are found sooner.
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
    /// If there are not as many values as the mechanism has or as many places as points, or there
    /// is no such link; `places` is untouched.
    pub fn link_points(
        &self,
        values: &[R],
        points: &[(usize, [R; 3])],
        places: &mut [[R; 3]],
    ) -> Result<(), ShapeError> {
        same_length("values", values.len(), self.values)?;
        same_length("places", places.len(), points.len())?;
        self.check_points(points)?;
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

    fn check_points(&self, points: &[Point<R>]) -> Result<(), ShapeError> {
        let links = self.links();
        match points.iter().find(|(link, _)| *link >= links) {
            Some(&(link, _)) => Err(ShapeError::NoLink { link, links }),
            None => Ok(()),
        }
    }
}

impl<R: Scalar> Job<'_, R> {
    /// Where points on links are for many configurations, in one pass and without poses in memory:
    /// what [`Mechanism::link_points`] gives for one.
    ///
    /// `places` is `[configuration][point]` in the order of `points`: `[R; 3]`, or blocks.
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
    /// If there is no such link, `places` holds no whole number of configurations or `values`
    /// another number of them; `places` is untouched.
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
        let mechanism = self.mechanism;
        mechanism.check_points(points)?;
        let elements = whole_instances("places", points.len(), places.len())?;
        T::check("values", values, mechanism.values, elements)?;
        self.walk(values, (places, points.len()), |_, (places, count): (&mut [E], usize)| {
            (things(places, count, elements), Points { places, found: Found::new(points) })
        });
        Ok(())
    }
}

struct Points<'s, E: Element<3>> {
    places: &'s mut [E],
    found: Found<'s, Number<E, 3>>,
}

/// Places of points that follow each other. Three numbers of a point are no register that can be
/// written at once, but the twelve of four points are three: a quarter of the stores, which are
/// most of the time where places lie plainly.
struct Waiting<L> {
    first: usize,
    count: usize,
    places: [[L; 3]; FOUR],
}

/// As many points wait.
const FOUR: usize = 4;

type Numbers<E, V> = <<E as Element<3>>::Layout as Layout>::Register<V>;

impl<E: Element<3>> Points<'_, E> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn write<V: Level>(&mut self, level: V, group: Group, waiting: &mut Waiting<Numbers<E, V>>) {
        let (all, first) = (self.found.points.len(), waiting.first);
        let count = core::mem::take(&mut waiting.count);
        group.prefetch_next::<E::Layout, V, E>(level, self.places, first..first + count, all);
        let plain = E::plain_mut(self.places).map(<[_]>::as_flattened_mut);
        let start = 3 * (group.first * all + first);
        let row = plain.and_then(|plain| plain.get_mut(start..));
        if let (FOUR, Some(row)) = (count, row) {
            let [[a, b, c], [d, e, f], [g, h, i], [j, k, l]] = waiting.places;
            let quads = [[a, b, c, d], [e, f, g, h], [i, j, k, l]];
            if Numbers::<E, V>::store_rows(quads, row, 3 * all) {
                return;
            }
        }
        for (ahead, place) in waiting.places.iter().enumerate().take(count) {
            E::store(*place, self.places, group.tile::<E::Layout, V>(first + ahead, all));
        }
    }
}

impl<E: Element<3>> Task<E::Layout> for Points<'_, E> {
    type State<V: Level> = Waiting<Numbers<E, V>>;
    type Carried<V: Level> = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, level: V) -> Self::State<V> {
        let zero = vector::splat(level, [Number::<E, 3>::default(); 3]);
        Waiting { first: 0, count: 0, places: [zero; FOUR] }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(_: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(
        &mut self,
        level: V,
        group: Group,
        step: &Step<Number<E, 3>>,
        joined: &Joined<<E::Layout as Layout>::Register<V>>,
        (): &(),
        waiting: &mut Self::State<V>,
    ) {
        let (link, points) = (step.link as usize, self.found.points);
        let some = self.found.of(link);
        if some.is_empty() {
            return;
        }
        let [hx, hy, hz] = joined.pose.half;
        let origin = [hx + hx, hy + hy, hz + hz];
        let [a, b, c] = Quat::from_array(joined.pose.rotation).to_matrix3();
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
