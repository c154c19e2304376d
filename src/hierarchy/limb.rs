//! Two-bone inverse kinematics: the computation of new locals of three joints, which take the last
//! joint to a target.

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
    /// Takes the end of a limb to a target in each instance, by new locals of the limb's three
    /// joints. The rotations are those of [`TwoBone::reach`](crate::ik::TwoBone::reach), for the
    /// root position that the model of the limb's parent gives, and for the bone lengths that its
    /// locals give. The knee bends to the side of the pole. The end keeps its rotation in model
    /// space, and translations stay as they are. If the target is out of reach, the limb is
    /// stretched or folded toward it.
    ///
    /// `models` are the models of `locals`; only the models of the limb's parent and of its end are
    /// read. There is one target and one pole for each instance (or block of instances), in model
    /// space. After the call, the models of the limb and of its descendants are outdated: run a job
    /// on their range of [`joints`](Self::joints) to compute them again. This call ignores the
    /// job's own range of joints.
    ///
    /// # Errors
    /// If the lengths of slices do not fit, the joints are no limb, or a limb cannot be bent
    /// because its root, a bone length, its target or its pole is not finite; the error has the
    /// index of the first such instance. `locals` are then untouched. (Values of the end's model
    /// that are not finite are no error, because only the new local of the end depends on them.)
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
        // A limb has three joints, so a hierarchy with a limb is not empty, and `max` changes
        // nothing. It shows the compiler that no division by zero, which would panic, is possible.
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

/// The limbs of a job, before they are bent; the lengths of the slices have been checked.
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

/// A limb in each lane: the model of its parent, if it has a parent; the local poses of its three
/// joints; and the root, lengths, target and pole for [`TwoBone`](crate::ik::TwoBone).
type Loaded<L> = (Option<batch::DualQuat<L>>, [batch::DualQuat<L>; 3], Asked<L>);

impl<E: Element<8>, T: Element<3, Layout = E::Layout>> Limbs<'_, E, T> {
    /// Loads the limbs of the instances in a tile.
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

    /// Loads the motion of a joint in each instance of a tile.
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

    /// Returns the limbs of a range of instances (or blocks).
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

/// The loop that searches for the first limb that cannot be bent.
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
    // AVX-512 is quicker for plain limbs too, because most of the time goes to square roots and
    // divisions, and little to transposes.
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
