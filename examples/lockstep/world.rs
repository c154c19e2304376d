//! [`World`]: walkers with feet that are planted by inverse kinematics, and a skin that follows
//! their joints. Without std, so that a microcontroller can be one of the machines.

use dq8::ik::TwoBone;
use dq8::skinning::{DualBlend, Skin, Surface, SurfaceMut};
use dq8::{Backend, DualQuat, Hierarchy, Quat, hierarchy::Poses};

/// One a lane of eight.
const WALKERS: usize = 8;
/// Hips, chest, head, and two legs of thigh and shin.
const PARENTS: [u32; JOINTS] = [Hierarchy::ROOT, 0, 1, 0, 3, 0, 5];
const JOINTS: usize = 7;
/// A vertex follows two joints.
const VERTICES: usize = 12;
const STEP: f32 = 1.0 / 60.0;
const BONES: [f32; 2] = [0.45, 0.45];

/// What changes from step to step.
pub(crate) struct World {
    backend: Backend,
    roots: [DualQuat<f32>; WALKERS],
    /// Of the gait, in radians: no longer than a turn.
    phases: [f32; WALKERS],
    /// Of the players' commands.
    random: u32,
    /// Of all vertices so far.
    hash: u64,
}

impl World {
    pub(crate) fn new(backend: Backend) -> Self {
        let place = |i: usize| DualQuat::from_translation([(i % 4) as f32, (i / 4) as f32, 0.9]);
        Self {
            backend,
            roots: core::array::from_fn(place),
            phases: core::array::from_fn(|i| 0.375 * i as f32),
            random: 1,
            hash: 0xcbf2_9ce4_8422_2325,
        }
    }

    /// From −1 to 1, of integers alone: what players send each other.
    fn command(&mut self) -> f32 {
        self.random = self.random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.random >> 8) as f32 / 8_388_608.0 - 1.0
    }

    /// Where a walker's joints are in their parents: the chest sways, and each foot is where the
    /// gait wants it.
    fn pose(phase: f32) -> [DualQuat<f32>; JOINTS] {
        let mut locals = [DualQuat::IDENTITY; JOINTS];
        let sway = Quat::from_rotation_y(0.1 * Quat::from_rotation_x(phase).x());
        locals[1] = DualQuat::from_rotation_translation(sway, [0.0, 0.0, 0.3]);
        locals[2] = DualQuat::from_translation([0.0, 0.0, 0.35]);
        for (leg, y) in [(3, 0.1), (5, -0.1)] {
            let turn = Quat::from_rotation_x(if leg == 3 { phase } else { -phase });
            let foot = [0.3 * turn.w(), y, -0.85 + 0.1 * turn.x().abs()];
            let hip = [0.0, y, 0.0];
            // Of finite numbers there is an answer.
            let Ok(limb) = TwoBone::reach(hip, BONES, foot, [1.0, 0.0, 0.0]) else { continue };
            locals[leg] = DualQuat::from_rotation_translation(limb.upper, hip);
            let knee = limb.upper.conjugate() * limb.lower;
            locals[leg + 1] = DualQuat::from_rotation_translation(knee, [BONES[0], 0.0, 0.0]);
        }
        locals
    }

    /// A sixtieth of a second.
    fn step(&mut self, skin: &Skin<'_, u16, f32>, rest: &[[f32; 3]]) -> Result<(), WorldError> {
        let mut twists = [[0.0; 6]; WALKERS];
        for twist in &mut twists {
            *twist = [0.0, 0.0, self.command(), 1.0 + 0.5 * self.command(), 0.0, 0.0];
        }
        let from = self.roots;
        self.backend.integrate_body(&from, &twists, STEP, &mut self.roots)?;
        self.backend.normalize_in_place(&mut self.roots);
        let mut locals = [DualQuat::IDENTITY; WALKERS * JOINTS];
        for (locals, &phase) in locals.chunks_exact_mut(JOINTS).zip(&self.phases) {
            locals.copy_from_slice(&Self::pose(phase));
        }
        let mut models = locals;
        if let Ok(skeleton) = Hierarchy::new(&PARENTS) {
            let job = skeleton.job().backend(self.backend).roots(&self.roots);
            job.locals_to_model(Poses(&locals), &mut models)?;
        }
        for (models, phase) in models.chunks_exact(JOINTS).zip(&mut self.phases) {
            let mut posed = [[0.0; 3]; VERTICES];
            let to = SurfaceMut::positions(&mut posed);
            let job = skin.job().backend(self.backend);
            job.pose(DualBlend::new(models), Surface::positions(rest), to)?;
            for number in posed.as_flattened() {
                self.hash =
                    (self.hash ^ u64::from(number.to_bits())).wrapping_mul(0x0100_0000_01b3);
            }
            // What is posed decides what comes: one other bit, and all that follows is another
            // world.
            *phase += STEP * (6.0 + posed[0][2]);
            if *phase > core::f32::consts::PI {
                *phase -= core::f32::consts::TAU;
            }
        }
        Ok(())
    }

    /// The hash of all vertices of all steps.
    pub(crate) fn run(mut self, steps: usize) -> Result<u64, WorldError> {
        let who: [u16; 2 * VERTICES] = core::array::from_fn(|i| ((i / 2 + i % 2) % JOINTS) as u16);
        let weights: [f32; 2 * VERTICES] =
            core::array::from_fn(|i| if i % 2 == 0 { 0.625 } else { 0.375 });
        let rest: [[f32; 3]; VERTICES] =
            core::array::from_fn(|i| [0.125, 0.0625 * (i % 5) as f32, 0.03125 * i as f32]);
        let skin = Skin::new(JOINTS, 2, &who, &weights)?;
        for _ in 0..steps {
            self.step(&skin, &rest)?;
        }
        Ok(self.hash)
    }
}

/// Lengths that do not fit.
#[derive(Debug)]
pub(crate) struct WorldError;

impl<E: core::error::Error> From<E> for WorldError {
    fn from(_: E) -> Self {
        Self
    }
}
