//! What a joint multiplies the frame of its parent with.

use dq8::Real;
use dq8::scalar::Quat;

/// Whether something is about, or along, an axis of the frame: most of what robots have is, and
/// then most of a product is multiplication by zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Alignment {
    /// Zero: no rotation, or no translation.
    None,
    X,
    Y,
    Z,
    /// No axis.
    Any,
}

impl Alignment {
    pub(crate) fn of<R: Real>([x, y, z]: [R; 3]) -> Self {
        match [x, y, z].map(|number| number == R::ZERO) {
            [true, true, true] => Self::None,
            [false, true, true] => Self::X,
            [true, false, true] => Self::Y,
            [true, true, false] => Self::Z,
            _ => Self::Any,
        }
    }
}

/// x ↦ x e_K for the axes of the base: where each of the numbers x, y, z, w comes from, and its
/// sign.
pub(crate) const ORDER: [[usize; 4]; 3] = [[3, 2, 1, 0], [2, 3, 0, 1], [1, 0, 3, 2]];
pub(crate) const SIGNS: [[f32; 4]; 3] =
    [[1.0, 1.0, -1.0, -1.0], [-1.0, 1.0, 1.0, -1.0], [1.0, -1.0, 1.0, -1.0]];

/// A vector, and how it lies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way<R> {
    pub(crate) along: Alignment,
    pub(crate) vector: [R; 3],
}

impl<R: Real> Way<R> {
    const ZERO: Self = Self { along: Alignment::None, vector: [R::ZERO; 3] };

    pub(crate) fn new(vector: [R; 3]) -> Self {
        Self { along: Alignment::of(vector), vector }
    }
}

/// The quaternion v + w as a right factor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Factor<R> {
    pub(crate) v: Way<R>,
    pub(crate) w: R,
}

impl<R: Real> Factor<R> {
    pub(crate) const ONE: Self = Self { v: Way::ZERO, w: R::ONE };

    pub(crate) fn new([x, y, z, w]: [R; 4]) -> Self {
        Self { v: Way::new([x, y, z]), w }
    }

    pub(crate) fn quaternion(&self) -> Quat<R> {
        let [x, y, z] = self.v.vector;
        Quat::from_xyzw(x, y, z, self.w)
    }
}

/// What a joint does to such a frame.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Moves {
    Not,
    /// A hinge with a value of its own, about an axis of the base or another.
    AboutX,
    AboutY,
    AboutZ,
    AboutAny,
    /// What most robots have none of.
    Otherwise,
}

/// A joint between such frames.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Planned<R> {
    pub(crate) moves: Moves,
    /// The link's own frame where all values are zero.
    pub(crate) own: Factor<R>,
    /// Half the way from the parent.
    pub(crate) half_offset: Way<R>,
    /// The axis or normal of the joint.
    pub(crate) axis: Way<R>,
}

impl<R: Real> Planned<R> {
    pub(crate) const NONE: Self =
        Self { moves: Moves::Not, own: Factor::ONE, half_offset: Way::ZERO, axis: Way::ZERO };
}
