use super::Job;
use super::locals::motions;
use super::run::Run;
use crate::batch;
use crate::dispatch::Kernel;
use crate::geometry::Twist;
use crate::shape::{ShapeError, joints_within, same_length, whole_instances};
use crate::storage::{Element, Layout, Number, Register, Tile, aos, identity};
use dq8_simd::{Level, MAX_LANES, Records};

impl<E: Element<8>> Job<'_, E> {
    /// Spatial twists of all joints from the rates of the joints:
    /// twist(j) = twist(parent(j)) + Ad_{model(j)} rate(j).
    ///
    /// `models` are model poses, unit; `rates` body twists of each joint relative to its parent, in
    /// the joint's own frame (for a joint of one degree of freedom, its axis times its rate);
    /// `twists` come out in the frame that the models are in, about its origin
    /// ([`Twist::velocity_at`] gives the velocity of a point). All hold one element per joint, or several
    /// whole instances one after the other.
    ///
    /// # Errors
    /// If the slices differ in length or hold no whole number of instances; `twists` is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, Twist};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let arm = Hierarchy::new(&parents)?;
    /// // Two hinges about z, at x = 0 and at x = 2, turning against each other.
    /// let models = [0.0_f32, 2.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let rates = [1.0, -1.0].map(|z| Twist { angular: [0.0, 0.0, z], linear: [0.0; 3] });
    /// let mut twists = rates;
    /// arm.job().velocities(&models, &rates, &mut twists)?;
    /// // The forearm does not turn, it moves in a circle.
    /// assert_eq!(twists[1], Twist { angular: [0.0; 3], linear: [0.0, 2.0, 0.0] });
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn velocities<T: Element<6, Layout = E::Layout>>(
        &self,
        models: &[E],
        rates: &[T],
        twists: &mut [T],
    ) -> Result<(), ShapeError> {
        let joints = self.run.parents.len();
        joints_within(&self.run.joints, joints)?;
        whole_instances("models", joints, models.len())?;
        same_length("rates", rates.len(), models.len())?;
        same_length("twists", twists.len(), models.len())?;
        let backend = self.backend.unwrap_or_default();
        backend.run(Velocities { run: &self.run, models, rates, twists });
        Ok(())
    }

    /// The spatial Jacobian of joint `effector`: column j is the screw of joint j in the frame that
    /// the models are in, Ad_{model(j)} axis(j), for the effector and its ancestors, and zero for all
    /// other joints. The effector's spatial twist is Σ q̇ⱼ column(j).
    ///
    /// `axes` holds the screw of each joint in its own frame, the same for all instances: the body
    /// twist for a rate of 1 ((axis, 0) for a hinge, (0, axis) for a slide, both for a screw).
    /// `models` and `columns` hold one element per joint, or several whole instances one after the
    /// other.
    ///
    /// The *geometric* Jacobian of robotics, with ṗ of a point p of the effector, has the same angular
    /// rows and [`column.velocity_at(p)`](Twist::velocity_at) for the linear ones.
    ///
    /// # Errors
    /// If lengths do not fit or joint `effector` does not exist; `columns` is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, Twist};
    /// let parents = [Hierarchy::ROOT, 0, 0];
    /// let fork = Hierarchy::new(&parents)?;
    /// let models = [0.0_f32, 2.0, 3.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let hinge = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
    /// let mut columns = [hinge; 3];
    /// fork.job().jacobian(&models, &[hinge; 3], 1, &mut columns)?;
    /// assert_eq!(columns[0].to_array(), [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    /// assert_eq!(columns[1].to_array(), [0.0, 0.0, 1.0, 0.0, -2.0, 0.0]);
    /// assert_eq!(columns[2].to_array(), [0.0; 6]); // the other branch
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn jacobian<T: Element<6, Layout = E::Layout>>(
        &self,
        models: &[E],
        axes: &[Twist<Number<E, 8>>],
        effector: usize,
        columns: &mut [T],
    ) -> Result<(), ShapeError> {
        let joints = self.run.parents.len();
        joints_within(&self.run.joints, joints)?;
        whole_instances("models", joints, models.len())?;
        same_length("axes", axes.len(), joints)?;
        same_length("columns", columns.len(), models.len())?;
        if effector >= joints {
            let range = effector..effector.saturating_add(1);
            return Err(ShapeError::Joints { range, joints });
        }
        let backend = self.backend.unwrap_or_default();
        backend.run(Columns { run: &self.run, models, axes, effector, columns });
        Ok(())
    }
}

/// The twists of one register of instances, or of joints.
type Twists<E, V> = Twist<Register<E, V, 8>>;

/// twist(j) = twist(parent(j)) + Ad_{model(j)} rate(j), parents first.
struct Velocities<'r, 's, E: Element<8>, T> {
    run: &'r Run<'r, E>,
    models: &'s [E],
    rates: &'s [T],
    twists: &'s mut [T],
}

impl<E: Element<8>, T: Element<6, Layout = E::Layout>> Kernel for Velocities<'_, '_, E, T> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, models, rates, twists } = self;
        let joints = run.parents.len().max(1);
        for (instance, twists) in twists.chunks_exact_mut(joints).enumerate() {
            let first = instance * joints;
            if E::Layout::transposes::<V>() {
                // Lanes are joints, which do not wait for each other yet; the sums come after.
                for start in run.joints.clone().step_by(E::Layout::records::<V>()) {
                    let Some(own) = own_twists(level, models, rates, Tile::at(first + start, 0))
                    else {
                        return;
                    };
                    let twists = twists.get_mut(..run.joints.end).unwrap_or_default();
                    T::store(own.to_array(), twists, Tile::at(start, 0));
                }
            }
            for joint in run.joints.clone() {
                let Some(&parent) = run.parents.get(joint) else { return };
                if E::Layout::transposes::<V>() {
                    if let (Some(parent), Some(own)) =
                        (T::get(twists, parent as usize), T::get(twists, joint))
                    {
                        let sum = Twist::from_array(parent) + Twist::from_array(own);
                        T::set(twists, joint, sum.to_array());
                    }
                    continue;
                }
                for register in 0..E::Layout::registers::<V>() {
                    let tile = Tile::at(first + joint, register);
                    let Some(mut twist) = own_twists(level, models, rates, tile) else { return };
                    // ROOT is beyond the last joint: there is no such twist.
                    let parent = Tile::at(parent as usize, register);
                    if let Some(parent) = T::load(level, twists, parent, &identity()) {
                        twist = Twist::from_array(parent) + twist;
                    }
                    T::store(twist.to_array(), twists, Tile::at(joint, register));
                }
            }
        }
    }
}

/// Ad_model rate
#[cfg_attr(not(opt_level_0), inline(always))]
fn own_twists<E: Element<8>, T: Element<6, Layout = E::Layout>, V: Level>(
    level: V,
    models: &[E],
    rates: &[T],
    tile: Tile,
) -> Option<Twists<E, V>> {
    let rate = Twist::from_array(T::load(level, rates, tile, &identity())?);
    Some(motions(level, models, tile)?.adjoint(rate))
}

/// Ad_{model(j)} axis(j) for the effector and its ancestors, and zero for all others.
struct Columns<'r, 's, E: Element<8>, T> {
    run: &'r Run<'r, E>,
    models: &'s [E],
    axes: &'s [Twist<Number<E, 8>>],
    effector: usize,
    columns: &'s mut [T],
}

impl<E: Element<8>, T: Element<6, Layout = E::Layout>> Kernel for Columns<'_, '_, E, T> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, models, axes, effector, columns } = self;
        let joints = run.parents.len().max(1);
        let nothing = aos::splat(level, [Number::<E, 8>::default(); 6]);
        for (models, columns) in models.chunks_exact(joints).zip(columns.chunks_exact_mut(joints)) {
            let written = columns.get_mut(..run.joints.end).unwrap_or_default();
            for start in run.joints.clone().step_by(E::Layout::records::<V>()) {
                for register in 0..E::Layout::registers::<V>() {
                    T::store(nothing, written, Tile::at(start, register));
                }
            }
            if E::Layout::transposes::<V>() {
                ancestors_together(level, run, models, axes, effector, columns);
            } else {
                ancestors(level, run, models, axes, effector, columns);
            }
        }
    }
}

/// Lanes are instances, or there is one.
#[cfg_attr(not(opt_level_0), inline(always))]
fn ancestors<E: Element<8>, T: Element<6, Layout = E::Layout>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    models: &[E],
    axes: &[Twist<Number<E, 8>>],
    effector: usize,
    columns: &mut [T],
) {
    let mut joint = effector;
    // ROOT is beyond the last joint, and ends the walk.
    while let (Some(axis), Some(&parent)) = (axes.get(joint), run.parents.get(joint)) {
        let axis = Twist::from_array(aos::splat(level, axis.to_array()));
        for register in 0..E::Layout::registers::<V>() {
            let tile = Tile::at(joint, register);
            let Some(model) = motions(level, models, tile) else { return };
            if run.joints.contains(&joint) {
                T::store(model.adjoint(axis).to_array(), columns, tile);
            }
        }
        joint = parent as usize;
    }
}

/// Lanes are the effector and its ancestors, gathered on the walk to the root.
#[cfg_attr(not(opt_level_0), inline(always))]
fn ancestors_together<E: Element<8>, T: Element<6, Layout = E::Layout>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    models: &[E],
    axes: &[Twist<Number<E, 8>>],
    effector: usize,
    columns: &mut [T],
) {
    let mut joint = effector;
    loop {
        let (mut which, mut count) = ([0; MAX_LANES], 0);
        let (mut moves, mut screws) = ([identity(); MAX_LANES], [identity(); MAX_LANES]);
        for ((which, motion), screw) in which.iter_mut().zip(&mut moves).zip(&mut screws) {
            let (Some(model), Some(axis), Some(&parent)) =
                (E::get(models, joint), axes.get(joint), run.parents.get(joint))
            else {
                break;
            };
            if count == E::Layout::records::<V>() {
                break;
            }
            (*which, *motion, *screw) = (joint, model, axis.to_array());
            count += 1;
            joint = parent as usize;
        }
        if count == 0 {
            return;
        }
        let motions = batch::DualQuat::<Register<E, V, 8>>::load_records(level, &moves);
        let screws = Register::<E, V, 8>::load_records(level, &screws, identity());
        let mut records = [identity(); MAX_LANES];
        let moved = motions.adjoint(Twist::from_array(screws)).to_array();
        Register::<E, V, 8>::store_records(moved, &mut records);
        for (joint, record) in which.into_iter().zip(records).take(count) {
            if run.joints.contains(&joint) {
                T::set(columns, joint, record);
            }
        }
    }
}
