//! Mechanisms: trees of joints, made once in memory of the caller, and then the poses of links and
//! Jacobians.

use crate::joint::{Fault, Joint, fault};
use crate::memory::{Buffer, Input, Output, bytes, place};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::{DualQuat, Real, Twist};
use dq8_robot::{Body, JointKind, World, WorldAligned};

/// The frame of the columns of a Jacobian: their axes and the point that they are about.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The axes of the base, about the origin of the base: spatial twists.
    World = 0,
    /// The axes of the link, about the origin of the link: body twists.
    Body = 1,
    /// The axes of the base, about the origin of the link.
    WorldAligned = 2,
}

/// The memory of a mechanism for one of its joints. Its content is private to the library.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Step<R> {
    /// Private to the library.
    opaque: [R; 100],
}

/// A mechanism, made by dq8_mechanism_make. This struct may be copied and moved. Its steps must
/// stay where they are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Mechanism<R> {
    /// The number of links, one for each joint.
    pub links: usize,
    /// The number of values of a configuration: those of joint 0, then those of joint 1, and so on.
    pub values: usize,
    /// The number of rates, and of columns of a Jacobian. It is the number of values, except that a
    /// floating joint has seven values and six rates.
    pub rates: usize,
    /// The steps. This is null in a zeroed struct that no mechanism has been made in.
    steps: *const Step<R>,
    /// Private to the library.
    opaque: [*const Step<R>; 4],
}

type Known<R> = dq8_robot::Mechanism<'static, R>;

/// Asserts that the memory that C has is enough. [`Step`] is for the library's steps and, behind
/// them, for its joints while they are checked, and for the alignment of both.
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

/// Makes the mechanism of these joints in `buffer`, which has the size of a [`Step`] for each of
/// them.
fn known<'a, R: Real>(
    joints: &[Joint<R>],
    buffer: &'a mut Buffer,
) -> Result<dq8_robot::Mechanism<'a, R>, Fault> {
    let count = joints.len();
    // Both fit, as `fits` asserts, but the compiler does not know that.
    let small = (Status::TooLarge, None);
    let (steps, rest) = place(buffer, count, dq8_robot::Step::default()).ok_or(small)?;
    let any = dq8_robot::Joint::new(None, DualQuat::IDENTITY, JointKind::Fixed);
    let (known, _) = place(rest, count, any).ok_or(small)?;
    for (index, (given, known)) in joints.iter().zip(&mut *known).enumerate() {
        *known = given.known(count).map_err(|status| (status, Some(index)))?;
    }
    dq8_robot::Mechanism::new(known, steps).map_err(|error| fault(&error))
}

/// # Safety
/// The caller must keep the conditions of [`Input::slice`], [`Output::slice`] and
/// [`Output::write`].
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
    disjoint(&[steps.span, made.span, bad_joint.span], &[joints.span])?;
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    let (joints, buffer) = unsafe { (joints.slice(), steps.slice()) };
    // A mechanism without joints needs a pointer too, because null means that it has not been made.
    let steps = buffer.as_ptr().cast();
    // The mechanism lives as long as C keeps its steps.
    let known: Known<R> = match known(joints, bytes(buffer)) {
        Ok(known) => known,
        Err((status, joint)) => {
            if let Some(joint) = joint {
                // SAFETY: the caller guarantees that the memory is valid, and the outputs have been
                // checked to overlap nothing.
                unsafe { bad_joint.write(joint) };
            }
            return Err(status);
        }
    };
    let (links, values, rates) = (known.links(), known.values(), known.rates());
    // SAFETY: the caller guarantees that the memory is valid, the outputs have been checked to
    // overlap nothing, and `opaque` has room for the mechanism, which `fits` asserts.
    unsafe {
        made.write(Mechanism { links, values, rates, steps, opaque: [ptr::null(); 4] });
        ptr::addr_of_mut!((*mechanism).opaque).cast::<Known<R>>().write(known);
    }
    Ok(())
}

/// A mechanism from C that has been made. No output may overlap it or its steps.
pub(crate) struct Checked<R: 'static> {
    pub(crate) known: Known<R>,
    pub(crate) given: Span,
    pub(crate) steps: Span,
}

impl<R: Real> Checked<R> {
    /// # Safety
    /// The mechanism must be zeroed or made, and its steps must be there.
    pub(crate) unsafe fn new(mechanism: *const Mechanism<R>) -> Result<Self, Status> {
        let given = Span::of(mechanism, 1)?;
        // SAFETY: `Span::of` has checked that the pointer is neither null nor misaligned. The
        // caller guarantees that it points to valid memory.
        let steps = unsafe { ptr::addr_of!((*mechanism).steps).read() };
        if steps.is_null() {
            return Err(Status::NoMechanism);
        }
        // SAFETY: the mechanism has been made, so this was written.
        let known = unsafe { ptr::addr_of!((*mechanism).opaque).cast::<Known<R>>().read() };
        Ok(Self { known, given, steps: Span::of(steps, known.links())? })
    }
}

/// # Safety
/// The caller must keep the conditions of [`Checked::new`], [`Input::slice`] and [`Output::slice`].
unsafe fn link_poses<R: Real>(
    mechanism: *const Mechanism<R>,
    values: *const R,
    value_count: usize,
    poses: *mut R,
    link_count: usize,
) -> Done {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let checked = unsafe { Checked::new(mechanism)? };
    let values = Input::<R>::new(values, value_count)?;
    let poses = Output::<DualQuat<R>>::new(poses, link_count)?;
    disjoint(&[poses.span], &[values.span, checked.given, checked.steps])?;
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe { Ok(checked.known.link_poses(values.slice(), poses.slice())?) }
}

/// # Safety
/// The caller must keep the conditions of [`Checked::new`] and [`Input::slice`], and for
/// [`Output::write`].
unsafe fn link_pose<R: Real>(
    mechanism: *const Mechanism<R>,
    values: *const R,
    value_count: usize,
    link: usize,
    pose: *mut R,
) -> Done {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let checked = unsafe { Checked::new(mechanism)? };
    let values = Input::<R>::new(values, value_count)?;
    let pose = Output::<DualQuat<R>>::new(pose, 1)?;
    disjoint(&[pose.span], &[values.span, checked.given, checked.steps])?;
    if link >= checked.known.links() {
        return Err(Status::NoLink);
    }
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe { pose.write(checked.known.link_pose(values.slice(), link)?) };
    Ok(())
}

/// The inputs of [`link_jacobian`].
struct Query<R> {
    mechanism: *const Mechanism<R>,
    frame: i32,
    values: *const R,
    value_count: usize,
    link: usize,
}

/// # Safety
/// The caller must keep the conditions of [`Checked::new`], [`Input::slice`], [`Output::slice`] and
/// [`Output::write`].
unsafe fn link_jacobian<R: Real>(
    query: Query<R>,
    columns: *mut R,
    column_count: usize,
    pose: *mut R,
) -> Done {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let checked = unsafe { Checked::new(query.mechanism)? };
    let values = Input::<R>::new(query.values, query.value_count)?;
    let columns = Output::<Twist<R>>::new(columns, column_count)?;
    let pose = Output::<DualQuat<R>>::unless_null(pose)?;
    disjoint(&[columns.span, pose.span], &[values.span, checked.given, checked.steps])?;
    let (known, link) = (checked.known, query.link);
    if link >= known.links() {
        return Err(Status::NoLink);
    }
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    let (values, columns) = unsafe { (values.slice(), columns.slice()) };
    let reached = match query.frame {
        frame if frame == Frame::World as i32 => known.link_jacobian(World, values, link, columns),
        frame if frame == Frame::Body as i32 => known.link_jacobian(Body, values, link, columns),
        frame if frame == Frame::WorldAligned as i32 => {
            known.link_jacobian(WorldAligned, values, link, columns)
        }
        _ => return Err(Status::UnknownValue),
    }?;
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe { pose.write(reached) };
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Makes a mechanism of `count` joints. It checks them once, so that the functions of
            /// the mechanism only compute. `steps` is memory for `count` steps, which the mechanism
            /// keeps using; its functions are undefined if anything else has written there. The
            /// `joints` are not needed later.
            ///
            /// Returns DQ8_STATUS_PARENT_NOT_BEFORE, _PARENT_OUT_OF_RANGE, _NOT_UNIT (of a
            /// placement), _NOT_FINITE, _AXIS, _MIMIC, _LIMITS or _UNKNOWN_VALUE (of a kind,
            /// `mimics` or `limited`), and sets `bad_joint`, which may be null, to that joint.
            /// `steps` may then have been written, but not the mechanism.
            mechanism::make(
                joints: *const Joint<$R>, count: usize, steps: *mut Step<$R>,
                mechanism: *mut Mechanism<$R>, bad_joint: *mut usize,
            ) = super::make(joints, count, steps, mechanism, bad_joint)
        }
        export_one! { $R
            /// Computes the poses of all links in the frame of the base: forward kinematics of one
            /// configuration, `poses[j] = poses[parent] * placement[j] * motion of joint j`.
            /// Returns DQ8_STATUS_LENGTH if `value_count` or `link_count` is not that of the
            /// mechanism.
            mechanism::link_poses(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                poses: *mut $R, link_count: usize,
            ) = super::link_poses(mechanism, values, value_count, poses, link_count)
        }
        export_one! { $R
            /// Computes the pose of one link in the frame of the base. Only the joints that carry
            /// the link are computed. Returns DQ8_STATUS_NO_LINK if there is no such link.
            mechanism::link_pose(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                link: usize, pose: *mut $R,
            ) = super::link_pose(mechanism, values, value_count, link, pose)
        }
        export_one! { $R
            /// Computes the geometric Jacobian of a link. It has a column for each rate of the
            /// mechanism, of six numbers: angular velocity x y z, then linear velocity x y z, in
            /// `frame`, one of enum dq8_frame. Columns of joints that do not carry the link are
            /// zero.
            ///
            /// `column_count` must be the mechanism's number of rates. The pose of the link is
            /// written to `pose`, which may be null. Returns DQ8_STATUS_NO_LINK if there is no such
            /// link, and DQ8_STATUS_UNKNOWN_VALUE if there is no such frame.
            mechanism::link_jacobian(
                mechanism: *const Mechanism<$R>, frame: i32, values: *const $R,
                value_count: usize, link: usize, columns: *mut $R, column_count: usize,
                pose: *mut $R,
            ) = super::link_jacobian(
                Query { mechanism, frame, values, value_count, link },
                columns,
                column_count,
                pose,
            )
        }
    };
}
for_both_numbers!(functions);
