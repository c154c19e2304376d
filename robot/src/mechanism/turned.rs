//! The frames of one configuration, turned parallel to the base: four lanes hold a quaternion, p or q of the motion p + εq.
//!
//! Nothing is fused: the bits are the same on all targets.

use super::factor::{Alignment, Factor, Moves, ORDER, SIGNS};
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

/// What the vector of a [`Factor`] along no axis multiplies [`ordered`] numbers with.
#[inline(always)]
fn rows<R: Float>(vector: Four<R>) -> [Four<R>; 3] {
    let [x, y, z, _] = vector.to_array();
    let row = |k: usize, number: R| splat::<R>(number) * load(SIGNS[k].map(R::from));
    [row(0, x), row(1, y), row(2, z)]
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
    fn moved(self, along: Alignment, half: Four<R>) -> Self {
        let p = self.p;
        let added = match along {
            Alignment::None => return self,
            Alignment::X => ordered::<0, R>(p) * half,
            Alignment::Y => ordered::<1, R>(p) * half,
            Alignment::Z => ordered::<2, R>(p) * half,
            Alignment::Any => {
                let [x, y, z] = rows::<R>(half);
                ordered::<0, R>(p) * x + ordered::<1, R>(p) * y + ordered::<2, R>(p) * z
            }
        };
        Self { p, q: self.q + added }
    }

    /// Turned by the unit quaternion v + w.
    #[inline(always)]
    fn turned(self, about: Alignment, row: Four<R>, w: Four<R>) -> Self {
        match about {
            Alignment::None => self,
            Alignment::X => self.about::<0>(row, w),
            Alignment::Y => self.about::<1>(row, w),
            Alignment::Z => self.about::<2>(row, w),
            Alignment::Any => {
                let rows = rows::<R>(row);
                Self { p: product::<R>(self.p, rows, w), q: product::<R>(self.q, rows, w) }
            }
        }
    }

    #[inline(always)]
    fn about<const K: usize>(self, row: Four<R>, w: Four<R>) -> Self {
        let Self { p, q } = self;
        Self { p: p * w + ordered::<K, R>(p) * row, q: q * w + ordered::<K, R>(q) * row }
    }

    /// The pose of the link, whose own frame this is turned to.
    #[inline(always)]
    pub(crate) fn pose(self, own: &Factor<R>) -> DualQuat<R> {
        let own = self.turned(own.along, load(own.row), splat(own.w));
        DualQuat::from_array(own.to_array())
    }

    /// And back.
    #[inline(always)]
    pub(crate) fn of_pose(pose: &DualQuat<R>, own: &Factor<R>) -> Self {
        Self::new(pose.to_array()).turned(own.along, -load(own.row), splat(own.w))
    }

    /// From the frame of the parent to that of the joint.
    #[inline(always)]
    pub(crate) fn placed(self, step: &Step<R>) -> Self {
        let half_offset = &step.planned.half_offset;
        self.moved(half_offset.along, load(half_offset.row))
    }

    /// From the frame of the joint to that of the link.
    #[inline(always)]
    pub(crate) fn joined(self, step: &Step<R>, turns: &mut Turns<'_, R>) -> Self {
        let (at, planned) = (self, &step.planned);
        let mut turn = || {
            let [cos, sin] = turns.half_turn(step.value as usize);
            (load(planned.axis.row) * splat(sin), splat(cos))
        };
        match planned.moves {
            Moves::Not => at,
            Moves::AboutX => {
                let (row, cos) = turn();
                at.about::<0>(row, cos)
            }
            Moves::AboutY => {
                let (row, cos) = turn();
                at.about::<1>(row, cos)
            }
            Moves::AboutZ => {
                let (row, cos) = turn();
                at.about::<2>(row, cos)
            }
            Moves::AboutAny => {
                let (row, cos) = turn();
                at.turned(Alignment::Any, row, cos)
            }
            // By value: what is in memory here would be there for all.
            Moves::Otherwise => Self::new(otherwise(at.to_array(), step, turns.values)),
        }
    }

    /// Moved along the axis of a joint.
    fn slid(self, step: &Step<R>, length: R) -> Self {
        let axis = &step.planned.axis;
        self.moved(axis.along, load(axis.row) * splat(length * R::HALF))
    }

    /// Turned about it.
    fn hinged(self, step: &Step<R>, angle: R) -> Self {
        let axis = &step.planned.axis;
        let [cos, sin] = half_turn_of(angle);
        self.turned(axis.along, load(axis.row) * splat(sin), splat(cos))
    }
}

/// What most joints of a robot are not. Out of line: its constants would take the registers of what is in it.
#[cold]
#[inline(never)]
fn otherwise<R: Real + Number>(at: [R; 8], step: &Step<R>, values: &[R]) -> [R; 8] {
    let (at, own) = (Turned::new(at), step.planned.own.quaternion());
    let moved = |[x, y, z]: [R; 3]| {
        let [x, y, z] = own.rotate([x * R::HALF, y * R::HALF, z * R::HALF]);
        at.moved(Alignment::Any, load([x, y, z, R::ZERO]))
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
            let row = load([x, y, z, R::ZERO]);
            moved([tx, ty, tz]).turned(Alignment::Any, row, splat(w))
        }
    };
    at.to_array()
}
