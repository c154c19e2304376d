use core::fmt::Debug;

/// In which axes, and about which point, the columns of a Jacobian are: [`World`], [`Body`] or
/// [`WorldAligned`]. The type of a column says which part comes first: `[R; 6]` and
/// [`Twist`](dq8::Twist) have the angular part first, [`LinearFirst`](dq8::storage::LinearFirst)
/// the linear one. Sealed.
pub trait JacobianFrame: Copy + Debug + sealed::Sealed {
    #[doc(hidden)]
    const FRAME: Frame;
}

/// The axes of the base, about its origin: spatial twists, J_s (Lynch & Park, *Modern Robotics*,
/// 2017, eq. 5.11).
#[derive(Clone, Copy, Debug, Default)]
pub struct World;
/// The axes of the link, about its origin: body twists, J_b (eq. 5.18).
#[derive(Clone, Copy, Debug, Default)]
pub struct Body;
/// The axes of the base, about the origin of the link: the velocity of that point, which most
/// controllers ask for.
#[derive(Clone, Copy, Debug, Default)]
pub struct WorldAligned;

/// The same as values, for code that is written once.
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
