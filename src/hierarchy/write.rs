use super::ahead::Ahead;
use super::locals::Locals;
use super::run::Run;
use super::slot::JointSlot;
use super::transposed::MANY;
use crate::backend::Kernel;
use crate::storage::{Element, Layout, Register};
use dq8_simd::{Lanes, Level};

/// poses(j) = local(j). In the lanes are instances where they lie in blocks, and where locals are
/// made: a clip and a layer are quicker for a group of joints at a time, and a small skeleton has
/// fewer registers of joints than that, of which the last one is half empty. What lies in memory,
/// and the instances left over, have joints of one instance in the lanes: no joint waits for
/// another here, and joints side by side are not strided. The bits are the same.
pub(super) struct Write<'r, 's, E: Element<8>, L> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) locals: L,
    pub(super) poses: &'s mut [E],
}

impl<E: Element<8>, L: Locals<E>> Kernel for Write<'_, '_, E, L> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE || L::MADE;
    // A fifth to a quarter less time where 512 bits are shuffled as quickly as 256.
    const SHUFFLES: bool = !E::Layout::WIDE && L::MADE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, locals, poses } = self;
        let joints = run.parents.len();
        let lanes = Register::<E, V, 8>::LANES;
        let instances = poses.len().checked_div(joints).unwrap_or(0);
        let mut ahead = Ahead::of(&locals);
        let mut instance = 0;
        if const { MANY && L::MADE && E::Layout::THINGS == 1 } {
            while instances - instance >= lanes {
                for joint in run.joints.clone() {
                    let slot = JointSlot::of_instances(joint, instance, joints);
                    if write(level, run, &locals, poses, slot, &mut ahead).is_none() {
                        return;
                    }
                }
                instance += lanes;
            }
        }
        for instance in instance..instances {
            for register in 0..E::Layout::registers::<V>() {
                for joint in run.joints.clone().step_by(E::Layout::records::<V>()) {
                    let slot = if const { E::Layout::THINGS > 1 } {
                        let first = instance * E::Layout::THINGS + register * lanes;
                        JointSlot::in_block(joint, instance * joints, register, first)
                    } else {
                        JointSlot::of_joints(joint, instance, joints, run.joints.end)
                    };
                    if write(level, run, &locals, poses, slot, &mut ahead).is_none() {
                        return;
                    }
                }
            }
        }
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn write<E: Element<8>, L: Locals<E>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    locals: &L,
    poses: &mut [E],
    slot: JointSlot,
    ahead: &mut Ahead<E, V>,
) -> Option<()> {
    let local = ahead.local(level, run, locals, &[], slot)?;
    E::store(locals.motion(local).to_array(), slot.within(poses), slot.tile());
    Some(())
}
