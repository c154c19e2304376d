//! People from the positions of joints alone: their turns are those that bring the bones of the
//! first frame to where they are.

use crate::{Person, RetargetError};
use dq8::fit::PointPairs;
use dq8::scalar::vector::{norm, over_norm, sub};
use dq8::{DualQuat, Quat};

type Vector = [f64; 3];

impl Person {
    /// Takes a person from the positions of joints, `[frame][joint]`, in metres and any axes.
    /// `joints` has the name of each joint and the index of its parent, which stands before it.
    ///
    /// A joint with several bones turns as they do together, and a joint with one bone turns with
    /// its parent and then the shortest way to where the bone is: a turn about a single bone cannot
    /// be seen.
    ///
    /// ```
    /// use dq8_retarget::Person;
    /// let joints = [("pelvis", None), ("spine", Some(0)), ("head", Some(1))];
    /// let frame = [[0.0, 0.0, 1.0], [0.0, 0.0, 1.3], [0.0, 0.0, 1.6]];
    /// let person = Person::from_positions("still", &joints, &frame, 1.0 / 30.0)?;
    /// assert_eq!((person.frames(), person.joint_names().len()), (1, 3));
    /// # Ok::<(), dq8_retarget::RetargetError>(())
    /// ```
    ///
    /// # Errors
    /// If the positions are not a whole number of frames, a parent does not stand before its child,
    /// or a position is not finite.
    pub fn from_positions(
        title: impl Into<String>,
        joints: &[(&str, Option<usize>)],
        positions: &[Vector],
        frame_time: f64,
    ) -> Result<Self, RetargetError> {
        let count = joints.len();
        if count == 0 || positions.is_empty() || !positions.len().is_multiple_of(count) {
            let (array, length) = ("positions", positions.len());
            return Err(RetargetError::Lengths { array, length, expected: count });
        }
        let parents: Vec<_> = joints.iter().map(|(_, parent)| *parent).collect();
        // Otherwise the list of a joint's bones could not be made.
        for (joint, parent) in parents.iter().enumerate() {
            if let Some(parent) = parent.filter(|&parent| parent >= joint) {
                return Err(RetargetError::Parent { joint, parent });
            }
        }
        if let Some(index) = positions.iter().position(|place| !place.iter().all(|x| x.is_finite()))
        {
            let joint = joints[index % count].0.to_owned();
            return Err(RetargetError::NotFinite { frame: index / count, joint });
        }
        let mut children = vec![Vec::new(); count];
        for (joint, parent) in parents.iter().enumerate() {
            if let Some(parent) = *parent {
                children[parent].push(joint);
            }
        }
        let (first, mut locals) = (&positions[..count], Vec::with_capacity(positions.len()));
        let mut poses = vec![DualQuat::IDENTITY; count];
        for frame in positions.chunks_exact(count) {
            for (joint, parent) in parents.iter().enumerate() {
                let with = parent.map_or(Quat::IDENTITY, |parent| poses[parent].rotation());
                let turn = turn(&children[joint], first, frame, joint, with);
                poses[joint] = DualQuat::from_rotation_translation(turn, frame[joint]);
                let above = parent.map_or(DualQuat::IDENTITY, |parent| poses[parent]);
                locals.push(above.conjugate() * poses[joint]);
            }
        }
        let names = joints.iter().map(|(name, _)| (*name).to_owned()).collect();
        Self::from_locals(title.into(), names, parents, locals, frame_time)
    }
}

/// Returns the turn of a joint from the first frame to this one.
fn turn(
    children: &[usize],
    first: &[Vector],
    now: &[Vector],
    joint: usize,
    with: Quat<f64>,
) -> Quat<f64> {
    let bones = |at: &[Vector]| -> Vec<Vector> {
        let ways = children.iter().map(|&child| sub(at[child], at[joint]));
        std::iter::once([0.0; 3]).chain(ways).collect()
    };
    let (before, after) = (bones(first), bones(now));
    if children.len() > 1 {
        let pairs = PointPairs::new(&before, &after);
        let fit = pairs.and_then(|pairs| pairs.rigid().map(|fit| (pairs.quality(&fit), fit)));
        if let Ok((quality, fit)) = fit {
            // Bones in one line do not tell a turn.
            if quality.rank > 1 {
                return fit.motion.rotation();
            }
        }
    }
    let (Some(&bone), Some(&there)) = (before.get(1), after.get(1)) else { return with };
    if norm(bone) == 0.0 || norm(there) == 0.0 {
        return with;
    }
    let unit = |way: Vector| over_norm(way, norm(way));
    (Quat::from_rotation_arc(unit(with.rotate(bone)), unit(there)) * with).normalize()
}
