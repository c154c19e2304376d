//! Two-bone inverse kinematics: new locals of three joints, which take the last one to a target.

use super::plan::Plans;
use super::run::{Roots, Run, grain};
use super::{Hierarchy, Job};
use crate::backend::Kernel;
use crate::batch;
use crate::ik::{Asked, Limb, LimbsError, fault};
use crate::storage::shape::same_length;
use crate::storage::{self, Element, Layout, Number, Register, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

impl<S, P: Plans> Job<'_, S, P> {
    /// Takes the end of a limb to a target in each instance, by new locals of its three joints:
    /// [`TwoBone::reach`](crate::ik::TwoBone::reach) from where its root is, with the lengths that
    /// its locals have. The knee is on the side of the pole, the end keeps its turn in model space,
    /// and translations stay as they are. Out of reach the limb is stretched toward the target, or
    /// folded.
    ///
    /// `models` are those of `locals`; only the limb's parent and its end are read. One
    /// target and one pole for each instance (block), in model space. Models of the limb and of
    /// what hangs from it are old afterwards: a job of those [`joints`](Self::joints) computes them
    /// anew. The range of this job itself has no effect here.
    ///
    /// # Errors
    /// If lengths do not fit, the joints are no limb, or a target cannot be reached for, because it
    /// or what the limb stands on is not finite: the first such instance. `locals` are untouched.
    /// (What is not finite in the model of the end goes to its own local alone.)
    ///
    /// ```
    /// use dq8::ik::Limb;
    /// use dq8::{DualQuat, Hierarchy, Skeleton};
    /// // Pelvis, hip, knee and ankle; a character that looks along z.
    /// let rig = Skeleton::new(&[-1, 0, 1, 2])?;
    /// let at = |y: f32| DualQuat::from_translation([0.0, y, 0.0]);
    /// let mut locals = [at(0.75), at(0.0), at(-0.4), at(-0.4)];
    /// let mut models = locals;
    /// rig.job().local_to_model(&locals, &mut models)?;
    /// assert!(models[3].translation()[1] < -0.04, "in the ground");
    /// let leg = Limb { joints: [1, 2, 3], hinge: [1.0, 0.0, 0.0] };
    /// rig.job().two_bone(&leg, &models, &[[0.0, 0.0, 0.1]], &[[0.0, 0.0, 1.0]], &mut locals)?;
    /// rig.job().joints(1..).local_to_model(&locals, &mut models)?;
    /// let foot = models[3].translation();
    /// assert!(foot[1].abs() < 1e-6 && (foot[2] - 0.1).abs() < 1e-6);
    /// assert!(models[2].translation()[2] > 0.1, "the knee is forward");
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[doc(alias("IKTwoBoneJob", "foot_ik"))]
    pub fn two_bone<E, T>(
        &self,
        limb: &Limb<Number<E, 8>>,
        models: &[E],
        targets: &[T],
        poles: &[T],
        locals: &mut [E],
    ) -> Result<(), LimbsError>
    where
        E: Element<8>,
        T: Element<3, Layout = E::Layout>,
        S: Roots<E>,
    {
        let run = self.check(("models", models.len()), models.len())?;
        let parent =
            |joint: usize| run.parents.get(joint).filter(|&&parent| parent != Hierarchy::ROOT);
        limb.check(|joint| parent(joint).map(|&parent| parent as usize))?;
        // There are three at least, which the compiler does not know: division by zero would be a
        // path to a panic.
        let joints = run.parents.len().max(1);
        same_length("locals", locals.len(), models.len())?;
        for (what, length) in [("targets", targets.len()), ("poles", poles.len())] {
            same_length(what, length, models.len() / joints)?;
        }
        let limbs = Limbs { run: &run, limb, models, targets, poles };
        let backend = run.backend;
        if let Some(fault) = backend.run(Check { limbs, locals }) {
            return Err(fault);
        }
        backend.share(grain(joints), (locals, joints), &|first, (locals, _): (&mut [E], usize)| {
            let instances = first..first + locals.len() / joints;
            let run = run.part(instances.clone());
            backend.run(Reach { limbs: limbs.part(&run, instances), locals });
        });
        Ok(())
    }
}

/// The limbs of a job, before they are bent: slices of lengths that have been checked.
struct Limbs<'s, E: Element<8>, T> {
    run: &'s Run<'s, E>,
    limb: &'s Limb<Number<E, 8>>,
    models: &'s [E],
    targets: &'s [T],
    poles: &'s [T],
}

impl<E: Element<8>, T> Clone for Limbs<'_, E, T> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<E: Element<8>, T> Copy for Limbs<'_, E, T> {}

/// A limb in each lane: the model of its parent, if it has one, the local poses of its joints, and
/// the task.
type Loaded<L> = (Option<batch::DualQuat<L>>, [batch::DualQuat<L>; 3], Asked<L>);

impl<E: Element<8>, T: Element<3, Layout = E::Layout>> Limbs<'_, E, T> {
    /// The limbs of a tile of targets.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(
        &self,
        level: V,
        locals: &[E],
        tile: Tile,
    ) -> Option<Loaded<Register<E, V, 8>>> {
        let [hip, knee, foot] = self.limb.joints;
        let parent = *self.run.parents.get(hip)? as usize;
        let parent = if parent < hip {
            Some(self.motion(level, self.models, tile, parent)?)
        } else {
            self.run.root.load(level, tile.element, tile.register)
        };
        let locals = [
            self.motion(level, locals, tile, hip)?,
            self.motion(level, locals, tile, knee)?,
            self.motion(level, locals, tile, foot)?,
        ];
        let point = storage::identity();
        let target = T::load(level, self.targets, tile, &point)?;
        let pole = T::load(level, self.poles, tile, &point)?;
        let (root, lengths) = batch::two_bone::root_and_lengths(parent, locals);
        Some((parent, locals, (root, lengths, target, pole)))
    }

    /// A joint of the instances of a tile.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motion<V: Level>(
        &self,
        level: V,
        from: &[E],
        tile: Tile,
        joint: usize,
    ) -> Option<batch::DualQuat<Register<E, V, 8>>> {
        let motion = E::load(level, from, self.place(tile, joint), &storage::identity())?;
        Some(batch::DualQuat::from_array(motion))
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn place(&self, tile: Tile, joint: usize) -> Tile {
        let joints = self.run.parents.len();
        Tile::at(tile.element * joints + joint, tile.register).strided(joints)
    }

    /// The limbs of some of the instances (blocks).
    fn part<'p>(&'p self, run: &'p Run<'p, E>, instances: Range<usize>) -> Limbs<'p, E, T> {
        let joints = run.parents.len();
        let models = instances.start * joints..instances.end * joints;
        Limbs {
            run,
            limb: self.limb,
            models: self.models.get(models).unwrap_or_default(),
            targets: self.targets.get(instances.clone()).unwrap_or_default(),
            poles: self.poles.get(instances).unwrap_or_default(),
        }
    }
}

/// The loop that looks for the first limb that cannot be bent.
struct Check<'s, E: Element<8>, T> {
    limbs: Limbs<'s, E, T>,
    locals: &'s [E],
}

impl<E: Element<8>, T: Element<3, Layout = E::Layout>> Kernel for Check<'_, E, T> {
    type Output = Option<LimbsError>;
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) -> Self::Output {
        let Self { limbs, locals } = self;
        for tile in storage::tiles::<T, V, 3>(limbs.targets.len()) {
            let (_, _, asked) = limbs.load(level, locals, tile)?;
            let lanes = Register::<T, V, 3>::LANES;
            let found = fault(asked, tile.element * T::Layout::THINGS + tile.register * lanes);
            if found.is_some() {
                return found;
            }
        }
        None
    }
}

struct Reach<'s, E: Element<8>, T> {
    limbs: Limbs<'s, E, T>,
    locals: &'s mut [E],
}

impl<E: Element<8>, T: Element<3, Layout = E::Layout>> Kernel for Reach<'_, E, T> {
    type Output = ();
    // Wide for plain limbs too: roots and quotients are most of it.
    const WIDE: bool = true;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { limbs, locals } = self;
        let joints = limbs.limb.joints;
        let hinge = batch::vector::splat(level, limbs.limb.hinge);
        for tile in storage::tiles::<T, V, 3>(limbs.targets.len()) {
            let Some((parent, old, asked)) = limbs.load(level, locals, tile) else { return };
            let Some(end) = limbs.motion(level, limbs.models, tile, joints[2]) else { return };
            let new = batch::two_bone::locals(parent, old, end.real(), hinge, asked);
            for (joint, motion) in joints.into_iter().zip(new) {
                E::store(motion.to_array(), locals, limbs.place(tile, joint));
            }
        }
    }
}
