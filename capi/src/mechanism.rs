//! Mechanisms: a tree of joints, made once in memory of the caller; then poses of links and
//! Jacobians.

use crate::joint::{Fault, Joint, fault};
use crate::memory::{Input, Output, Room, bytes, place};
use crate::span::{Span, apart};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::{DualQuat, Real, Twist};
use dq8_robot::{Body, JointKind, World, WorldAligned};

/// In which axes, and about which point, the columns of a Jacobian are.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The axes of the base, about its origin: spatial twists.
    World = 0,
    /// The axes of the link, about its origin: body twists.
    Body = 1,
    /// The axes of the base, about the origin of the link.
    WorldAligned = 2,
}

/// Memory for a joint of a mechanism; what is in it is the library's business.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Step<R> {
    /// Not for you.
    opaque: [R; 100],
}

/// A mechanism that has been made. It may be copied and moved; its steps must stay where they are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Mechanism<R> {
    /// How many links it has: one for each joint.
    pub links: usize,
    /// How many values a configuration has: those of joint 0, then those of joint 1, and so on.
    pub values: usize,
    /// How many rates, and columns of a Jacobian: as many as values, but six for a floating joint.
    pub rates: usize,
    /// Null in a mechanism that has not been made, if it was zeroed.
    steps: *const Step<R>,
    /// Not for you.
    opaque: [*const Step<R>; 4],
}

type Known<R> = dq8_robot::Mechanism<'static, R>;

/// Whether what the library keeps fits the memory that C has for it: steps, behind them the joints
/// while they are checked, and what it takes to align each of the two.
macro_rules! fits {
    ($($R:ident)*) => {$(const _: () = {
        let joints = size_of::<dq8_robot::Joint<$R>>() + align_of::<dq8_robot::Joint<$R>>();
        let steps = size_of::<dq8_robot::Step<$R>>() + align_of::<dq8_robot::Step<$R>>();
        assert!(steps + joints <= size_of::<Step<$R>>());
        assert!(size_of::<Known<$R>>() <= 4 * size_of::<*const ()>());
        assert!(align_of::<Known<$R>>() <= align_of::<*const ()>());
    };)*};
}
fits! { f32 f64 }

/// The mechanism of these joints in `room`, which holds a [`Step`] for each of them.
fn known<'a, R: Real>(
    joints: &[Joint<R>],
    room: &'a mut Room,
) -> Result<dq8_robot::Mechanism<'a, R>, Fault> {
    let count = joints.len();
    // Both fit, by `fits`: the compiler does not know that.
    let small = (Status::TooLarge, None);
    let (steps, rest) = place(room, count, dq8_robot::Step::default()).ok_or(small)?;
    let any = dq8_robot::Joint::new(None, DualQuat::IDENTITY, JointKind::Fixed);
    let (known, _) = place(rest, count, any).ok_or(small)?;
    for (index, (given, known)) in joints.iter().zip(&mut *known).enumerate() {
        *known = given.known(count).map_err(|status| (status, Some(index)))?;
    }
    dq8_robot::Mechanism::new(known, steps).map_err(|error| fault(&error))
}

/// # Safety
/// As for [`Input::slice`], [`Output::slice`] and [`Output::write`].
unsafe fn make<R: Real>(
    joints: *const Joint<R>,
    count: usize,
    steps: *mut Step<R>,
    mechanism: *mut Mechanism<R>,
    bad_joint: *mut usize,
) -> Done {
    let joints = Input::<Joint<R>>::new(joints, count)?;
    let steps = Output::<MaybeUninit<Step<R>>>::new(steps, count)?;
    let made = Output::<Mechanism<R>>::new(mechanism, 1)?;
    let bad_joint = Output::<usize>::unless_null(bad_joint)?;
    apart(&[steps.span, made.span, bad_joint.span], &[joints.span])?;
    // SAFETY: promised, and apart.
    let (joints, room) = unsafe { (joints.slice(), steps.slice()) };
    // Not null where there are none: that is a mechanism that has not been made.
    let steps = room.as_ptr().cast();
    // What is made lives as long as C keeps its steps.
    let known: Known<R> = match known(joints, bytes(room)) {
        Ok(known) => known,
        Err((status, joint)) => {
            if let Some(joint) = joint {
                // SAFETY: promised, and apart.
                unsafe { bad_joint.write(joint) };
            }
            return Err(status);
        }
    };
    let (links, values, rates) = (known.links(), known.values(), known.rates());
    // SAFETY: promised, and apart; a mechanism of the library fits, by `fits`.
    unsafe {
        made.write(Mechanism { links, values, rates, steps, opaque: [ptr::null(); 4] });
        ptr::addr_of_mut!((*mechanism).opaque).cast::<Known<R>>().write(known);
    }
    Ok(())
}

/// A mechanism as C hands it over: nothing that is written may overlap it or its steps.
pub(crate) struct Made<R: 'static> {
    pub(crate) known: Known<R>,
    pub(crate) given: Span,
    pub(crate) steps: Span,
}

impl<R: Real> Made<R> {
    /// # Safety
    /// The mechanism is zero, or has been made, and its steps are there.
    pub(crate) unsafe fn new(mechanism: *const Mechanism<R>) -> Result<Self, Status> {
        let given = Span::of(mechanism, 1)?;
        // SAFETY: neither null nor misaligned, by `Span::of`; the rest is promised.
        let steps = unsafe { ptr::addr_of!((*mechanism).steps).read() };
        if steps.is_null() {
            return Err(Status::NoMechanism);
        }
        // SAFETY: it has been made, so this was written.
        let known = unsafe { ptr::addr_of!((*mechanism).opaque).cast::<Known<R>>().read() };
        Ok(Self { known, given, steps: Span::of(steps, known.links())? })
    }
}

/// # Safety
/// As for [`Made::new`], [`Input::slice`] and [`Output::slice`].
unsafe fn link_poses<R: Real>(
    mechanism: *const Mechanism<R>,
    values: *const R,
    value_count: usize,
    poses: *mut R,
    link_count: usize,
) -> Done {
    // SAFETY: promised.
    let made = unsafe { Made::new(mechanism)? };
    let values = Input::<R>::new(values, value_count)?;
    let poses = Output::<DualQuat<R>>::new(poses, link_count)?;
    apart(&[poses.span], &[values.span, made.given, made.steps])?;
    // SAFETY: promised, and apart.
    unsafe { Ok(made.known.link_poses(values.slice(), poses.slice())?) }
}

/// # Safety
/// As for [`Made::new`] and [`Input::slice`], and for [`Output::write`].
unsafe fn link_pose<R: Real>(
    mechanism: *const Mechanism<R>,
    values: *const R,
    value_count: usize,
    link: usize,
    pose: *mut R,
) -> Done {
    // SAFETY: promised.
    let made = unsafe { Made::new(mechanism)? };
    let values = Input::<R>::new(values, value_count)?;
    let pose = Output::<DualQuat<R>>::new(pose, 1)?;
    apart(&[pose.span], &[values.span, made.given, made.steps])?;
    if link >= made.known.links() {
        return Err(Status::NoLink);
    }
    // SAFETY: promised, and apart.
    unsafe { pose.write(made.known.link_pose(values.slice(), link)?) };
    Ok(())
}

/// What [`link_jacobian`] computes, and where from.
struct Asked<R> {
    mechanism: *const Mechanism<R>,
    frame: i32,
    values: *const R,
    value_count: usize,
    link: usize,
}

/// # Safety
/// As for [`Made::new`], [`Input::slice`], [`Output::slice`] and [`Output::write`].
unsafe fn link_jacobian<R: Real>(
    asked: Asked<R>,
    columns: *mut R,
    column_count: usize,
    pose: *mut R,
) -> Done {
    // SAFETY: promised.
    let made = unsafe { Made::new(asked.mechanism)? };
    let values = Input::<R>::new(asked.values, asked.value_count)?;
    let columns = Output::<Twist<R>>::new(columns, column_count)?;
    let pose = Output::<DualQuat<R>>::unless_null(pose)?;
    apart(&[columns.span, pose.span], &[values.span, made.given, made.steps])?;
    let (known, link) = (made.known, asked.link);
    if link >= known.links() {
        return Err(Status::NoLink);
    }
    // SAFETY: promised, and apart.
    let (values, columns) = unsafe { (values.slice(), columns.slice()) };
    let reached = match asked.frame {
        frame if frame == Frame::World as i32 => known.link_jacobian(World, values, link, columns),
        frame if frame == Frame::Body as i32 => known.link_jacobian(Body, values, link, columns),
        frame if frame == Frame::WorldAligned as i32 => {
            known.link_jacobian(WorldAligned, values, link, columns)
        }
        _ => return Err(Status::UnknownValue),
    }?;
    // SAFETY: promised, and apart.
    unsafe { pose.write(reached) };
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Checks `count` joints and makes a mechanism of them, once; its functions then only
            /// compute. `steps`, as many as joints, is memory that the mechanism keeps using: what
            /// its functions do is undefined if anything else has written it. `joints` are not
            /// needed any more.
            ///
            /// DQ8_STATUS_PARENT_NOT_BEFORE, _PARENT_OUT_OF_RANGE, _NOT_UNIT (the placement),
            /// _NOT_FINITE, _AXIS, _MIMIC, _LIMITS or _UNKNOWN_VALUE (the kind, `mimics` or
            /// `limited`); `bad_joint`, which may be null, is set to that joint. `steps` may have
            /// been written, the mechanism not.
            mechanism::make(
                joints: *const Joint<$R>, count: usize, steps: *mut Step<$R>,
                mechanism: *mut Mechanism<$R>, bad_joint: *mut usize,
            ) = super::make(joints, count, steps, mechanism, bad_joint)
        }
        export_one! { $R
            /// Forward kinematics of one configuration: the poses of all links in the frame of the
            /// base, `poses[j] = poses[parent] * placement[j] * motion of joint j`. `value_count`
            /// and `link_count` are those of the mechanism, or it is DQ8_STATUS_LENGTH.
            mechanism::link_poses(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                poses: *mut $R, link_count: usize,
            ) = super::link_poses(mechanism, values, value_count, poses, link_count)
        }
        export_one! { $R
            /// The pose of one link: nothing but what carries it is computed. DQ8_STATUS_NO_LINK if
            /// there is no such link.
            mechanism::link_pose(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                link: usize, pose: *mut $R,
            ) = super::link_pose(mechanism, values, value_count, link, pose)
        }
        export_one! { $R
            /// The geometric Jacobian of a link: for each rate of the mechanism a column of six
            /// numbers, angular velocity x y z, then linear velocity x y z, in `frame`, one of enum
            /// dq8_frame. Columns of joints that do not carry the link are zero.
            ///
            /// `column_count` is the mechanism's number of rates. `pose`, the pose of the link, may
            /// be null. DQ8_STATUS_NO_LINK if there is no such link.
            mechanism::link_jacobian(
                mechanism: *const Mechanism<$R>, frame: i32, values: *const $R,
                value_count: usize, link: usize, columns: *mut $R, column_count: usize,
                pose: *mut $R,
            ) = super::link_jacobian(
                Asked { mechanism, frame, values, value_count, link },
                columns,
                column_count,
                pose,
            )
        }
    };
}
for_both_numbers!(functions);
