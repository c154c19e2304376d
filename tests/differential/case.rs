//! Inputs: edge cases and random ones, the same in every run.

use dq8::{DualQuat, Quat, Twist, Wrench};
pub(crate) use dq8_contract::random::Random;
use dq8_contract::sample::Sample;
use std::f64::consts::PI;

/// What any operation may ask for, as `f64`; implementations round it to their own type.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    /// Two unit motions.
    pub(crate) pose: [f64; 8],
    pub(crate) other: [f64; 8],
    /// How the pose changes by unit of time.
    pub(crate) derivative: [f64; 8],
    /// Twists, angular part first; the first is where Jacobians are taken.
    pub(crate) x: [f64; 6],
    pub(crate) y: [f64; 6],
    /// Force, torque.
    pub(crate) wrench: [f64; 6],
    pub(crate) dt: f64,
}

/// How many numbers a [`Case`] holds.
pub(crate) const NUMBERS: usize = 43;

impl Case {
    pub(crate) fn to_numbers(self) -> [f64; NUMBERS] {
        let motions = [self.pose, self.other, self.derivative].concat();
        let twists = [self.x, self.y, self.wrench].concat();
        [motions, twists, vec![self.dt]].concat().try_into().expect("as many as a case holds")
    }

    pub(crate) fn of_numbers(numbers: [f64; NUMBERS]) -> Self {
        let mut rest = numbers.into_iter();
        let mut next = || rest.next().expect("as many as a case holds");
        Self {
            pose: std::array::from_fn(|_| next()),
            other: std::array::from_fn(|_| next()),
            derivative: std::array::from_fn(|_| next()),
            x: std::array::from_fn(|_| next()),
            y: std::array::from_fn(|_| next()),
            wrench: std::array::from_fn(|_| next()),
            dt: next(),
        }
    }

    /// Every number rounded as `M` does.
    pub(crate) fn rounded<M: Sample>(self) -> Self {
        Self::of_numbers(self.to_numbers().map(|n| M::lanes(M::splat(n))[0]))
    }

    /// |ω| of the first twist.
    pub(crate) fn angle(&self) -> f64 {
        length(&self.x[..3])
    }
}

/// [`Case`]s dealt out to the lanes of an implementation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arguments<M: Sample> {
    pub(crate) pose: M,
    pub(crate) other: M,
    pub(crate) derivative: M,
    pub(crate) x: Twist<M::Real>,
    pub(crate) y: Twist<M::Real>,
    pub(crate) wrench: Wrench<M::Real>,
    pub(crate) dt: M::Real,
}

impl<M: Sample> Arguments<M> {
    /// Lane `i` from case `i`; lanes without a case repeat the first.
    pub(crate) fn new(cases: &[Case]) -> Self {
        let dealt: Vec<_> =
            (0..M::LANES).map(|lane| cases.get(lane).unwrap_or(&cases[0]).to_numbers()).collect();
        let mut column = 0;
        let mut next = || {
            column += 1;
            M::real(&dealt.iter().map(|numbers| numbers[column - 1]).collect::<Vec<_>>())
        };
        let pose = M::motion(std::array::from_fn(|_| next()));
        let other = M::motion(std::array::from_fn(|_| next()));
        let derivative = M::motion(std::array::from_fn(|_| next()));
        let x = Twist::from_array(std::array::from_fn(|_| next()));
        let y = Twist::from_array(std::array::from_fn(|_| next()));
        let force = std::array::from_fn(|_| next());
        let torque = std::array::from_fn(|_| next());
        Self { pose, other, derivative, x, y, wrench: Wrench { force, torque }, dt: next() }
    }
}

/// Angles where something happens: nothing at all, subnormal and vanishing squares, where series end
/// (1, √10), half and whole turns.
const ANGLES: [f64; 32] = [
    0.0, 1e-45, 1e-38, 1e-30, 1e-20, 1e-12, 1e-8, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 0.999_999,
    1.000_001, 1.5, 2.0, 2.5, 3.0, 3.135, PI, 3.145, 3.162, 3.1623, 3.2, 4.0, 5.0, 6.0, 6.2, 6.8,
    9.0, 12.0,
];

/// Every angle with twists and translations of several sizes.
pub(crate) fn cases() -> Vec<Case> {
    let mut random = Random(8);
    let mut cases = Vec::new();
    for size in [0.0, 1e-20, 1.0, 30.0, 1e4] {
        for angle in ANGLES {
            cases.push(case(&mut random, angle, size));
        }
        for _ in 0..60 {
            let angle = 6.0 * random.next().abs();
            cases.push(case(&mut random, angle, size));
        }
    }
    cases
}

/// |ω| is `angle`, and translations are of the size `size`.
pub(crate) fn case(random: &mut Random, angle: f64, size: f64) -> Case {
    let pose = random.motion(size);
    let [x, y] = [random.twist(size), random.twist(size.min(1.0))];
    let turns = length(&x[..3]);
    let x = std::array::from_fn(|i| if i < 3 { x[i] / turns * angle } else { x[i] });
    let derivative = pose.derivative_spatial(Twist::from_array(random.twist(size)));
    Case {
        pose: pose.to_array(),
        other: random.motion(size).to_array(),
        derivative: derivative.to_array(),
        x,
        y,
        wrench: random.twist(size.min(1.0)),
        dt: random.next(),
    }
}

pub(crate) fn length(components: &[f64]) -> f64 {
    // Not the plain sum of squares: angles of 1e-200 are among the cases.
    components.iter().fold(0.0, |length: f64, c| length.hypot(*c))
}

/// What these tests draw.
pub(crate) trait Draw {
    /// Evenly from −1 to 1.
    fn next(&mut self) -> f64;

    fn vector(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.next())
    }

    fn twist(&mut self, size: f64) -> [f64; 6] {
        std::array::from_fn(|i| self.next() * if i < 3 { 1.0 } else { size })
    }

    fn axis(&mut self) -> [f64; 3] {
        let axis = self.vector();
        axis.map(|c| c / length(&axis))
    }

    fn motion(&mut self, size: f64) -> DualQuat<f64> {
        let turn = Quat::from_axis_angle(self.axis(), PI * self.next());
        let translation = self.vector().map(|c| c * size);
        DualQuat::from_rotation_translation(turn, translation).normalize()
    }
}

impl Draw for Random {
    fn next(&mut self) -> f64 {
        self.signed()
    }
}
