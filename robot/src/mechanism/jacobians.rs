//! Jacobians of links for many configurations, the frames in which Jacobians are given, and the
//! manipulability of a link.

use super::job::{Job, carries, first_carried, place_of, repeat};
use super::step::{JointScrews, Step};
use super::tree::Mechanism;
use super::values::{Group, JointValues};
use super::walk::{Task, Visit};
use core::fmt::Debug;
use dq8::batch::{DualQuat, vector};
use dq8::geometry::Twist;
use dq8::internal::Rows;
use dq8::storage::{Element, Layout, Number, Tile, identity, same_length};
use dq8::{Real, Scalar, ShapeError};
use dq8_simd::{Lanes, Level};

/// The axes and the reference point of the columns of a Jacobian: [`World`], [`Body`] or
/// [`WorldAligned`]. The element type of the columns decides which part comes first: `[R; 6]` and
/// [`Twist`](dq8::Twist) have the angular part first, [`LinearFirst`](dq8::storage::LinearFirst)
/// has the linear part first. The trait is sealed.
pub trait JacobianFrame: Copy + Debug + sealed::Sealed {
    #[doc(hidden)]
    const FRAME: Frame;
}

/// Columns in the axes of the base, about the origin of the base. They are spatial twists, J_s
/// (Lynch & Park, *Modern Robotics*, 2017, eq. 5.11).
#[derive(Clone, Copy, Debug, Default)]
pub struct World;
/// Columns in the axes of the link, about the origin of the link. They are body twists, J_b (Lynch
/// & Park, *Modern Robotics*, 2017, eq. 5.18).
#[derive(Clone, Copy, Debug, Default)]
pub struct Body;
/// Columns in the axes of the base, about the origin of the link. Their linear part is the velocity
/// of that origin, which most controllers ask for.
#[derive(Clone, Copy, Debug, Default)]
pub struct WorldAligned;

/// The three frames as values, for code that is compiled once for all frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(hidden)]
pub enum Frame {
    World,
    Body,
    WorldAligned,
}

impl JacobianFrame for World {
    const FRAME: Frame = Frame::World;
}
impl JacobianFrame for Body {
    const FRAME: Frame = Frame::Body;
}
impl JacobianFrame for WorldAligned {
    const FRAME: Frame = Frame::WorldAligned;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::World {}
    impl Sealed for super::Body {}
    impl Sealed for super::WorldAligned {}
}

impl<R: Scalar> Job<'_, R, &[usize]> {
    /// Computes the geometric Jacobians and the poses of the selected links for many
    /// configurations, in one pass. [`Mechanism::link_jacobian`] computes them for one link of one
    /// configuration.
    ///
    /// `values` is laid out as for [`Job::poses`]. `poses` is `[configuration][link]`, in the order
    /// of the selected links, and `columns` is `[configuration][link][rate]`; columns of joints
    /// that do not carry the link are zero. A column is `[R; 6]` or a [`Twist`], in the order
    /// `[ωx, ωy, ωz, vx, vy, vz]`, or a [`LinearFirst`](dq8::storage::LinearFirst), which has v
    /// before ω. Columns may also be in blocks. [`World`](crate::World) is the cheapest frame.
    ///
    /// # Errors
    /// If the slices hold different numbers of configurations, or there is no such link; nothing is
    /// written.
    ///
    /// ```
    /// use dq8_robot::{Joint, OwnedMechanism, WorldAligned};
    /// use dq8::DualQuat;
    /// let out = DualQuat::from_translation([2.0_f64, 0.0, 0.0]);
    /// let joints = [
    ///     Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]),
    ///     Joint::prismatic(Some(0), out, [1.0, 0.0, 0.0]),
    /// ];
    /// let crane = OwnedMechanism::new(&joints)?;
    /// let (mut tools, mut columns) = ([DualQuat::IDENTITY; 2], [[0.0; 6]; 4]);
    /// let values = [0.0, 0.0, 0.0, 1.0];
    /// crane.job().links(&[1]).jacobians(WorldAligned, &values, &mut tools, &mut columns)?;
    /// assert_eq!(columns[2], [0.0, 0.0, 1.0, 0.0, 3.0, 0.0]);
    /// assert_eq!(columns[3], [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn jacobians<F, T, E, C>(
        &self,
        _: F,
        values: &[T],
        poses: &mut [E],
        columns: &mut [C],
    ) -> Result<(), ShapeError>
    where
        F: JacobianFrame,
        E: Element<8, Layout: Layout<Real = R>>,
        T: JointValues<E::Layout>,
        C: Element<6, Layout = E::Layout>,
    {
        let (links, count) = (self.links, self.links.len());
        let run = self.check::<E::Layout, T>(values, ("poses", poses.len()), count)?;
        let (steps, rates) = (run.mechanism.steps, run.mechanism.rates);
        same_length("columns", columns.len(), poses.len() * rates)?;
        let (sums, frame) = (steps.iter().any(|step| step.mimics), F::FRAME);
        let outputs = ((&mut *poses, count), (columns, count * rates));
        run.walk(outputs, |_, ((poses, _), (columns, _)): (Rows<E>, Rows<C>)| {
            (run.within(poses), Jacobians { poses, columns, steps, links, rates, sums, frame })
        });
        repeat(links, poses);
        Ok(())
    }
}

struct Jacobians<'s, E: Element<8>, C> {
    poses: &'s mut [E],
    columns: &'s mut [C],
    steps: &'s [Step<Number<E, 8>>],
    links: &'s [usize],
    rates: usize,
    /// `true` if some columns are sums of the columns of a joint and of the joints that mimic it.
    sums: bool,
    /// The frame of the columns. It is a value and not a type parameter, so that the kernel is
    /// compiled once for all frames. The branch on the frame costs little next to the load and the
    /// store of a column.
    frame: Frame,
}

impl<E: Element<8>, C> Jacobians<'_, E, C> {
    /// Returns the place in the output (a [`Tile`]) of the column for a rate, in the Jacobian of
    /// the selected link at `index`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn place<V: Level>(&self, group: Group, index: usize, rate: usize) -> Tile {
        group.tile::<E::Layout, V>(index * self.rates + rate, self.links.len() * self.rates)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn carries(&self, position: usize, link: usize) -> bool {
        carries(self.steps, position, &[link])
    }
}

/// Columns are computed in the frame [`World`], in which a joint's column is the same for all links
/// that it carries, and stored for the first of these links. When a group of configurations ends,
/// the columns of the other links are made from these columns, and all columns are converted to the
/// requested frame.
impl<E, C> Task<E::Layout> for Jacobians<'_, E, C>
where
    E: Element<8>,
    C: Element<6, Layout = E::Layout>,
{
    type State<V: Level> = ();
    type Carried<V: Level> = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn start<V: Level>(&self, _: V) {}
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn base<V: Level>(_: V) {}

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn begin<V: Level>(
        &mut self,
        level: V,
        group: Group,
        steps: &[Step<Number<E, 8>>],
        (): &mut (),
    ) {
        let zero = vector::splat(level, [Number::<E, 8>::default(); 6]);
        for (position, step) in steps.iter().enumerate() {
            for (index, &link) in self.links.iter().enumerate() {
                if !step.mimics && (self.sums || !self.carries(position, link)) {
                    for rate in 0..step.kind.rates() {
                        let tile = self.place::<V>(group, index, step.rate as usize + rate);
                        C::store(zero, self.columns, tile);
                    }
                }
            }
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn skips(&self, steps: &[Step<Number<E, 8>>], position: usize) -> bool {
        !carries(steps, position, self.links)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link<V: Level>(&mut self, visit: &Visit<'_, E::Layout, V>, (): &(), (): &mut ()) {
        let Visit { level, group, step, ref frames } = *visit;
        let link = step.link as usize;
        let Some(position) = self.steps.get(link).map(|step| step.position as usize) else {
            return;
        };
        for rate in 0..step.kind.rates() {
            let column = frames.screw(step, rate);
            let rate = step.rate as usize + rate;
            if !self.sums {
                // The column is stored for one link only. With a loop over all links that the joint
                // carries, the compiler would spill the registers of the column to the stack.
                let first = first_carried(self.steps, position, self.links).unwrap_or(0);
                C::store(column.to_array(), self.columns, self.place::<V>(group, first, rate));
                let (at, count) = (first * self.rates + rate, self.links.len() * self.rates);
                group.prefetch_next::<E::Layout, V, C>(level, self.columns, at..at + 1, count);
                continue;
            }
            for (index, &link) in self.links.iter().enumerate() {
                let tile = self.place::<V>(group, index, rate);
                if self.carries(position, link)
                    && let Some(others) = C::load(level, self.columns, tile, &identity())
                {
                    let sum = column + Twist::from_array(others);
                    C::store(sum.to_array(), self.columns, tile);
                }
            }
        }
        if let Some(index) = place_of(self.links, link) {
            let tile = group.tile::<E::Layout, V>(index, self.links.len());
            E::store(frames.link.to_motion(), self.poses, tile);
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn end<V: Level>(&mut self, level: V, group: Group, steps: &[Step<Number<E, 8>>], (): &mut ()) {
        if self.frame == Frame::World && (self.sums || self.links.len() == 1) {
            return;
        }
        // The loop goes from the last link to the first: converting a link overwrites its columns,
        // from which the columns of later links are made.
        for (index, &link) in self.links.iter().enumerate().rev() {
            let tile = place_of(self.links, link).unwrap_or(index);
            let tile = group.tile::<E::Layout, V>(tile, self.links.len());
            let Some(pose) = E::load(level, self.poses, tile, &identity()) else { return };
            let pose = DualQuat::from_array(pose);
            let (back, origin) = (pose.conjugate(), pose.translation());
            for (position, step) in steps.iter().enumerate() {
                let sums = self.sums.then_some(index);
                let first = if self.carries(position, link) {
                    sums.or(first_carried(self.steps, position, self.links))
                } else {
                    sums
                };
                let Some(first) = first else { continue };
                if step.mimics || (self.frame == Frame::World && first == index) {
                    continue;
                }
                for rate in 0..step.kind.rates() {
                    let rate = step.rate as usize + rate;
                    let tile = self.place::<V>(group, first, rate);
                    let Some(column) = C::load(level, self.columns, tile, &identity()) else {
                        return;
                    };
                    let twist = Twist::from_array(column);
                    let twist = match self.frame {
                        Frame::World => twist,
                        Frame::Body => back.adjoint(twist),
                        Frame::WorldAligned => Twist { linear: twist.velocity_at(origin), ..twist },
                    };
                    let mut seen = twist.to_array();
                    if self.sums {
                        // The column of a joint that does not carry the link is zero, and must stay
                        // zero in every frame.
                        let zero = column[0].constant(0.0);
                        let [a, b, c, d, e, f] = column.map(|number| number.eq(zero));
                        seen = vector::select(a & b & c & d & e & f, column, seen);
                    }
                    C::store(seen, self.columns, self.place::<V>(group, index, rate));
                }
            }
        }
    }
}

impl<R: Real> Mechanism<'_, R> {
    /// Returns the manipulability of a link, w = √det(J Jᵀ) (Yoshikawa, *Manipulability of
    /// Robotic Mechanisms*, 1985, eq. 9). Up to a constant factor, w is the volume of the set of
    /// twists that the link can have if the vector of rates has at most length one. J is the whole
    /// Jacobian of six rows, so the unit is radians³ times lengths³, and w is the same in every
    /// [frame](super::JacobianFrame). At a singularity, where the link cannot move in every
    /// direction, w is zero up to rounding; it is always zero if there are fewer than six rates. It
    /// is NaN if the pose is NaN. `columns` is scratch memory with one element per rate, whose
    /// contents do not matter.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// // Three slides, and three hinges that meet in a point. They are singular if the second
    /// // hinge lays the third along the first.
    /// let [x, y, z] = [[1.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let here = DualQuat::IDENTITY;
    /// let wrist = OwnedMechanism::new(&[
    ///     Joint::prismatic(None, here, x),
    ///     Joint::prismatic(Some(0), here, y),
    ///     Joint::prismatic(Some(1), here, z),
    ///     Joint::revolute(Some(2), here, z),
    ///     Joint::revolute(Some(3), here, y),
    ///     Joint::revolute(Some(4), here, z),
    /// ])?;
    /// let mut columns = [Twist::ZERO; 6];
    /// let mut at = |bend: f64| {
    ///     wrist.view().manipulability(&[0.1, 0.2, 0.3, 0.4, bend, 0.5], 5, &mut columns)
    /// };
    /// assert!((at(0.3)? - 0.3_f64.sin()).abs() < 1e-15);
    /// assert!(at(0.0)? < 1e-15);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If `values` or `columns` does not have the length that the mechanism asks for, or there is
    /// no such link; `columns` is untouched.
    pub fn manipulability(
        &self,
        values: &[R],
        link: usize,
        columns: &mut [Twist<R>],
    ) -> Result<R, ShapeError> {
        self.link_jacobian(WorldAligned, values, link, columns)?;
        Ok(volume(columns))
    }
}

/// Returns √det(J Jᵀ) of the Jacobian with these columns, and overwrites them. The result is
/// the product of the lengths of the six rows, after each row was made orthogonal to the rows
/// before it (Gram–Schmidt). Near a singularity, computing the product J Jᵀ would lose half of
/// the digits.
fn volume<R: Real>(columns: &mut [Twist<R>]) -> R {
    // Six rows with fewer than six columns are linearly dependent, so the volume is zero.
    let mut volume = if columns.len() < 6 { R::ZERO } else { R::ONE };
    for first in 0..6 {
        let dot = |columns: &[Twist<R>], row: usize| {
            let rows = columns.iter().map(|column| column.to_array());
            rows.fold(R::ZERO, |sum, column| sum + column[first] * column[row])
        };
        let square = dot(columns, first);
        volume = volume * square.sqrt();
        for row in first + 1..6 {
            let along = dot(columns, row) / square;
            for column in columns.iter_mut().filter(|_| square > R::ZERO) {
                let mut rows = column.to_array();
                rows[row] = rows[row] - along * rows[first];
                *column = Twist::from_array(rows);
            }
        }
    }
    volume
}
