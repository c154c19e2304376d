use super::error::MechanismError;
use super::factor::{Alignment, Planned};
use super::joint::{Joint, JointKind};
use dq8::Real;
use dq8::scalar::{DualQuat, Quat, vector};

/// How far axes, placements and targets may be from unit: numbers that people type with four
/// decimals are nearer.
pub(crate) const UNIT: f32 = 1e-3;

/// No such link, value or rate.
pub(crate) const NONE: u32 = u32::MAX;

/// A joint as kernels use it, in the memory that a [`Mechanism`](super::Mechanism) borrows.
#[derive(Clone, Copy, Debug)]
pub struct Step<R> {
    /// The placement as lanes need it: rotation, and half the translation.
    pub(crate) rotation: [R; 4],
    pub(crate) half_offset: [R; 3],
    /// Which axes the two are about and along.
    pub(crate) turned: Alignment,
    pub(crate) shifted: Alignment,
    /// With axes that are exactly unit.
    pub(crate) kind: JointKind<R>,
    pub(crate) axis: [R; 3],
    /// The two directions of a planar joint.
    pub(crate) plane: [[R; 3]; 2],
    pub(crate) aligned: Alignment,
    /// Which way the axis points along the one it is aligned with; 1 where there is none.
    pub(crate) sign: R,
    /// Value of the joint = multiplier · value number `value` + offset.
    pub(crate) multiplier: R,
    pub(crate) offset: R,
    /// The same of half the value, about or along the aligned axis where that is positive.
    pub(crate) half_multiplier: R,
    pub(crate) half_bias: R,
    pub(crate) planned: Planned<R>,
    pub(crate) limits: Option<[R; 2]>,
    pub(crate) mimics: bool,
    /// The first of its values and rates among all.
    pub(crate) value: u32,
    pub(crate) rate: u32,
    /// The number of the joint among those of the caller, and that of its parent.
    pub(crate) link: u32,
    pub(crate) parent: u32,
    /// While steps are put in order, where this one goes; then, in step i, where that of link i is.
    pub(crate) position: u32,
    /// How many steps from here on belong to this link and what it carries.
    pub(crate) size: u32,
    /// While steps are put in order: the link that carries most of that, and the next place for
    /// another.
    pub(crate) largest: u32,
    pub(crate) free: u32,
    /// Where the pose is kept for the children, and where that of the parent is.
    pub(crate) slot: u8,
    pub(crate) parent_slot: u8,
}

impl<R: Real> Default for Step<R> {
    /// Memory to be written.
    fn default() -> Self {
        Self {
            rotation: [R::ZERO, R::ZERO, R::ZERO, R::ONE],
            half_offset: [R::ZERO; 3],
            turned: Alignment::None,
            shifted: Alignment::None,
            kind: JointKind::Fixed,
            axis: [R::ZERO; 3],
            plane: [[R::ZERO; 3]; 2],
            aligned: Alignment::None,
            sign: R::ONE,
            multiplier: R::ONE,
            offset: R::ZERO,
            half_multiplier: R::HALF,
            half_bias: R::ZERO,
            planned: Planned::NONE,
            limits: None,
            mimics: false,
            value: NONE,
            rate: NONE,
            link: NONE,
            parent: NONE,
            position: NONE,
            size: 1,
            largest: NONE,
            free: 0,
            slot: 0,
            parent_slot: 0,
        }
    }
}

impl<R: Real> Step<R> {
    /// Joint number `index`, checked but for what other joints have to do with it.
    pub(crate) fn of(joint: &Joint<R>, index: usize) -> Result<Self, MechanismError> {
        let mut step = Self::default();
        step.place(joint.placement, index)?;
        step.kind = joint.kind;
        if let JointKind::Screw { pitch, .. } = step.kind {
            finite(pitch, "pitch", index)?;
        }
        if let JointKind::Revolute { axis }
        | JointKind::Prismatic { axis }
        | JointKind::Screw { axis, .. }
        | JointKind::Planar { normal: axis } = &mut step.kind
        {
            *axis = unit(*axis, index)?;
            step.axis = *axis;
        }
        step.aligned = Alignment::of(step.axis);
        let [x, y, z] = step.axis;
        if step.aligned != Alignment::Any && x + y + z < R::ZERO {
            step.sign = -R::ONE;
        }
        if let JointKind::Planar { normal } = step.kind {
            let turn = from_z(normal);
            let (x, y) = ([R::ONE, R::ZERO, R::ZERO], [R::ZERO, R::ONE, R::ZERO]);
            step.plane = [turn.rotate(x), turn.rotate(y)];
        }
        if let Some(mimic) = joint.mimic {
            finite(mimic.multiplier, "multiplier", index)?;
            finite(mimic.offset, "offset", index)?;
            (step.multiplier, step.offset, step.mimics) = (mimic.multiplier, mimic.offset, true);
        }
        if let Some([low, high]) = joint.limits {
            if !(low <= high && step.kind.values() == 1) {
                let (low, high) = (low.into(), high.into());
                return Err(MechanismError::Limits { joint: index, low, high });
            }
            step.limits = joint.limits;
        }
        step.half_multiplier = R::HALF * step.multiplier * step.sign;
        step.half_bias = R::HALF * step.offset * step.sign;
        Ok(step)
    }

    /// Where the frame of the joint is in that of the parent.
    #[inline]
    pub(crate) fn placement(&self) -> DualQuat<R> {
        let rotation = Quat::from_array(self.rotation);
        DualQuat::from_rotation_translation(rotation, vector::scale(self.half_offset, R::TWO))
    }

    fn place(&mut self, placement: DualQuat<R>, index: usize) -> Result<(), MechanismError> {
        let norm = norm(placement.real());
        if is_far_from_one(norm) {
            return Err(MechanismError::Placement { joint: index, norm: norm.into() });
        }
        let (along, size) = (placement.real().dot(placement.dual()), self::norm(placement.dual()));
        if along.abs() > R::from(UNIT) * size.max_or_nan(R::ONE) {
            return Err(MechanismError::DualPart { joint: index, along: along.into() });
        }
        let placement = if placement.is_normalized() { placement } else { placement.normalize() };
        let mut rotation = placement.rotation().to_array();
        let mut translation = placement.translation();
        for number in translation {
            finite(number, "translation", index)?;
        }
        // The cosine of a quarter turn, as floats have it, is no more than rounding.
        for number in &mut rotation {
            if number.abs() <= R::EPSILON {
                *number = R::ZERO;
            }
        }
        // A negative zero is none either.
        for number in &mut translation {
            *number += R::ZERO;
        }
        let [x, y, z, _] = rotation;
        (self.turned, self.shifted) = (Alignment::of([x, y, z]), Alignment::of(translation));
        self.rotation = rotation;
        self.half_offset = vector::scale(translation, R::HALF);
        Ok(())
    }
}

/// The shortest rotation that takes z to a unit vector.
fn from_z<R: Real>([x, y, z]: [R; 3]) -> Quat<R> {
    if x == R::ZERO && y == R::ZERO {
        let about_x = if z < R::ZERO { R::ONE } else { R::ZERO };
        return Quat::from_xyzw(about_x, R::ZERO, R::ZERO, R::ONE - about_x);
    }
    // z × n and 1 + z·n, which cancels near −z; there x and y tell the angle better.
    let across = vector::norm([x, y]);
    let w = if z < R::ZERO { across * across / (R::ONE - z) } else { R::ONE + z };
    Quat::from_xyzw(-y, x, R::ZERO, w).normalize()
}

/// The norm: once in machine code.
#[inline(never)]
fn norm<R: Real>(quaternion: Quat<R>) -> R {
    quaternion.norm()
}

/// NaN is too.
fn is_far_from_one<R: Real>(length: R) -> bool {
    let near = (length - R::ONE).abs() <= R::from(UNIT);
    !near
}

// Once in machine code, not for each kind of joint.
#[inline(never)]
pub(crate) fn unit<R: Real>(axis: [R; 3], index: usize) -> Result<[R; 3], MechanismError> {
    let length = vector::norm(axis);
    if is_far_from_one(length) {
        return Err(MechanismError::Axis { joint: index, length: length.into() });
    }
    Ok(vector::over_norm(axis, length))
}

pub(crate) fn finite<R: Real>(
    value: R,
    what: &'static str,
    index: usize,
) -> Result<(), MechanismError> {
    if value.is_finite() {
        return Ok(());
    }
    Err(MechanismError::NotFinite { joint: index, what, value: value.into() })
}
