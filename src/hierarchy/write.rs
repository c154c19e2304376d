use super::ahead::Ahead;
use super::locals::Locals;
use super::run::Run;
use super::slot::JointSlot;
use crate::backend::Kernel;
use crate::storage::{Element, Layout, Register};
use dq8_simd::{Lanes, Level};

/// poses(j) = local(j). In the lanes are instances where they lie in blocks, and joints of one instance elsewhere: no
/// joint waits for another here, and joints side by side are not strided.
pub(super) struct Write<'r, 's, E: Element<8>, L> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
    pub(super) poses: &'s mut [E],
}

impl<E: Element<8>, L: Locals<E>> Kernel for Write<'_, '_, E, L> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, locals, poses } = self;
        let joints = run.parents.len();
        let lanes = Register::<E, V, 8>::LANES;
        for instance in 0..poses.len().checked_div(joints).unwrap_or(0) {
            for register in 0..E::Layout::registers::<V>() {
                let mut ahead = Ahead::of(&locals);
                for joint in run.joints.clone().step_by(E::Layout::records::<V>()) {
                    let slot = if const { E::Layout::THINGS > 1 } {
                        let first = instance * E::Layout::THINGS + register * lanes;
                        JointSlot::in_block(joint, instance * joints, register, first)
                    } else {
                        JointSlot::of_joints(joint, instance, joints, run.joints.end)
                    };
                    let Some(local) = ahead.local(level, run, &locals, &[], slot) else { return };
                    E::store(locals.motion(local).to_array(), slot.within(poses), slot.tile());
                }
            }
        }
    }
}
