//! One clip concatenated four ways: what each takes, and how far each is from scalar f64.

use std::convert::Infallible;
use std::error::Error;
use std::fmt;
use std::hint::black_box;

use dq8::{Crowd, DualQuat, Hierarchy};
use dq8_contract::kinematics;

use crate::clip::Clip;
use crate::matrix::{self, Matrix};
use crate::stopwatch::fastest;

/// Frames that are worked on at once.
const LANES: usize = 8;

/// Allowed difference of the lanes from scalar, in sizes of the skeleton.
const TOLERANCE: f64 = 1e-5;

/// Repeating a clip may not ask for more joints than this: two gigabytes for the largest contender.
const MAX_JOINTS: usize = 1 << 24;

pub(crate) struct Contest {
    pub(crate) contenders: [Contender; 4],
    /// The largest distance of a joint from its root, in any frame.
    pub(crate) size: f64,
    /// The largest distances of a joint by the lanes from where scalar has it.
    pub(crate) lanes_to_f64: f64,
    pub(crate) lanes_to_f32: f64,
    /// World positions by the lanes, `[frame][joint]`.
    pub(crate) positions: Vec<[f64; 3]>,
}

pub(crate) struct Contender {
    pub(crate) name: &'static str,
    pub(crate) ns_per_joint: f64,
    /// The largest distance of a joint from where scalar f64 has it.
    pub(crate) difference: f64,
}

/// Concatenates all frames of the clip, repeated `instances` times.
pub(crate) fn run(clip: &Clip, instances: usize) -> Result<Contest, Box<dyn Error>> {
    let parents = clip.parents();
    let hierarchy = Hierarchy::new(&parents)?;
    let doubles = clip.locals();
    let count = doubles.len().checked_mul(instances);
    if instances > 1 && count.is_none_or(|count| count > MAX_JOINTS) {
        let most = MAX_JOINTS / doubles.len();
        return Err(
            format!("--instances {instances} is too many for this clip, at most {most}").into()
        );
    }
    let joints = clip.joints.len();
    let (singles, origins) = around_roots(clip, &doubles);
    let world = |index: usize, model: [f32; 3]| {
        let origin = origins[index % origins.len()];
        [0, 1, 2].map(|axis| origin[axis] + f64::from(model[axis]))
    };

    // Each contender repeats its own input, so that no other's lies in memory while it is timed.
    let scalar_f64 = {
        let locals = doubles.repeat(instances);
        compete(
            PaletteEntry { joints: doubles.len(), instances, reference: None },
            locals.clone(),
            |models| {
                kinematics::local_to_model(&parents, black_box(&locals), models);
                Ok::<(), Infallible>(())
            },
            |models, index| models[index].translation(),
        )?
    };
    let entry =
        PaletteEntry { reference: Some(&scalar_f64.positions), joints: doubles.len(), instances };
    let scalar_f32 = {
        let locals = singles.repeat(instances);
        compete(
            entry,
            locals.clone(),
            |models| {
                kinematics::local_to_model(&parents, black_box(&locals), models);
                Ok::<(), Infallible>(())
            },
            |models, index| world(index, models[index].translation()),
        )?
    };
    let lanes = {
        let locals = Crowd::<f32, LANES>::from_slice(joints, &singles.repeat(instances))?;
        compete(
            entry,
            locals.clone(),
            |models| hierarchy.local_to_model(black_box(locals.blocks()), models.blocks_mut()),
            |models, index| {
                let model = models.get(index / joints, index % joints);
                world(index, model.map_or([f32::NAN; 3], |model| model.translation()))
            },
        )?
    };
    let matrices = {
        let parents: Vec<_> = clip.joints.iter().map(|joint| joint.parent).collect();
        let locals: Vec<Matrix> =
            singles.iter().map(|local| matrix::from_rows(local.to_matrix4())).collect();
        let locals = locals.repeat(instances);
        compete(
            entry,
            locals.clone(),
            |models| {
                matrix::local_to_model(&parents, black_box(&locals), models);
                Ok::<(), Infallible>(())
            },
            |models, index| world(index, matrix::translation(&models[index])),
        )?
    };

    let contender = |name, timed: &Timed| Contender {
        name,
        ns_per_joint: timed.seconds * 1e9 / (doubles.len() * instances) as f64,
        difference: timed.difference,
    };
    let contenders = [
        contender("scalar f64", &scalar_f64),
        contender("scalar f32", &scalar_f32),
        contender("8 lanes f32", &lanes),
        contender("4x4 matrices f32", &matrices),
    ];
    let lanes_to_f64 = lanes.difference;
    let pairs = lanes.positions.iter().zip(&scalar_f32.positions);
    let lanes_to_f32 = largest(pairs.map(|(&lanes, &scalar)| distance(lanes, scalar)));
    let size = size(clip, &scalar_f64.positions);
    Ok(Contest { contenders, size, lanes_to_f64, lanes_to_f32, positions: lanes.positions })
}

impl Contest {
    /// Whether the lanes are where the scalar results are.
    pub(crate) fn check(&self) -> Result<(), Disagreement> {
        for (scalar, difference) in [("f32", self.lanes_to_f32), ("f64", self.lanes_to_f64)] {
            // Written so that what is not a number fails: f32 overflows where f64 does not.
            if !(difference <= TOLERANCE * self.size && self.size.is_finite()) {
                return Err(Disagreement { scalar, difference, size: self.size });
            }
        }
        Ok(())
    }
}

/// The lanes are not where scalar says.
#[derive(Debug)]
pub(crate) struct Disagreement {
    scalar: &'static str,
    difference: f64,
    size: f64,
}

impl fmt::Display for Disagreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { scalar, difference, size } = self;
        write!(
            f,
            "lanes and scalar {scalar} differ by {difference:.2e}, more than {TOLERANCE:.0e} of \
             the skeleton's size ({size:.4e}): f32 cannot hold this clip"
        )
    }
}

impl Error for Disagreement {}

/// The locals for f32, rounded from f64, with every root in the origin; and for each of them where
/// its root is in the world.
///
/// In f32 a skeleton turns about its root, and the root's place is added in f64: the digits of f32
/// belong to the skeleton, however far it walks.
fn around_roots(clip: &Clip, locals: &[DualQuat<f64>]) -> (Vec<DualQuat<f32>>, Vec<[f64; 3]>) {
    let roots = clip.roots();
    let frames = locals.chunks_exact(roots.len());
    let motion = |local: DualQuat<f64>| local.to_array().map(|component| component as f32);
    let split = frames.flat_map(|frame| {
        frame.iter().zip(&roots).zip(&clip.joints).map(move |((&local, &root), joint)| {
            let is_root = joint.parent.is_none();
            let local = if is_root { DualQuat::from_rotation(local.rotation()) } else { local };
            (DualQuat::from_array(motion(local)), frame[root].translation())
        })
    });
    split.unzip()
}

/// What a contender has to do.
#[derive(Clone, Copy)]
struct PaletteEntry<'a> {
    /// All joints of all frames of the clip.
    joints: usize,
    /// How often the clip is repeated.
    instances: usize,
    /// Where the joints ought to be; for the first contender, where it has them itself.
    reference: Option<&'a [[f64; 3]]>,
}

/// What it did.
struct Timed {
    /// For all joints of all instances.
    seconds: f64,
    /// Of the first instance.
    positions: Vec<[f64; 3]>,
    /// Of any instance from the reference.
    difference: f64,
}

fn compete<M, E>(
    entry: PaletteEntry<'_>,
    mut models: M,
    mut concatenate: impl FnMut(&mut M) -> Result<(), E>,
    position: impl Fn(&M, usize) -> [f64; 3],
) -> Result<Timed, E> {
    let seconds = fastest(|| concatenate(black_box(&mut models)))?;
    let positions: Vec<_> = (0..entry.joints).map(|index| position(&models, index)).collect();
    let reference = entry.reference.unwrap_or(&positions);
    let all = (0..entry.joints * entry.instances).map(|index| position(&models, index));
    let difference = largest(all.zip(reference.iter().cycle()).map(|(a, &b)| distance(a, b)));
    Ok(Timed { seconds, positions, difference })
}

/// Not a number if any of them is not.
fn largest(distances: impl Iterator<Item = f64>) -> f64 {
    distances.fold(
        0.0,
        |largest, distance| {
            if distance > largest || distance.is_nan() { distance } else { largest }
        },
    )
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}

/// The largest distance of a joint from its root, in any frame.
fn size(clip: &Clip, positions: &[[f64; 3]]) -> f64 {
    let roots = clip.roots();
    let frames = positions.chunks_exact(roots.len());
    let reaches = frames
        .flat_map(|frame| frame.iter().zip(&roots).map(|(&p, &root)| distance(p, frame[root])));
    reaches.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::{largest, run};
    use crate::biped;
    use crate::clip::{Axis, Channel, Clip, Joint};

    #[test]
    fn not_a_number_is_never_forgotten() {
        assert!(largest([1.0, f64::NAN, 2.0].into_iter()).is_nan());
        assert_eq!(largest([1.0, 5.0, 2.0].into_iter()), 5.0);
    }

    #[test]
    fn the_biped_agrees_however_often_it_is_repeated() {
        let once = run(&biped::clip(), 1).unwrap();
        let thrice = run(&biped::clip(), 3).unwrap();
        once.check().unwrap();
        thrice.check().unwrap();
        assert_eq!(once.positions, thrice.positions);
        assert!(run(&biped::clip(), usize::MAX).is_err());
    }

    /// A root that moves along x and a bone on it.
    fn bone(length: f64, x: f64) -> Clip {
        let joint = |parent, offset, channels: &[Channel]| Joint {
            name: String::new(),
            parent,
            offset,
            channels: channels.to_vec(),
            end_site: false,
        };
        let joints = vec![
            joint(None, [0.0; 3], &[Channel::Position(Axis::X), Channel::Rotation(Axis::Z)]),
            joint(Some(0), [0.0, length, 0.0], &[]),
        ];
        Clip { title: String::new(), joints, frame_time: 1.0, values: vec![x, 90.0] }
    }

    #[test]
    fn a_long_way_costs_no_digits() {
        for x in [0.0, 1e3, 1e6, 1e9] {
            let contest = run(&bone(1.0, x), 1).unwrap();
            contest.check().unwrap();
            assert!((contest.positions[1][0] - (x - 1.0)).abs() < 1e-6, "{:?}", contest.positions);
        }
    }

    #[test]
    fn what_f32_cannot_hold_is_refused() {
        for length in [1e39, 1e300, 1e308] {
            assert!(run(&bone(length, 0.0), 1).unwrap().check().is_err(), "{length}");
        }
    }
}
