//! An operation on every pair of two slices.

use crate::backends;
use crate::caches::{Caches, Footprint, Level};
use crate::contest::Contest;
use crate::limit::{Limit, Limited};
use crate::memory::{Element, Many, Own, Packed, Product, QuatVec3A, Rows3x4};
use dq8::{
    Backend, Block, DualQuat, Lanes, Quat, ShapeError, batch,
    simd::{Portable, f32x8, f32x16},
};
use dq8_fixtures::random::Random;
use glam::{Affine3A, Mat4};
use nalgebra::{DualQuaternion, Isometry3, UnitDualQuaternion};
use simba::simd::{SimdValue, WideF32x8};
use ultraviolet::{Isometry3x8, Lerp, Mat4x8, Slerp};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    Product,
    Normalize,
    Inverse,
    Matrix,
    Nlerp,
    Sclerp,
    Log,
    Pow,
}

impl Operation {
    pub const ALL: [Self; 8] = [
        Self::Product,
        Self::Normalize,
        Self::Inverse,
        Self::Matrix,
        Self::Nlerp,
        Self::Sclerp,
        Self::Log,
        Self::Pow,
    ];
}

/// How far interpolation goes, the same for all pairs.
const T: f32 = 0.3;

/// Turns of up to π and shifts of up to 1 in single precision, relative to the larger of both.
const TOLERANCE: f64 = 1e-5;

type Motion = DualQuat<f32>;

/// Two slices and what the operation makes of them.
struct Pairs {
    a: Many<Motion>,
    /// From a, a turn of 0.3 to 2.2 radians and a shift of at most 1: no way is ambiguous, and none
    /// so short that nalgebra's ScLERP in `f32` stands still.
    b: Many<Motion>,
}

pub fn with_contest(
    operation: Operation,
    level: Level,
    caches: &Caches,
    run: &mut dyn FnMut(&Contest<'_>),
) {
    // Two motions in, one out; glam has 64 bytes a motion.
    let footprint = Footprint { own: 3 * size_of::<Motion>(), most: 3 * size_of::<Mat4>() };
    let pairs = Pairs::new(operation, caches.transforms(level, footprint));
    let (contenders, job, name, title): (Contenders<'_>, _, _, _) = match operation {
        Operation::Product => (product, "J1", "", "pairwise product"),
        Operation::Normalize => (normalize, "J5", "normalize ", "normalize"),
        Operation::Inverse => (inverse, "J5", "inverse ", "invert"),
        Operation::Matrix => (matrix, "J5", "matrix ", "rows of a 3×4 matrix"),
        Operation::Nlerp => (nlerp, "J5", "NLERP ", "blend linearly"),
        Operation::Sclerp => (sclerp, "J5", "ScLERP ", "interpolate along screws"),
        Operation::Log => (log, "J5", "log ", "logarithm"),
        Operation::Pow => (pow, "J5", "pow ", "power"),
    };
    let size = format!("{name}{}", level.name());
    let mut contest = Contest {
        transforms: pairs.a.len(),
        tolerance: TOLERANCE,
        ..Contest::new(job, size, title)
    };
    contenders(&pairs, &mut contest);
    run(&contest);
}

/// Adds everyone who does an operation.
type Contenders<'a> = fn(&'a Pairs, &mut Contest<'a>);

/// `own!(pairs, contest, |backend, a, b, output| call)`: this crate's kernel on every layout, with
/// every set of instructions.
///
/// A macro because no closure is generic: each layout needs its own.
macro_rules! own {
    ($pairs:ident, $contest:ident, $kernel:expr) => {
        $pairs.own::<Motion>($contest, "AoS", $kernel);
        $pairs.own::<Block<f32, 8>>($contest, "8 lanes", $kernel);
        $pairs.own::<Block<f32, 16>>($contest, "16 lanes", $kernel);
    };
}

/// `lanes!(pairs, contest, |a, b| outcome)`: the plain loop that users of scalars and of lanes
/// write, with the instructions that the build has.
macro_rules! lanes {
    ($pairs:ident, $contest:ident, |$a:ident, $b:pat_param| $outcome:expr) => {
        $pairs.each($contest, "dq8 scalar", |$a: &Motion, $b: &Motion| $outcome);
        type L8 = batch::DualQuat<f32x8>;
        $pairs.each($contest, "dq8 f32x8", |$a: &L8, $b: &L8| $outcome);
        type L16 = batch::DualQuat<f32x16>;
        $pairs.each($contest, "dq8 f32x16", |$a: &L16, $b: &L16| $outcome);
    };
}

fn product<'a>(pairs: &'a Pairs, contest: &mut Contest<'a>) {
    // By plain matrices: another algebra.
    let matrix = |motion: DualQuat<f64>| Rows3x4(motion.to_matrix3x4());
    contest.expected = pairs.expected(|a, b| matrix(a).product(&matrix(b)));
    contest.limits.extend(Backend::available().map(Limit::multiply_add));
    contest.limited = Some(Limited::MultiplyAdds(48.0));
    fn peer<'a, M: Product + Packed<Motion>>(
        pairs: &'a Pairs,
        contest: &mut Contest<'a>,
        name: &str,
    ) {
        pairs.each(contest, name, |a: &M, b: &M| a.product(b));
    }
    own!(pairs, contest, |backend, a, b, output| backend.mul(a, b, output));
    peer::<Motion>(pairs, contest, "dq8 scalar");
    peer::<Mat4>(pairs, contest, "glam Mat4");
    peer::<Affine3A>(pairs, contest, "glam Affine3A");
    peer::<QuatVec3A>(pairs, contest, "glam Quat+Vec3A");
    peer::<UnitDualQuaternion<f32>>(pairs, contest, "nalgebra UnitDualQuaternion");
    peer::<UnitDualQuaternion<WideF32x8>>(pairs, contest, "nalgebra UnitDualQuaternion, 8 lanes");
    peer::<Isometry3<WideF32x8>>(pairs, contest, "nalgebra Isometry3, 8 lanes");
    peer::<Isometry3x8>(pairs, contest, "ultraviolet Isometry3x8");
    peer::<Mat4x8>(pairs, contest, "ultraviolet Mat4x8");
}

fn normalize<'a>(pairs: &'a Pairs, contest: &mut Contest<'a>) {
    contest.expected = pairs.expected(|a, _| a.normalize());
    own!(pairs, contest, |backend, a, _, output| backend.normalize(a, output));
    pairs.each(contest, "dq8 scalar", |a: &Motion, _: &Motion| a.normalize());
    // By the real norm only, which is enough here: the input is a real multiple of unit ones.
    pairs.each(
        contest,
        "nalgebra DualQuaternion",
        |a: &DualQuaternion<f32>, _: &DualQuaternion<f32>| a.normalize(),
    );
}

fn inverse<'a>(pairs: &'a Pairs, contest: &mut Contest<'a>) {
    contest.expected = pairs.expected(|a, _| a.inverse());
    own!(pairs, contest, |backend, a, _, output| backend.inverse(a, output));
    lanes!(pairs, contest, |a, _| a.inverse());
    pairs.each(contest, "glam Affine3A", |a: &Affine3A, _: &Affine3A| a.inverse());
    type Peer = UnitDualQuaternion<f32>;
    pairs.each(contest, "nalgebra UnitDualQuaternion", |a: &Peer, _: &Peer| a.inverse());
}

fn matrix<'a>(pairs: &'a Pairs, contest: &mut Contest<'a>) {
    let flat = |matrix: [[f64; 4]; 3]| {
        <[f64; 12]>::try_from(matrix.as_flattened()).expect("three rows of four")
    };
    contest.expected = pairs.expected(|a, _| flat(a.to_matrix3x4()));
    lanes!(pairs, contest, |a, _| {
        let [a, b, c] = a.to_matrix3x4();
        [a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3], c[0], c[1], c[2], c[3]]
    });
    // It has 4×4 only.
    type Peer = UnitDualQuaternion<f32>;
    pairs.each(contest, "nalgebra UnitDualQuaternion", |a: &Peer, _: &Peer| a.to_homogeneous());
}

fn log<'a>(pairs: &'a Pairs, contest: &mut Contest<'a>) {
    contest.expected = pairs.expected(|a, _| a.log());
    lanes!(pairs, contest, |a, _| a.log());
}

fn pow<'a>(pairs: &'a Pairs, contest: &mut Contest<'a>) {
    contest.expected = pairs.expected(|a, _| a.pow(f64::from(T)));
    pairs.each(contest, "dq8 scalar", |a: &Motion, _: &Motion| a.pow(T));
    type L8 = batch::DualQuat<f32x8>;
    pairs.each(contest, "dq8 f32x8", |a: &L8, _: &L8| a.pow(<f32x8 as Lanes>::splat(Portable, T)));
    type L16 = batch::DualQuat<f32x16>;
    let wide = <f32x16 as Lanes>::splat(Portable, T);
    pairs.each(contest, "dq8 f32x16", move |a: &L16, _: &L16| a.pow(wide));
}

fn nlerp<'a>(pairs: &'a Pairs, contest: &mut Contest<'a>) {
    let t = f64::from(T);
    contest.expected = pairs.expected(|a, b| a.nlerp(b, t));
    own!(pairs, contest, |backend, a, b, output| backend.nlerp(a, b, T, output));
    pairs.each(contest, "dq8 scalar", |a: &Motion, b: &Motion| a.nlerp(*b, T));
    // By the real norm only, and without a look for the shorter way.
    pairs.each(contest, "nalgebra UnitDualQuaternion", |a: &UnitDualQuaternion<f32>, b| {
        a.nlerp(b, T)
    });
    type Lanes = UnitDualQuaternion<WideF32x8>;
    pairs.each(contest, "nalgebra UnitDualQuaternion, 8 lanes", |a: &Lanes, b| {
        a.nlerp(b, WideF32x8::splat(T))
    });
    // Another way for the translation, which is what users of glam and ultraviolet go.
    let straight = pairs.expected(|a, b| straight(a, b, a.nlerp(b, t).rotation(), t));
    pairs.each(contest, "glam Quat+Vec3A", |a: &QuatVec3A, b| QuatVec3A {
        rotation: a.rotation.lerp(b.rotation, T),
        translation: a.translation.lerp(b.translation, T),
    });
    contest.last_should(straight.clone());
    pairs.each(contest, "ultraviolet Isometry3x8", |a: &Isometry3x8, b| Isometry3x8 {
        rotation: a.rotation.lerp(b.rotation, ultraviolet::f32x8::splat(T)).normalized(),
        translation: a.translation.lerp(b.translation, ultraviolet::f32x8::splat(T)),
    });
    contest.last_should(straight);
}

fn sclerp<'a>(pairs: &'a Pairs, contest: &mut Contest<'a>) {
    let t = f64::from(T);
    contest.expected = pairs.expected(|a, b| a.sclerp(b, t));
    own!(pairs, contest, |backend, a, b, output| backend.sclerp(a, b, T, output));
    pairs.each(contest, "dq8 scalar", |a: &Motion, b: &Motion| a.sclerp(*b, T));
    pairs.each(contest, "nalgebra UnitDualQuaternion", |a: &UnitDualQuaternion<f32>, b| {
        a.sclerp(b, T)
    });
    // No screws, but what users of glam and ultraviolet do instead.
    let straight = pairs.expected(|a, b| straight(a, b, a.sclerp(b, t).rotation(), t));
    pairs.each(contest, "glam slerp + lerp", |a: &QuatVec3A, b| QuatVec3A {
        rotation: a.rotation.slerp(b.rotation, T),
        translation: a.translation.lerp(b.translation, T),
    });
    contest.last_should(straight.clone());
    pairs.each(contest, "ultraviolet slerp + lerp, 8 lanes", |a: &Isometry3x8, b| Isometry3x8 {
        rotation: a.rotation.slerp(b.rotation, ultraviolet::f32x8::splat(T)),
        translation: a.translation.lerp(b.translation, ultraviolet::f32x8::splat(T)),
    });
    contest.last_should(straight);
}

/// The rotation, and the translation on the straight way from one to the other.
fn straight(a: DualQuat<f64>, b: DualQuat<f64>, rotation: Quat<f64>, t: f64) -> DualQuat<f64> {
    let (a, b) = (a.translation(), b.translation());
    let translation = [0, 1, 2].map(|c| a[c] + t * (b[c] - a[c]));
    DualQuat::from_rotation_translation(rotation, translation)
}

impl Pairs {
    fn new(operation: Operation, count: usize) -> Self {
        let mut random = Random(8);
        let (mut a, mut b) = (Vec::new(), Vec::new());
        for _ in 0..Many::<Motion>::DIFFERENT {
            let (motion, way) = (motion(&mut random, -3.0, 3.0), motion(&mut random, 0.3, 2.2));
            let norm = match operation {
                Operation::Normalize => random.between(0.5, 2.0),
                _ => 1.0,
            };
            a.push(motion.scale(norm).cast());
            b.push((motion * way).cast());
        }
        let [a, b] = [a, b].map(|different| Many::new(1, different, count));
        Self { a, b }
    }

    fn expected<O: Element>(
        &self,
        operation: impl Fn(DualQuat<f64>, DualQuat<f64>) -> O,
    ) -> Vec<Vec<f64>> {
        let pairs = self.a.different().iter().zip(self.b.different());
        pairs.map(|(&a, &b)| operation(a.cast(), b.cast()).numbers(0)).collect()
    }

    fn own<'a, P: Own>(
        &'a self,
        contest: &mut Contest<'a>,
        layout: &str,
        kernel: impl Fn(Backend, &[P], &[P], &mut [P]) -> Result<(), ShapeError> + Copy + 'a,
    ) {
        for backend in backends() {
            let pass = move |(a, b): &(Vec<P>, Vec<P>), output: &mut [P]| {
                kernel(backend, a, b, output).expect("slices of one length");
            };
            let output = |a: &[P], _: &[P]| a.to_vec();
            self.add(contest, &format!("dq8 {layout} {backend}"), Some(backend), output, pass);
        }
    }

    /// The plain loop.
    fn each<'a, I: Packed<Motion>, O: Element>(
        &'a self,
        contest: &mut Contest<'a>,
        name: &str,
        operation: impl Fn(&I, &I) -> O + Copy + 'a,
    ) {
        let pass = move |(a, b): &(Vec<I>, Vec<I>), output: &mut [O]| {
            for ((output, a), b) in output.iter_mut().zip(a).zip(b) {
                *output = operation(a, b);
            }
        };
        let output =
            move |a: &[I], b: &[I]| a.iter().zip(b).map(|(a, b)| operation(a, b)).collect();
        self.add(contest, name, None, output, pass);
    }

    fn add<'a, I: Packed<Motion>, O: Element>(
        &'a self,
        contest: &mut Contest<'a>,
        name: &str,
        backend: Option<Backend>,
        output: impl Fn(&[I], &[I]) -> Vec<O> + 'a,
        pass: impl Fn(&(Vec<I>, Vec<I>), &mut [O]) + Copy + 'a,
    ) {
        let memory = move || {
            let (a, b) = (self.a.pack(), self.b.pack());
            let output = output(&a, &b);
            ((a, b), output)
        };
        contest.add(name, backend, memory, pass, |output, index| self.a.numbers(output, index));
    }
}

fn motion(random: &mut Random, least: f64, most: f64) -> DualQuat<f64> {
    let turn = Quat::from_axis_angle(random.direction(), random.between(least, most));
    let shift = random.between(0.0, 1.0);
    DualQuat::from_rotation_translation(turn, random.direction().map(|c| c * shift))
}
