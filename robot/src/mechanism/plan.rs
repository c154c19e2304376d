//! What is found when a mechanism is made, for one configuration at a time: joints between frames
//! that are all parallel to the base where every value is zero.
//!
//! Turn the frame of every link so. Then no placement has a rotation, and the axes of nearly all
//! robots are those of the base: a hinge is r ← c r + s r n with a product r n that is a
//! permutation and three signs. A link's own frame is turned back when its pose is written, which
//! no other link waits for.

use super::factor::{Alignment, Factor, Moves, Planned, Way};
use super::joint::JointKind;
use super::step::Step;
use dq8::Real;
use dq8::scalar::Quat;

/// Plans all steps, which are in the order of the joints.
// Once in machine code, not for each way to make a mechanism.
#[inline(never)]
pub(crate) fn plan<R: Real>(steps: &mut [Step<R>]) {
    for index in 0..steps.len() {
        let Some(step) = steps.get(index) else { return };
        let on = steps.get(step.parent as usize).map_or(Factor::ONE, |on| on.planned.own);
        let on = on.quaternion();
        let own = on * Quat::from_array(step.rotation);
        // Unit but for rounding: a step of Newton's makes it so.
        let mut own = own.scale(R::from(1.5) - R::HALF * own.dot(own)).to_array();
        clean(&mut own, R::ONE);
        let largest = step.half_offset.into_iter().map(R::abs).fold(R::ZERO, R::max_or_nan);
        let mut half_offset = on.rotate(step.half_offset);
        clean(&mut half_offset, largest);
        let mut axis = Quat::from_array(own).rotate(step.axis);
        clean(&mut axis, R::ONE);
        if let Some(step) = steps.get_mut(index) {
            let axis = Way::new(axis);
            let moves = match (step.kind, axis.along) {
                (JointKind::Fixed, _) => Moves::Not,
                (JointKind::Revolute { .. }, _) if step.mimics => Moves::Otherwise,
                (JointKind::Revolute { .. }, Alignment::X) => Moves::AboutX,
                (JointKind::Revolute { .. }, Alignment::Y) => Moves::AboutY,
                (JointKind::Revolute { .. }, Alignment::Z) => Moves::AboutZ,
                (JointKind::Revolute { .. }, _) => Moves::AboutAny,
                _ => Moves::Otherwise,
            };
            let (own, half_offset) = (Factor::new(own), Way::new(half_offset));
            step.planned = Planned { moves, own, half_offset, axis };
        }
    }
}

/// With the zeros, halves, roots of a half and ones that rounding has missed, of numbers of this
/// size: frames of machines are turned by quarters.
#[inline(never)]
fn clean<R: Real>(numbers: &mut [R], size: R) {
    let (root, near) = (R::HALF.sqrt(), R::TWO * R::EPSILON * size);
    for number in numbers {
        for nice in [R::ZERO, R::HALF * size, root * size, size] {
            if (number.abs() - nice).abs() <= near {
                *number = if *number < R::ZERO { -nice } else { nice };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Alignment, Moves, plan};
    use crate::mechanism::joint::Joint;
    use crate::mechanism::step::Step;
    use dq8::{DualQuat, Quat, Real};

    /// Frames that are turned by a quarter or a half each, as files and floats have it, stay on the
    /// axes of the base.
    fn stays_aligned<R: Real>() {
        let mut steps = [Step::default(); 60];
        for (index, step) in steps.iter_mut().enumerate() {
            let axis =
                |which: usize| [0, 1, 2].map(|i| if i == which % 3 { R::ONE } else { R::ZERO });
            let angle = R::PI * R::HALF * R::from((1 + index % 2) as f32);
            let turn = Quat::from_axis_angle(axis(index * index), angle);
            let at = DualQuat::from_rotation_translation(turn, axis(index / 2));
            let on = index.checked_sub(1);
            *step = Step::of(&Joint::revolute(on, at, axis(index / 5)), index).unwrap();
            step.parent = on.map_or(u32::MAX, |on| on as u32);
        }
        plan(&mut steps);
        for step in steps {
            assert!(!matches!(step.planned.moves, Moves::AboutAny | Moves::Otherwise), "{step:?}");
            assert_ne!(step.planned.half_offset.along, Alignment::Any, "{step:?}");
        }
    }

    #[test]
    fn quarter_turns_leave_hinges_and_ways_along_axes_of_the_base() {
        stays_aligned::<f32>();
        stays_aligned::<f64>();
    }
}
