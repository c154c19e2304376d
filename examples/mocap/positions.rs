//! [`Positions`]: where every joint is in every frame, by lanes, held against double precision.

use std::error::Error;

use dq8::{Crowd, DualQuat, Hierarchy};

use dq8_bvh::Clip;

/// Frames that are worked on at once.
const LANES: usize = 8;

/// Allowed difference of the lanes from double precision, in sizes of the skeleton.
const TOLERANCE: f64 = 1e-5;

pub(crate) struct Positions {
    /// In the world, `[frame][joint]`.
    pub(crate) world: Vec<[f64; 3]>,
    /// The largest distance of a joint from its root, in any frame.
    pub(crate) size: f64,
    /// The largest distance of a joint from where double precision has it.
    pub(crate) difference: f64,
}

impl Positions {
    pub(crate) fn of(clip: &Clip) -> Result<Self, Box<dyn Error>> {
        let parents = clip.parents();
        let hierarchy = Hierarchy::new(&parents)?;
        let (singles, origins) = around_roots(clip, &clip.locals());

        let joints = parents.len();
        let mut crowd = Crowd::<f32, LANES>::from_slice(joints, &singles)?;
        hierarchy.job().local_to_model_in_place(crowd.blocks_mut())?;
        let world = origins.iter().enumerate().map(|(index, origin)| {
            let model = crowd.get(index / joints, index % joints);
            let position = model.map_or([f32::NAN; 3], |model| model.translation());
            [0, 1, 2].map(|axis| origin[axis] + f64::from(position[axis]))
        });
        let world: Vec<_> = world.collect();

        let exact: Vec<_> = clip.models()?.iter().map(|model| model.translation()).collect();
        let difference = largest(world.iter().zip(&exact).map(|(&a, &b)| distance(a, b)));
        Ok(Self { size: size(clip, &exact), world, difference })
    }

    /// A coordinate with the digits that f32 has: fewest that are read as the same number. Farther
    /// away than the skeleton is large, they are those of the skeleton, because its root's place is
    /// of f64.
    pub(crate) fn digits(&self, coordinate: f64) -> String {
        if coordinate.abs() <= self.size {
            // Debug writes small numbers with an exponent.
            return format!("{:?}", coordinate as f32);
        }
        // Half the distance of numbers as large as the skeleton.
        let unit = self.size * f64::from(f32::EPSILON) / 2.0;
        let decimals = (-unit.log10()).ceil().max(0.0) as usize;
        // A root alone has no size, and f64 no more digits than these.
        if decimals > 15 { format!("{coordinate:?}") } else { format!("{coordinate:.decimals$}") }
    }

    /// Whether the lanes are where double precision says.
    pub(crate) fn check(&self) -> Result<(), String> {
        // Written so that what is not a number fails: f32 overflows where f64 does not.
        if self.difference <= TOLERANCE * self.size && self.size.is_finite() {
            return Ok(());
        }
        let Self { difference, size, .. } = self;
        Err(format!(
            "f32 and f64 differ by {difference:.2e}, more than {TOLERANCE:.0e} of the skeleton's size \
             ({size:.4e}): f32 cannot hold this clip"
        ))
    }
}

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

/// Not a number if any of them is not.
fn largest(distances: impl Iterator<Item = f64>) -> f64 {
    distances.fold(
        0.0,
        |largest, distance| {
            if distance > largest || distance.is_nan() { distance } else { largest }
        },
    )
}

pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}

/// The largest distance of a joint from its root, in any frame.
pub(crate) fn size(clip: &Clip, positions: &[[f64; 3]]) -> f64 {
    let roots = clip.roots();
    let frames = positions.chunks_exact(roots.len());
    let reaches = frames
        .flat_map(|frame| frame.iter().zip(&roots).map(|(&p, &root)| distance(p, frame[root])));
    reaches.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::{Positions, largest};
    use crate::biped;
    use dq8_bvh::{Axis, Channel, Clip, Joint};

    #[test]
    fn not_a_number_is_never_forgotten() {
        assert!(largest([1.0, f64::NAN, 2.0].into_iter()).is_nan());
        assert_eq!(largest([1.0, 5.0, 2.0].into_iter()), 5.0);
    }

    #[test]
    fn the_lanes_put_the_biped_where_double_precision_does() {
        let positions = Positions::of(&biped::clip()).unwrap();
        positions.check().unwrap();
        assert_eq!(positions.world.len(), 256 * 21);
    }

    /// A root that moves along x and a bone on it.
    fn bone(length: f64, x: f64) -> Clip {
        let free = vec![Channel::Position(Axis::X), Channel::Rotation(Axis::Z)];
        let joints = vec![
            Joint::new("", None, [0.0; 3], free),
            Joint::new("", Some(0), [0.0, length, 0.0], vec![]),
        ];
        Clip { title: String::new(), joints, frame_time: 1.0, values: vec![x, 90.0] }
    }

    #[test]
    fn a_long_way_costs_no_digits() {
        for x in [0.0, 1e3, 1e6, 1e9] {
            let positions = Positions::of(&bone(1.0, x)).unwrap();
            positions.check().unwrap();
            assert!((positions.world[1][0] - (x - 1.0)).abs() < 1e-6, "{:?}", positions.world);
        }
    }

    #[test]
    fn coordinates_have_the_digits_of_f32_and_far_away_those_of_the_skeleton() {
        let of = |size| Positions { world: Vec::new(), size, difference: 0.0 };
        for coordinate in [390.123_4_f32, -0.000_123_456_79, 0.1, 3.0e-12, 0.0] {
            let text = of(391.0).digits(coordinate.into());
            assert_eq!(text.parse::<f32>(), Ok(coordinate), "{text}");
            assert!(text.bytes().filter(u8::is_ascii_digit).count() <= 16, "{text}");
        }
        // A millionth of the skeleton, a thousand kilometres away.
        assert_eq!(of(1.0).digits(1_000_000.123_456_7), "1000000.12345670");
        assert_eq!(of(390.0).digits(1_000_000.123_456_7), "1000000.12346");
        assert_eq!(of(0.0).digits(-1.5), "-1.5");
    }

    #[test]
    fn what_f32_cannot_hold_is_refused() {
        for length in [1e39, 1e300, 1e308] {
            assert!(Positions::of(&bone(length, 0.0)).unwrap().check().is_err(), "{length}");
        }
    }
}
