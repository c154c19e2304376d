//! The one loop over times: find their segments, some dozens at a time; then compute on lanes, a
//! time in each.
//!
//! # The algorithm
//!
//! [`CHUNK`] times are looked up first, in `f64`. Where all lie in one segment, which is the rule
//! for times that rise, its record is read once, into all lanes. Elsewhere a register whose lanes
//! lie in several segments gathers a record for each. The [`Work`] takes a register of times with
//! its records; it does the same arithmetic in both cases, so the bits of a pose or point do not
//! depend on its neighbours.

use crate::clock::{Clock, Time};
use crate::screw::Screw;
use crate::segments::{CHUNK, Found, Segments};
use crate::stretches::Record;
use dq8::batch::{self, vector};
use dq8::simd::Records;
use dq8::simd::internal::Gather;
use dq8::storage::{self, Element, Layout, Register, Tile};
use dq8::{Kernel, Lanes, Level, Scalar, Twist};

/// What is done with a register of times.
pub(crate) trait Work<Y: Layout, const C: usize> {
    /// With AVX-512 the compiler makes gathers of the search, which takes twice as long: for work
    /// that takes much longer.
    const WIDE: bool = false;

    /// Takes the records of the segments that the times are in, and the seconds since their start.
    /// `None` ends the loop.
    fn tile<V: Level>(
        &mut self,
        level: V,
        tile: Tile,
        records: [Y::Register<V>; C],
        since: Y::Register<V>,
    ) -> Option<()>;
}

pub(crate) struct Along<'a, Y: Layout, T, W, const C: usize> {
    pub(crate) segments: &'a Segments<Y::Real, C>,
    pub(crate) clock: Clock,
    /// The memory that [`Segments::place`] takes.
    pub(crate) stands: bool,
    pub(crate) times: &'a [T],
    /// The length of the output.
    pub(crate) elements: usize,
    pub(crate) work: W,
}

impl<Y: Layout, T: Time, W: Work<Y, C>, const C: usize> Kernel for Along<'_, Y, T, W, C> {
    type Output = ();
    const WIDE: bool = W::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let _ = self.all(level);
    }
}

impl<Y: Layout, T: Time, W: Work<Y, C>, const C: usize> Along<'_, Y, T, W, C> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn all<V: Level>(mut self, level: V) -> Option<()> {
        let mut tiles = storage::tiles::<Y::Record<1>, V, 1>(self.elements);
        let lanes = Y::Register::<V>::LANES;
        let mut found = Found { records: [0; CHUNK], since: [Y::Real::default(); CHUNK] };
        let mut near = 0;
        for times in self.times.chunks(CHUNK) {
            let one = self.segments.place(self.clock, times, near, self.stands, &mut found);
            let registers = found.since.chunks_exact(lanes).zip(found.records.chunks_exact(lanes));
            if let Some(record) = one {
                near = record;
                let records = vector::splat(level, *self.segments.records.get(record)?);
                for (since, _) in registers.take(times.len().div_ceil(lanes)) {
                    self.work.tile(level, tiles.next()?, records, register(level, since))?;
                }
                continue;
            }
            for (since, which) in registers.take(times.len().div_ceil(lanes)) {
                let table = &self.segments.records;
                let first = *which.first()?;
                let mut one = true;
                for &other in which {
                    one &= other == first;
                }
                let records = if one {
                    vector::splat(level, *table.get(first as usize)?)
                } else {
                    let rows = Gather::new(which, 1).rows::<Y::Register<V>, C>(0)?;
                    Y::Register::<V>::load_gathered(level, table, &rows, 0)?
                };
                self.work.tile(level, tiles.next()?, records, register(level, since))?;
            }
            near = *found.records.last()? as usize;
        }
        Some(())
    }
}

/// As many numbers as there are lanes.
#[cfg_attr(not(opt_level_0), inline(always))]
fn register<L: Lanes>(level: L::Level, numbers: &[L::Real]) -> L {
    let mut array = L::splat(level, L::Real::default()).to_array();
    for (slot, &number) in array.as_mut().iter_mut().zip(numbers) {
        *slot = number;
    }
    L::load(level, &array)
}

/// The numbers of a record that moves points: a 3×4 matrix by rows, a twist for one second, and
/// two that fill fours.
pub(crate) const MOVES: usize = 20;

/// Such a record, of a pose or of its inverse.
pub(crate) struct Moves<const BACK: bool>;

impl<const BACK: bool> Record<MOVES> for Moves<BACK> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn of<L: Lanes>(pose: batch::DualQuat<L>, velocity: Twist<L>) -> [L; MOVES] {
        let pose = if BACK { pose.conjugate() } else { pose };
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l]] = pose.to_matrix3x4();
        let [m, n, o, p, q, r] = velocity.to_array();
        let zero = a.constant(0.0);
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, zero, zero]
    }
}

/// `moved[i]` = M exp(τξ) `points[i]`: points of the moving body into the wanted frame. Or back,
/// where the records have M⁻¹: exp(−τξ) M⁻¹ `points[i]`.
pub(crate) struct Points<'s, P, const BACK: bool, const N: usize> {
    /// `None` if they are what `moved` still holds.
    pub(crate) points: Option<&'s [P]>,
    pub(crate) moved: &'s mut [P],
}

impl<P: Element<N>, const BACK: bool, const N: usize> Work<P::Layout, MOVES>
    for Points<'_, P, BACK, N>
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tile<V: Level>(
        &mut self,
        level: V,
        tile: Tile,
        records: [Register<P, V, N>; MOVES],
        since: Register<P, V, N>,
    ) -> Option<()> {
        let [a, b, c, d, e, f, g, h, i, j, k, l, twist @ .., _, _] = records;
        let rows = [[a, b, c, d], [e, f, g, h], [i, j, k, l]];
        let screw = Screw::new(twist);
        let mut numbers =
            P::load(level, self.points.unwrap_or(self.moved), tile, &storage::identity())?;
        let point = [numbers[0], numbers[1], numbers[2]];
        let [x, y, z] = if BACK {
            screw.moved(-since, affine(rows, point))
        } else {
            affine(rows, screw.moved(since, point))
        };
        (numbers[0], numbers[1], numbers[2]) = (x, y, z);
        P::store(numbers, self.moved, tile);
        Some(())
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn affine<L: Lanes>(rows: [[L; 4]; 3], [x, y, z]: [L; 3]) -> [L; 3] {
    let [[a, b, c, u], [d, e, f, v], [g, h, i, w]] = rows;
    [
        z.mul_add(c, y.mul_add(b, x.mul_add(a, u))),
        z.mul_add(f, y.mul_add(e, x.mul_add(d, v))),
        z.mul_add(i, y.mul_add(h, x.mul_add(g, w))),
    ]
}

/// The numbers of a record that is sampled: a motion, a twist for one second, and two that fill
/// fours.
pub(crate) const SAMPLES: usize = 16;

/// Such a record.
pub(crate) struct Samples;

impl Record<SAMPLES> for Samples {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn of<L: Lanes>(pose: batch::DualQuat<L>, velocity: Twist<L>) -> [L; SAMPLES] {
        let [a, b, c, d, e, f, g, h] = pose.to_array();
        let [i, j, k, l, m, n] = velocity.to_array();
        let zero = a.constant(0.0);
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, zero, zero]
    }
}

/// `poses[i]` = σ exp(τξ), and `twists[i]` = ξ.
pub(crate) struct Poses<'s, M, W> {
    pub(crate) poses: &'s mut [M],
    /// As many, or none.
    pub(crate) twists: &'s mut [W],
}

impl<M: Element<8>, W: Element<6, Layout = M::Layout>> Work<M::Layout, SAMPLES>
    for Poses<'_, M, W>
{
    const WIDE: bool = true;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tile<V: Level>(
        &mut self,
        _: V,
        tile: Tile,
        records: [Register<M, V, 8>; SAMPLES],
        since: Register<M, V, 8>,
    ) -> Option<()> {
        let [a, b, c, d, e, f, g, h, twist @ .., _, _] = records;
        let start = batch::DualQuat::from_array([a, b, c, d, e, f, g, h]);
        let twist = Twist::from_array(twist);
        let pose = start * batch::DualQuat::from_twist(twist.scale(since));
        M::store(pose.to_array(), self.poses, tile);
        if !self.twists.is_empty() {
            W::store(twist.to_array(), self.twists, tile);
        }
        Some(())
    }
}

/// Points whose columns share a pose: `moved[row][column]` = σ(column) `points[row][column]`.
pub(crate) struct Scan<'s, R: Scalar, const N: usize> {
    pub(crate) poses: &'s [dq8::DualQuat<R>],
    pub(crate) points: &'s [[R; N]],
    pub(crate) moved: &'s mut [[R; N]],
}

impl<R: Scalar, const N: usize> Kernel for Scan<'_, R, N> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let columns = self.poses.len().max(1);
        for (points, moved) in self.points.chunks(columns).zip(self.moved.chunks_mut(columns)) {
            for tile in storage::tiles::<[R; N], V, N>(moved.len()) {
                let padding = &storage::identity();
                let Some(pose) = Element::load(level, self.poses, tile, padding) else { return };
                let padding = &storage::identity();
                let Some(mut numbers) = <[R; N]>::load(level, points, tile, padding) else {
                    return;
                };
                let point = [numbers[0], numbers[1], numbers[2]];
                let [x, y, z] = batch::DualQuat::from_array(pose).transform_point(point);
                (numbers[0], numbers[1], numbers[2]) = (x, y, z);
                <[R; N]>::store(numbers, moved, tile);
            }
        }
    }
}
