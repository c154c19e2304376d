//! Points, moved by one motion or each by its own.

use crate::backends;
use crate::caches::{Caches, Footprint, Level};
use crate::contest::Contest;
use crate::memory::{Many, Own, Packed, QuatVec3A};
use dq8::{Backend, Block, DualQuat, Quat};
use dq8_fixtures::random::Random;
use glam::{Affine3A, Mat4, Vec3A};
use nalgebra::{Isometry3, Point3, UnitDualQuaternion};
use simba::simd::WideF32x8;
use ultraviolet::{Isometry3x8, Mat4x8, Vec3x8};

#[derive(Clone, Copy, PartialEq)]
pub enum Motions {
    One,
    Each,
}

type Motion = DualQuat<f32>;
type Point = [f32; 3];

const TOLERANCE: f64 = 1e-5;

struct Scene {
    motions: Many<Motion>,
    points: Many<Point>,
}

pub fn with_contest(
    motions: Motions,
    level: Level,
    caches: &Caches,
    run: &mut dyn FnMut(&Contest<'_>),
) {
    let points = Footprint { own: 2 * size_of::<Point>(), most: 2 * size_of::<Vec3A>() };
    let (name, title, footprint) = match motions {
        Motions::One => ("one", "points by one motion", points),
        Motions::Each => {
            let own = points.own + size_of::<Motion>();
            let most = points.most + size_of::<Mat4>();
            ("each", "points, each by its own motion", Footprint { own, most })
        }
    };
    let scene = Scene::new(caches.transforms(level, footprint));
    let mut contest = Contest {
        transforms: scene.points.len(),
        tolerance: TOLERANCE,
        expected: scene.expected(motions),
        ..Contest::new("J4", format!("{name} {}", level.name()), title)
    };
    let mut field = Field { scene: &scene, motions, contest: &mut contest };
    field.own::<Motion>("AoS");
    field.own::<Block<f32, 8>>("8 lanes");
    field.own::<Block<f32, 16>>("16 lanes");
    field.each("dq8 scalar", |m: &Motion, p: &Point| m.transform_point(*p));
    field.each("glam Mat4", |m: &Mat4, p: &Vec3A| m.transform_point3a(*p));
    field.each("glam Affine3A", |m: &Affine3A, p: &Vec3A| m.transform_point3a(*p));
    field.each("glam Quat+Vec3A", |m: &QuatVec3A, p: &Vec3A| m.rotation * *p + m.translation);
    field.each("nalgebra UnitDualQuaternion", |m: &UnitDualQuaternion<f32>, p: &Point3<f32>| m * p);
    field.each(
        "nalgebra UnitDualQuaternion, 8 lanes",
        |m: &UnitDualQuaternion<WideF32x8>, p: &Point3<WideF32x8>| m * p,
    );
    field.each("nalgebra Isometry3, 8 lanes", |m: &Isometry3<WideF32x8>, p: &Point3<WideF32x8>| {
        m * p
    });
    field.each("ultraviolet Isometry3x8", |m: &Isometry3x8, p: &Vec3x8| *m * *p);
    field.each("ultraviolet Mat4x8", |m: &Mat4x8, p: &Vec3x8| m.transform_point3(*p));
    run(&contest);
}

impl Scene {
    fn new(count: usize) -> Self {
        let mut random = Random(8);
        let (mut motions, mut points) = (Vec::new(), Vec::new());
        for _ in 0..Many::<Motion>::DIFFERENT {
            let turn = Quat::from_axis_angle(random.direction(), random.between(-3.0, 3.0));
            motions.push(DualQuat::from_rotation_translation(turn, random.direction()).cast());
            points.push(random.direction().map(|c| c as f32));
        }
        Self { motions: Many::new(1, motions, count), points: Many::new(1, points, count) }
    }

    /// The motion that moves all points, if there is one.
    fn one(&self) -> Motion {
        self.motions.different()[0]
    }

    fn expected(&self, motions: Motions) -> Vec<Vec<f64>> {
        let pairs = self.motions.different().iter().zip(self.points.different());
        let moved = pairs.map(|(&each, point)| {
            let motion = if motions == Motions::One { self.one() } else { each };
            let [x, y, z] = point.map(f64::from);
            // Rows of a matrix: another formula than that of dual quaternions.
            let rows = motion.cast::<f64>().to_matrix3x4();
            rows.map(|[a, b, c, d]| a * x + b * y + c * z + d).to_vec()
        });
        moved.collect()
    }
}

struct Field<'a, 'c> {
    scene: &'a Scene,
    motions: Motions,
    contest: &'c mut Contest<'a>,
}

impl<'a> Field<'a, '_> {
    fn own<M: Own>(&mut self, layout: &str) {
        let one = self.scene.one();
        for backend in backends() {
            self.add(
                format!("dq8 {layout} {backend}"),
                Some(backend),
                move |_: &M, points: &[M::Point], output: &mut [M::Point]| {
                    backend.transform_points(one, points, output).expect("slices of one length");
                },
                move |motions: &[M], points: &[M::Point], output: &mut [M::Point]| {
                    let done = backend.transform_points_each(motions, points, output);
                    done.expect("slices of one length");
                },
            );
        }
    }

    /// The plain loop.
    fn each<M: Packed<Motion>, P: Packed<Point>>(
        &mut self,
        name: &str,
        moved: impl Fn(&M, &P) -> P + Copy + 'a,
    ) {
        self.add(
            name.to_owned(),
            None,
            move |motion: &M, points: &[P], output: &mut [P]| {
                for (output, point) in output.iter_mut().zip(points) {
                    *output = moved(motion, point);
                }
            },
            move |motions: &[M], points: &[P], output: &mut [P]| {
                for ((output, motion), point) in output.iter_mut().zip(motions).zip(points) {
                    *output = moved(motion, point);
                }
            },
        );
    }

    fn add<M: Packed<Motion>, P: Packed<Point>>(
        &mut self,
        name: String,
        backend: Option<Backend>,
        by_one: impl Fn(&M, &[P], &mut [P]) + Copy + 'a,
        by_each: impl Fn(&[M], &[P], &mut [P]) + Copy + 'a,
    ) {
        let scene = self.scene;
        let numbers = |output: &[P], index| scene.points.numbers(output, index);
        match self.motions {
            Motions::One => {
                let one = move || M::gather(&vec![scene.one(); M::LANES]);
                let memory = move || ((one(), scene.points.pack()), scene.points.pack());
                let pass = move |(motion, points): &(M, Vec<P>), output: &mut [P]| {
                    by_one(motion, points, output);
                };
                self.contest.add(name, backend, memory, pass, numbers);
            }
            Motions::Each => {
                let memory = || ((scene.motions.pack(), scene.points.pack()), scene.points.pack());
                let pass = move |(motions, points): &(Vec<M>, Vec<P>), output: &mut [P]| {
                    by_each(motions, points, output);
                };
                self.contest.add(name, backend, memory, pass, numbers);
            }
        }
    }
}
