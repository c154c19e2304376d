//! The frames of one configuration, turned parallel to the base: four lanes hold a quaternion, p or
//! q of the motion p + εq.
//!
//! Nothing is fused: the bits are the same on all targets.

use super::factor::{Alignment, Factor, Moves, ORDER, SIGNS, Way};
use super::joint::JointKind;
use super::step::Step;
use super::turns::{LEVEL, Turns, half_turn_of};
use dq8::Real;
use dq8::scalar::{DualQuat, Quat, vector};
use dq8::seams::Number;
use dq8_simd::{Float, Lanes, Portable, Unfused};

/// A quaternion.
pub(crate) type Four<R> = <R as Float>::Half<Unfused<Portable>>;

#[inline(always)]
pub(crate) fn splat<R: Float>(number: R) -> Four<R> {
    Lanes::splat(LEVEL, number)
}

#[inline(always)]
pub(crate) fn load<R: Float>(numbers: [R; 4]) -> Four<R> {
    Lanes::load(LEVEL, &numbers)
}

/// x e_K but for its signs.
#[inline(always)]
fn ordered<const K: usize, R: Float>(x: Four<R>) -> Four<R> {
    let (x, [a, b, c, d]) = (x.to_array(), ORDER[K]);
    load([x[a], x[b], x[c], x[d]])
}

/// What a number along an axis multiplies [`ordered`] numbers with.
#[inline(always)]
fn row<const K: usize, R: Float>(number: R) -> Four<R> {
    splat::<R>(number) * load(SIGNS[K].map(R::from))
}

/// What a vector along no axis multiplies them with.
#[inline(always)]
fn rows<R: Float>([x, y, z]: [R; 3]) -> [Four<R>; 3] {
    [row::<0, R>(x), row::<1, R>(y), row::<2, R>(z)]
}

/// x (v + w)
#[inline(always)]
fn product<R: Float>(x: Four<R>, [i, j, k]: [Four<R>; 3], w: Four<R>) -> Four<R> {
    (x * w + ordered::<0, R>(x) * i) + (ordered::<1, R>(x) * j + ordered::<2, R>(x) * k)
}

/// The turned frame of a link.
#[derive(Clone, Copy)]
pub(crate) struct Turned<R: Float> {
    p: Four<R>,
    q: Four<R>,
}

impl<R: Real + Number> Turned<R> {
    #[inline(always)]
    pub(crate) fn base() -> Self {
        Self::new([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0].map(R::from))
    }

    #[inline(always)]
    fn new([x, y, z, w, qx, qy, qz, qw]: [R; 8]) -> Self {
        Self { p: load([x, y, z, w]), q: load([qx, qy, qz, qw]) }
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [R; 8] {
        let ([x, y, z, w], [qx, qy, qz, qw]) = (self.p.to_array(), self.q.to_array());
        [x, y, z, w, qx, qy, qz, qw]
    }

    /// Moved by a vector in its own axes, of which half is given: q + p h.
    #[inline(always)]
    fn moved(self, along: Alignment, half: [R; 3]) -> Self {
        let (p, [x, y, z]) = (self.p, half);
        let added = match along {
            Alignment::None => return self,
            Alignment::X => ordered::<0, R>(p) * row::<0, R>(x),
            Alignment::Y => ordered::<1, R>(p) * row::<1, R>(y),
            Alignment::Z => ordered::<2, R>(p) * row::<2, R>(z),
            Alignment::Any => {
                let [x, y, z] = rows(half);
                ordered::<0, R>(p) * x + ordered::<1, R>(p) * y + ordered::<2, R>(p) * z
            }
        };
        Self { p, q: self.q + added }
    }

    /// Turned by the unit quaternion v + w.
    #[inline(always)]
    fn turned(self, about: Alignment, v: [R; 3], w: R) -> Self {
        let [x, y, z] = v;
        match about {
            Alignment::None => self,
            Alignment::X => self.about::<0>(x, w),
            Alignment::Y => self.about::<1>(y, w),
            Alignment::Z => self.about::<2>(z, w),
            Alignment::Any => {
                let (rows, w) = (rows(v), splat(w));
                Self { p: product::<R>(self.p, rows, w), q: product::<R>(self.q, rows, w) }
            }
        }
    }

    #[inline(always)]
    fn about<const K: usize>(self, along: R, w: R) -> Self {
        let Self { p, q } = self;
        let (row, w) = (row::<K, R>(along), splat(w));
        Self { p: p * w + ordered::<K, R>(p) * row, q: q * w + ordered::<K, R>(q) * row }
    }

    /// The pose of the link, whose own frame this is turned to.
    #[inline(always)]
    pub(crate) fn pose(self, own: &Factor<R>) -> DualQuat<R> {
        let own = self.turned(own.v.along, own.v.vector, own.w);
        DualQuat::from_array(own.to_array())
    }

    /// And back.
    #[inline(always)]
    pub(crate) fn of_pose(pose: &DualQuat<R>, own: &Factor<R>) -> Self {
        Self::new(pose.to_array()).turned(own.v.along, own.v.vector.map(|c| -c), own.w)
    }

    /// From the frame of the parent to that of the joint.
    #[inline(always)]
    pub(crate) fn placed(self, step: &Step<R>) -> Self {
        let half_offset = &step.planned.half_offset;
        self.moved(half_offset.along, half_offset.vector)
    }

    /// From the frame of the joint to that of the link.
    #[inline(always)]
    pub(crate) fn joined(self, step: &Step<R>, turns: &mut Turns<'_, R>) -> Self {
        let (at, [x, y, z]) = (self, step.planned.axis.vector);
        let mut turn = || turns.half_turn(step.value as usize);
        match step.planned.moves {
            Moves::Not => at,
            Moves::AboutX => {
                let [cos, sin] = turn();
                at.about::<0>(x * sin, cos)
            }
            Moves::AboutY => {
                let [cos, sin] = turn();
                at.about::<1>(y * sin, cos)
            }
            Moves::AboutZ => {
                let [cos, sin] = turn();
                at.about::<2>(z * sin, cos)
            }
            Moves::AboutAny => {
                let [cos, sin] = turn();
                at.turned(Alignment::Any, [x * sin, y * sin, z * sin], cos)
            }
            // By value: what is in memory here would be there for all.
            Moves::Otherwise => Self::new(otherwise(at.to_array(), step, turns.values)),
        }
    }

    /// Moved along the axis of a joint.
    fn slid(self, step: &Step<R>, length: R) -> Self {
        let Way { along, vector } = step.planned.axis;
        self.moved(along, vector::scale(vector, length * R::HALF))
    }

    /// Turned about it.
    fn hinged(self, step: &Step<R>, angle: R) -> Self {
        let Way { along, vector } = step.planned.axis;
        let [cos, sin] = half_turn_of(angle);
        self.turned(along, vector::scale(vector, sin), cos)
    }
}

/// What most joints of a robot are not. Out of line: its constants would take the registers of what
/// is in it.
#[cold]
#[inline(never)]
fn otherwise<R: Real + Number>(at: [R; 8], step: &Step<R>, values: &[R]) -> [R; 8] {
    let (at, own) = (Turned::new(at), step.planned.own.quaternion());
    let moved = |[x, y, z]: [R; 3]| {
        at.moved(Alignment::Any, own.rotate([x * R::HALF, y * R::HALF, z * R::HALF]))
    };
    let at = match step.kind {
        JointKind::Fixed => at,
        JointKind::Revolute { .. } => at.hinged(step, step.single(values)),
        JointKind::Prismatic { .. } => at.slid(step, step.single(values)),
        JointKind::Screw { pitch, .. } => {
            let angle = step.single(values);
            at.slid(step, angle * pitch).hinged(step, angle)
        }
        JointKind::Planar { .. } => {
            let [x, y, angle] = Step::numbers(step.value, values);
            let [first, second] = step.plane;
            let slide = vector::add(vector::scale(first, x), vector::scale(second, y));
            moved(slide).hinged(step, angle)
        }
        JointKind::Floating => {
            let [x, y, z, w, tx, ty, tz] = Step::numbers(step.value, values);
            let turn = own * Quat::from_xyzw(x, y, z, w).normalize() * own.conjugate();
            let [x, y, z, w] = turn.to_array();
            moved([tx, ty, tz]).turned(Alignment::Any, [x, y, z], w)
        }
    };
    at.to_array()
}
