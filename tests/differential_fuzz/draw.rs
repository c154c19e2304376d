//! [`Draw`]: cases of every kind that a program may meet, and some that none should.

use dq8::{DualQuat, Quat};
use dq8_contract::case::{Case, NUMBERS};
use dq8_contract::random::Random;
use std::f64::consts::PI;

/// What the motions of a case are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Draw {
    /// Unit, of any turn, some tiny, some nearly or exactly half a turn; 10 km away at most.
    Ordinary,
    /// Unit, all about a common one, as near to it as 10⁻¹².
    Close,
    /// Unit, b and others nearly or exactly half a turn from a, or nearly −a.
    Opposite,
    /// Unit, up to 10³⁰ lengths away.
    Far,
    /// Unit; parameters, angles and rates as large as numbers are.
    ManyTurns,
    /// Unit; vectors, twists, weights, translations and turns near the smallest numbers and below.
    Tiny,
    /// Any dual quaternions, of any size that numbers have, their parts of different sizes.
    General,
    /// Nothing but bits, infinities, NaN, and ordinary numbers.
    Anything,
}

impl Draw {
    pub(crate) const ALL: [Self; 8] = [
        Self::Ordinary,
        Self::Close,
        Self::Opposite,
        Self::Far,
        Self::ManyTurns,
        Self::Tiny,
        Self::General,
        Self::Anything,
    ];

    /// Whether motions are unit.
    pub(crate) fn is_unit(self) -> bool {
        !matches!(self, Self::General | Self::Anything)
    }

    /// A case for numbers of `f32` or `f64`.
    pub(crate) fn case(self, random: &mut Random, single: bool) -> Case {
        match self {
            Self::Ordinary => {
                let size = random.one_of(&[0.0, 1.0, 30.0, 1e4]);
                let [a, b, c, d] = [(); 4].map(|()| motion(random, size));
                numbers(random, [a, b, c, d], 1.0, size)
            }
            Self::Close => {
                let (size, near) = (random.one_of(&[0.0, 1.0, 1e4]), spread(random, -12, 0));
                let centre = DualQuat::from_array(motion(random, size));
                let poses = [(); 4].map(|()| {
                    let (angle, axis) = (0.7 * near * random.signed(), random.direction());
                    let offset = moved(axis, angle, random.vector().map(|c| near * c));
                    signed(random, (centre * offset).to_array())
                });
                let mut case = numbers(random, poses, 1.0, size);
                if near < 1e-4 && random.signed() > 0.0 {
                    case.t = random.signed() / near;
                }
                case
            }
            Self::Opposite => {
                let size = random.one_of(&[0.0, 1.0, 1e4]);
                let a = motion(random, size);
                let [b, c, d] = [(); 3].map(|()| {
                    let turns = random.one_of(&[PI, -PI, 2.0 * PI]);
                    let off =
                        random.signed() * random.one_of(&[0.0, 1.0]) * spread(random, -15, -1);
                    let axis: [f64; 3] = random.direction();
                    let away = moved(axis, turns + off, random.vector().map(|c| c * size));
                    signed(random, (DualQuat::from_array(a) * away).to_array())
                });
                numbers(random, [a, b, c, d], 1.0, size)
            }
            Self::Far => {
                let size = spread(random, 0, 30);
                let poses = [(); 4].map(|()| {
                    let size = random.one_of(&[size, size, 1.0]);
                    motion(random, size)
                });
                numbers(random, poses, 1.0, size)
            }
            Self::ManyTurns => {
                let poses = [(); 4].map(|()| motion(random, 1.0));
                let mut case = numbers(random, poses, 1.0, 1.0);
                let mut far =
                    |least| random.signed() * spread(random, least, if single { 38 } else { 307 });
                (case.t, case.s, case.dt) = (far(0), far(0), far(-3));
                case.screw[6] = far(0);
                let (turn, rate) = (far(0), far(0));
                for c in 0..3 {
                    case.v[c] *= turn;
                    case.x[c] *= rate;
                }
                case
            }
            Self::Tiny => {
                let least = if single { -46 } else { -324 };
                let size = spread(random, least, -3);
                let poses = [(); 4].map(|()| {
                    let angle = random.one_of(&[0.0, 1.0]) * spread(random, least, -3);
                    let axis: [f64; 3] = random.direction();
                    let pose = moved(axis, angle, random.vector().map(|c| c * size));
                    signed(random, pose.to_array())
                });
                let turn = spread(random, least, -3);
                let mut case = numbers(random, poses, turn, size);
                if random.signed() > 0.0 {
                    case.t = random.signed() * spread(random, least, 0);
                    case.dt = random.signed() * spread(random, least, 0);
                }
                if random.signed() > 0.5 {
                    case.weights = [(); 4].map(|()| spread(random, least, 0));
                }
                case
            }
            Self::General => {
                let (least, most) = if single { (-46, 38) } else { (-324, 308) };
                let size = spread(random, least, most);
                let mut poses = [[0.0; 8]; 4];
                for part in poses.as_flattened_mut().chunks_mut(4) {
                    let size = match random.between(0.0, 4.0) as u32 {
                        0 => spread(random, least, most),
                        1 => 1.0,
                        _ => size,
                    };
                    part.fill_with(|| size * random.signed());
                }
                let mut case =
                    numbers(random, [[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]; 4], size, size);
                [case.a, case.b, case.c, case.d] = poses;
                case.s = random.signed() * spread(random, least, most);
                case
            }
            Self::Anything => {
                let share = random.between(0.0, 1.0);
                let mut all = [0.0; NUMBERS];
                all.fill_with(|| random.number(single, share));
                let mut case = Case::of_numbers(&all);
                case.tolerance = random.one_of(&[
                    0.0,
                    1.0,
                    f64::NAN,
                    f64::INFINITY,
                    -1.0,
                    0.001_234_567,
                    0.123_456_78,
                ]);
                case
            }
        }
    }
}

/// The motions, with numbers beside them: angular ones of the size `turn`, lengths of the size
/// `size`.
fn numbers(random: &mut Random, poses: [[f64; 8]; 4], turn: f64, size: f64) -> Case {
    let [a, b, c, d] = poses;
    let angle = match random.between(0.0, 4.0) as u32 {
        0 => 12.0 * random.signed(),
        1 => spread(random, -40, 0),
        _ => 6.2 * random.signed(),
    };
    let axis: [f64; 3] = random.direction();
    let mut twist = |angular: f64| {
        let linear: [f64; 3] = random.vector().map(|c| c * size);
        let [x, y, z] = random.direction().map(|c| c * angular);
        [x, y, z, linear[0], linear[1], linear[2]]
    };
    let (mut x, y, wrench, rate) = (twist(1.0), twist(turn), twist(turn), twist(turn));
    x[..3].copy_from_slice(&axis.map(|c| c * angle * turn));
    let t = match random.below(8) {
        0 => 0.0,
        1 => 1.0,
        2 => 3.0 * random.signed(),
        _ => random.between(0.0, 1.0),
    };
    Case {
        d,
        derivative: DualQuat::from_array(a)
            .derivative_spatial(dq8::Twist::from_array(rate))
            .to_array(),
        s: 2.0 * random.signed(),
        t,
        dt: 2.0 * random.signed(),
        radius: size * random.between(0.0, 1.0),
        tolerance: random.one_of(&[0.0, 0.1, 1.0, 1e-3]),
        v: random.vector().map(|c| 3.0 * turn * c),
        w: random.vector().map(|c| size * c),
        weights: [(); 4].map(|()| random.between(0.06, 1.0)),
        x,
        y,
        wrench,
        ..Case::of_motions(a, b, c)
    }
}

/// A unit motion of any turn, `size` lengths away.
fn motion(random: &mut Random, size: f64) -> [f64; 8] {
    let angle = match random.below(8) {
        0 => 0.0,
        1 => PI,
        2 => PI - spread(random, -16, 0),
        3 | 4 => spread(random, -46, 0),
        _ => PI * random.signed(),
    };
    let axis = match random.below(6) {
        0 => random.one_of(&[[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]),
        _ => random.direction(),
    };
    let mut pose = moved(axis, angle, random.vector().map(|c| size * c));
    if angle == PI {
        let [x, y, z] = axis;
        let turn = Quat::from_xyzw(x, y, z, random.one_of(&[0.0, -0.0]));
        pose = DualQuat::from_rotation_translation(turn, pose.translation());
    }
    signed(random, pose.to_array())
}

fn moved(axis: [f64; 3], angle: f64, translation: [f64; 3]) -> DualQuat<f64> {
    DualQuat::from_rotation_translation(Quat::from_axis_angle(axis, angle), translation)
}

/// It, or its other sign.
fn signed(random: &mut Random, motion: [f64; 8]) -> [f64; 8] {
    if random.signed() < 0.0 { motion.map(|c| -c) } else { motion }
}

/// 10 to a power between the two.
fn spread(random: &mut Random, least: i32, most: i32) -> f64 {
    10.0_f64.powf(random.between(least.into(), most.into()))
}
