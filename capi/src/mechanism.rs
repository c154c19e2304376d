//! Mechanisms: trees of joints that are checked once and kept in memory of the caller, with
//! functions for the poses and the Jacobians of links.

use crate::joint::{Fault, Joint, fault};
use crate::memory::{Buffer, Input, Output, bytes, place};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::{DualQuat, Lanes, Real, Scalar, Twist};
use dq8_robot::{Body, JointKind, World, WorldAligned};

/// The frame of the columns of a Jacobian. It decides along which axes the components are measured,
/// and for which point the linear velocity is given.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The axes of the base and the origin of the base: columns are spatial twists.
    World = 0,
    /// The axes of the link and the origin of the link: columns are body twists.
    Body = 1,
    /// The axes of the base and the origin of the link.
    WorldAligned = 2,
}

/// The memory that a mechanism needs for one joint. Its content is private to the library.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Step<R> {
    /// Private to the library.
    opaque: [R; 100],
}

/// A mechanism, made by dq8_mechanism_make. This struct may be copied and moved. It points to its
/// steps, which must stay where they are and must not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Mechanism<R> {
    /// The number of links, one for each joint.
    pub links: usize,
    /// The number of values of a configuration. A configuration holds the values of joint 0, then
    /// the values of joint 1, and so on.
    pub values: usize,
    /// The number of rates, which is the number of columns of a Jacobian. Each joint has as many
    /// rates as values, except that a floating joint has seven values and six rates.
    pub rates: usize,
    /// The array of steps. It is null in a zeroed struct that dq8_mechanism_make has not filled in.
    steps: *const Step<R>,
    /// Private to the library.
    opaque: [*const Step<R>; 4],
}

type Known<R> = dq8_robot::Mechanism<'static, R>;

/// Asserts that the structs of C have room for the structs of `dq8_robot`. An array of [`Step`]
/// must hold the steps of `dq8_robot`, then the joints while they are checked, and the padding that
/// aligns both.
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

/// Makes the mechanism of these joints in `buffer`, which has the size of one [`Step`] for each
/// joint.
fn known<'a, R: Real>(
    joints: &[Joint<R>],
    buffer: &'a mut Buffer,
) -> Result<dq8_robot::Mechanism<'a, R>, Fault> {
    let count = joints.len();
    // Steps and joints fit into `buffer`, as `fits` asserts, so this error does not occur.
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
/// `joints` and `steps` must hold `count` elements. No other thread may use the outputs or write
/// the joints during the call.
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
    // SAFETY: the caller guarantees that both arrays have `count` elements, and `disjoint` has
    // checked that the steps overlap no other array.
    let (joints, buffer) = unsafe { (joints.slice(), steps.slice()) };
    // A mechanism without joints needs a pointer that is not null too, because null means that no
    // mechanism has been made.
    let steps = buffer.as_ptr().cast();
    // The lifetime is `'static`, because C must keep the steps for as long as it uses the
    // mechanism.
    let known: Known<R> = match known(joints, bytes(buffer)) {
        Ok(known) => known,
        Err((status, joint)) => {
            if let Some(joint) = joint {
                // SAFETY: the caller guarantees that `bad_joint` is null or points to a `usize`,
                // and `disjoint` has checked that it overlaps no other array.
                unsafe { bad_joint.write(joint) };
            }
            return Err(status);
        }
    };
    let (links, values, rates) = (known.links(), known.values(), known.rates());
    // SAFETY: the caller guarantees that `mechanism` points to a `Mechanism`, and `disjoint` has
    // checked that it overlaps no other array. `opaque` has the size and alignment of a `Known`, as
    // `fits` asserts.
    unsafe {
        made.write(Mechanism { links, values, rates, steps, opaque: [ptr::null(); 4] });
        ptr::addr_of_mut!((*mechanism).opaque).cast::<Known<R>>().write(known);
    }
    Ok(())
}

/// A mechanism from C that has been made, with the memory of its struct (`given`) and of its steps.
/// No output may overlap either.
pub(crate) struct Checked<R: 'static> {
    pub(crate) known: Known<R>,
    pub(crate) given: Span,
    pub(crate) steps: Span,
}

impl<R: Real> Checked<R> {
    /// # Safety
    /// The mechanism must be zeroed, or made by dq8_mechanism_make, and then its steps must be
    /// unchanged.
    pub(crate) unsafe fn new(mechanism: *const Mechanism<R>) -> Result<Self, Status> {
        let given = Span::of(mechanism, 1)?;
        // SAFETY: `Span::of` has checked that the pointer is neither null nor misaligned. The
        // caller guarantees that it points to a mechanism that is zeroed or made.
        let steps = unsafe { ptr::addr_of!((*mechanism).steps).read() };
        if steps.is_null() {
            return Err(Status::NoMechanism);
        }
        // SAFETY: `steps` is not null, so the mechanism has been made, and `opaque` holds a
        // `Known`.
        let known = unsafe { ptr::addr_of!((*mechanism).opaque).cast::<Known<R>>().read() };
        Ok(Self { known, given, steps: Span::of(steps, known.links())? })
    }
}

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. Each array must
/// have as many elements as its count says. No other thread may use the output or write the inputs
/// during the call.
unsafe fn link_poses<R: Real>(
    mechanism: *const Mechanism<R>,
    values: *const R,
    value_count: usize,
    poses: *mut R,
    link_count: usize,
) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or made with unchanged steps.
    let checked = unsafe { Checked::new(mechanism)? };
    let values = Input::<R>::new(values, value_count)?;
    let poses = Output::<DualQuat<R>>::new(poses, link_count)?;
    disjoint(&[poses.span], &[values.span, checked.given, checked.steps])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that `poses` overlaps no input.
    unsafe { Ok(checked.known.link_poses(values.slice(), poses.slice())?) }
}

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. `values` must have
/// `value_count` elements. No other thread may use `pose` or write the inputs during the call.
unsafe fn link_pose<R: Real>(
    mechanism: *const Mechanism<R>,
    values: *const R,
    value_count: usize,
    link: usize,
    pose: *mut R,
) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or made with unchanged steps.
    let checked = unsafe { Checked::new(mechanism)? };
    let values = Input::<R>::new(values, value_count)?;
    let pose = Output::<DualQuat<R>>::new(pose, 1)?;
    disjoint(&[pose.span], &[values.span, checked.given, checked.steps])?;
    if link >= checked.known.links() {
        return Err(Status::NoLink);
    }
    // SAFETY: the caller guarantees `value_count` values and a pose, and `disjoint` has checked
    // that `pose` overlaps no input.
    unsafe { pose.write(checked.known.link_pose(values.slice(), link)?) };
    Ok(())
}

/// The inputs of functions of a Jacobian. `frame` is a value of [`Frame`].
struct Query<R> {
    mechanism: *const Mechanism<R>,
    frame: i32,
    values: *const R,
    value_count: usize,
    link: usize,
}

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. Each array must
/// have as many elements as its count says, and `pose` must be null or a motion. No other thread
/// may use the outputs or write the inputs during the call.
unsafe fn link_jacobian<R: Real>(
    query: Query<R>,
    columns: *mut R,
    column_count: usize,
    pose: *mut R,
) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or made with unchanged steps.
    let checked = unsafe { Checked::new(query.mechanism)? };
    let values = Input::<R>::new(query.values, query.value_count)?;
    let columns = Output::<Twist<R>>::new(columns, column_count)?;
    let pose = Output::<DualQuat<R>>::unless_null(pose)?;
    disjoint(&[columns.span, pose.span], &[values.span, checked.given, checked.steps])?;
    let (known, link) = (checked.known, query.link);
    if link >= known.links() {
        return Err(Status::NoLink);
    }
    // SAFETY: the caller guarantees that both arrays have as many elements as their counts say, and
    // `disjoint` has checked that `columns` overlaps no other array.
    let (values, columns) = unsafe { (values.slice(), columns.slice()) };
    let reached = match query.frame {
        frame if frame == Frame::World as i32 => known.link_jacobian(World, values, link, columns),
        frame if frame == Frame::Body as i32 => known.link_jacobian(Body, values, link, columns),
        frame if frame == Frame::WorldAligned as i32 => {
            known.link_jacobian(WorldAligned, values, link, columns)
        }
        _ => return Err(Status::UnknownValue),
    }?;
    // SAFETY: the caller guarantees that `pose` is null or a motion, and `disjoint` has checked
    // that it overlaps no other array.
    unsafe { pose.write(reached) };
    Ok(())
}

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. Each array must
/// have as many elements as its count says, and `manipulability` must point to a number. No other
/// thread may use the outputs or write the inputs during the call.
unsafe fn manipulability<R: Real>(
    query: Query<R>,
    columns: *mut R,
    column_count: usize,
    manipulability: *mut R,
) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or made with unchanged steps.
    let checked = unsafe { Checked::new(query.mechanism)? };
    let values = Input::<R>::new(query.values, query.value_count)?;
    let columns = Output::<Twist<R>>::new(columns, column_count)?;
    let to = Output::<R>::new(manipulability, 1)?;
    disjoint(&[columns.span, to.span], &[values.span, checked.given, checked.steps])?;
    let (known, link) = (checked.known, query.link);
    if link >= known.links() {
        return Err(Status::NoLink);
    }
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and a
    // number. `disjoint` has checked that no output overlaps another array.
    unsafe { to.write(known.manipulability(values.slice(), link, columns.slice())?) };
    Ok(())
}

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. Each array must
/// have as many elements as its count says, and `twist` must point to six numbers. No other thread
/// may use the outputs or write the inputs during the call.
unsafe fn rates_for<R: Scalar + Lanes<Real = R>>(
    query: Query<R>,
    twist: *const R,
    damping: R,
    columns: *mut R,
    rates: *mut R,
    column_count: usize,
) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or made with unchanged steps.
    let checked = unsafe { Checked::new(query.mechanism)? };
    let values = Input::<R>::new(query.values, query.value_count)?;
    let twist = Input::<Twist<R>>::new(twist, 1)?;
    let columns = Output::<Twist<R>>::new(columns, column_count)?;
    let rates = Output::<R>::new(rates, column_count)?;
    let read = [values.span, twist.span, checked.given, checked.steps];
    disjoint(&[columns.span, rates.span], &read)?;
    let (known, link) = (checked.known, query.link);
    if link >= known.links() {
        return Err(Status::NoLink);
    }
    if !(damping.is_finite() && damping >= R::ZERO) {
        return Err(Status::UnknownValue);
    }
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that no output overlaps another array.
    let (values, twist) = unsafe { (values.slice(), twist.slice()) };
    // SAFETY: as above.
    let (columns, rates) = unsafe { (columns.slice(), rates.slice()) };
    let twist = twist.first().copied().unwrap_or(Twist::ZERO);
    match query.frame {
        frame if frame == Frame::World as i32 => {
            known.rates_for(World, values, link, twist, damping, columns, rates)
        }
        frame if frame == Frame::Body as i32 => {
            known.rates_for(Body, values, link, twist, damping, columns, rates)
        }
        frame if frame == Frame::WorldAligned as i32 => {
            known.rates_for(WorldAligned, values, link, twist, damping, columns, rates)
        }
        _ => return Err(Status::UnknownValue),
    }?;
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Makes a mechanism of `count` joints. It checks the joints once, so that the
            /// functions of the mechanism need not. `steps` is memory for `count` steps, to which
            /// the mechanism points. The behaviour of its functions is undefined if the program
            /// changes or frees the steps. The `joints` are not needed afterwards.
            ///
            /// Returns DQ8_STATUS_PARENT_NOT_BEFORE, _PARENT_OUT_OF_RANGE, _NOT_UNIT (of a
            /// placement), _NOT_FINITE, _AXIS, _MIMIC, _LIMITS or _UNKNOWN_VALUE (of a kind,
            /// `mimics` or `limited`) if a joint is wrong, and sets `bad_joint`, which may be null,
            /// to its index. The function may then have written `steps`, but not the mechanism.
            mechanism::make(
                joints: *const Joint<$R>, count: usize, steps: *mut Step<$R>,
                mechanism: *mut Mechanism<$R>, bad_joint: *mut usize,
            ) = super::make(joints, count, steps, mechanism, bad_joint)
        }
        export_one! { $R
            /// Computes the poses of all links in the frame of the base: forward kinematics of one
            /// configuration, `poses[j] = poses[parent] * placement[j] * motion of joint j`.
            /// Returns DQ8_STATUS_LENGTH_VALUES if `value_count` is not the mechanism's number of
            /// values, and DQ8_STATUS_LENGTH if `link_count` is not its number of links.
            mechanism::link_poses(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                poses: *mut $R, link_count: usize,
            ) = super::link_poses(mechanism, values, value_count, poses, link_count)
        }
        export_one! { $R
            /// Computes the pose of one link in the frame of the base. It computes only the joints
            /// that carry the link. `link` is the index of the link. Returns DQ8_STATUS_NO_LINK if
            /// there is no such link.
            mechanism::link_pose(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                link: usize, pose: *mut $R,
            ) = super::link_pose(mechanism, values, value_count, link, pose)
        }
        export_one! { $R
            /// Computes the geometric Jacobian of a link. It has a column for each rate of the
            /// mechanism. A column has six components: angular velocity x y z, then linear velocity
            /// x y z, in `frame`, one of enum dq8_frame. Columns of joints that do not carry the
            /// link are zero.
            ///
            /// `column_count` must be the mechanism's number of rates. The pose of the link is
            /// written to `pose`, which may be null. Returns DQ8_STATUS_NO_LINK if there is no such
            /// link, and DQ8_STATUS_UNKNOWN_VALUE if `frame` is no value of the enum.
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
        export_one! { $R
            /// Computes the manipulability of a link: the root of the determinant of its Jacobian
            /// times the transposed Jacobian (Yoshikawa 1985). It is 0 where the link cannot move
            /// in some direction, and for fewer than six rates; it does not depend on the frame.
            /// `columns` is scratch for `column_count` columns of six components, and
            /// `column_count` must be the mechanism's number of rates. Returns DQ8_STATUS_NO_LINK
            /// if there is no such link.
            mechanism::manipulability(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize, link: usize,
                columns: *mut $R, column_count: usize, manipulability: *mut $R,
            ) = super::manipulability(
                Query { mechanism, frame: Frame::World as i32, values, value_count, link },
                columns,
                column_count,
                manipulability,
            )
        }
        export_one! { $R
            /// Computes the rates that move a link best with the velocity `twist`: six components,
            /// angular x y z, then linear x y z, in `frame`, one of enum dq8_frame. The sum of the
            /// squared errors, plus the square of `damping` times the squared rates, is least.
            /// Without damping, which is 0, rates that move nothing are 0, and rates near a
            /// singular configuration are large.
            ///
            /// `column_count` must be the mechanism's number of rates, which is the length of
            /// `rates`. `columns` is scratch for as many columns of six components. Returns
            /// DQ8_STATUS_NO_LINK if there is no such link, and DQ8_STATUS_UNKNOWN_VALUE if `frame`
            /// is no value of the enum, or `damping` is negative or not finite.
            mechanism::rates_for(
                mechanism: *const Mechanism<$R>, frame: i32, values: *const $R, value_count: usize,
                link: usize, twist: *const $R, damping: $R, columns: *mut $R, rates: *mut $R,
                column_count: usize,
            ) = super::rates_for(
                Query { mechanism, frame, values, value_count, link },
                twist,
                damping,
                columns,
                rates,
                column_count,
            )
        }
    };
}
for_both_numbers!(functions);
