//! A mesh with four influences per vertex, positions, in plain slices.
//!
//! ozz-animation is C++. What is here is its layout and its order of computing, in the lanes of the
//! build target, which is not its code.

use crate::backends;
use crate::contest::Contest;
use crate::memory::{Element, Packed, Representation};
use dq8::skinning::{DualBlend, Linear, Skin, Surface, SurfaceMut, dual_blend, linear_blend};
use dq8::{DualQuat, Quat, representation::Affine};
use dq8_fixtures::random::Random;
use glam::{Affine3A, Mat3A, Mat4, Vec3A};
use nalgebra::{DualQuaternion, Point3, UnitDualQuaternion};
use std::cell::RefCell;

const VERTICES: usize = 1 << 15;
const JOINTS: usize = 64;
const TOLERANCE: f64 = 1e-5;

struct Scene {
    joints: Vec<[u16; 4]>,
    weights: Vec<[f32; 4]>,
    motions: Vec<DualQuat<f32>>,
    points: Vec<[f32; 3]>,
}

impl Scene {
    fn new() -> Self {
        let mut random = Random(16);
        let motion = |random: &mut Random| {
            let turn = Quat::from_axis_angle(random.direction(), random.between(-1.5, 1.5));
            let motion = DualQuat::from_rotation_translation(turn, random.direction());
            if random.between(0.0, 1.0) < 0.5 { motion.cast() } else { -motion.cast() }
        };
        let motions = (0..JOINTS).map(|_| motion(&mut random)).collect();
        let (mut joints, mut weights, mut points) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..VERTICES {
            let some = [(); 4].map(|()| random.between(0.01, 1.0));
            let total: f64 = some.iter().sum();
            weights.push(some.map(|weight| (weight / total) as f32));
            joints.push([(); 4].map(|()| random.below(JOINTS) as u16));
            points.push(random.direction().map(|c| c as f32));
        }
        Self { joints, weights, motions, points }
    }

    fn skin(&self) -> Skin<'_, u16, f32> {
        let (joints, weights) = (self.joints.as_flattened(), self.weights.as_flattened());
        Skin::new(JOINTS, 4, joints, weights).expect("a good skin")
    }

    /// What becomes of the points, in `f64`.
    fn expected(&self, dual: bool) -> Vec<Vec<f64>> {
        let vertices = self.joints.iter().zip(&self.weights).zip(&self.points);
        let posed = vertices.map(|((joints, weights), point)| {
            let of = |i: usize| self.motions[usize::from(joints[i])].cast();
            let map = if dual {
                let influences = [0, 1, 2, 3].map(|i| (of(i), f64::from(weights[i])));
                Affine::from_motion(dual_blend(&influences).expect("four influences"))
            } else {
                let matrices = [0, 1, 2, 3].map(|i| (of(i).to_matrix3x4(), f64::from(weights[i])));
                Affine::from_matrix3x4(linear_blend(&matrices))
            };
            map.transform_point(point.map(f64::from)).to_vec()
        });
        posed.collect()
    }
}

pub(super) fn with_contest(run: &mut dyn FnMut(&Contest<'_>)) {
    let scene = Scene::new();
    let skin = scene.skin();
    let dual = scene.expected(true);
    let matrices: Vec<_> = scene.motions.iter().map(|motion| motion.to_matrix3x4()).collect();
    let turned = RefCell::new(scene.points.clone());
    let mut contest = Contest {
        transforms: VERTICES,
        tolerance: TOLERANCE,
        expected: scene.expected(false),
        ..Contest::new("J7", "32768 vertices", "skinning, four influences")
    };
    let memory = || (scene.points.clone(), scene.points.clone());
    for backend in backends() {
        let (job, matrices, motions) =
            (skin.job().backend(backend), &matrices[..], &scene.motions[..]);
        let linear = move |points: &Vec<[f32; 3]>, posed: &mut [[f32; 3]]| {
            let (from, to) = (Surface::positions(points), SurfaceMut::positions(posed));
            job.pose(Linear::new(matrices), from, to).expect("slices of one length");
        };
        contest.add(format!("dq8 LBS {backend}"), Some(backend), memory, linear, numbers);
        let blend = move |points: &Vec<[f32; 3]>, posed: &mut [[f32; 3]]| {
            let (from, to) = (Surface::positions(points), SurfaceMut::positions(posed));
            job.pose(DualBlend::new(motions), from, to).expect("slices of one length");
        };
        contest.add(format!("dq8 DLB {backend}"), Some(backend), memory, blend, numbers);
        contest.last_should(dual.clone());
        // Points on a sphere are their normals.
        let turned = &turned;
        let normals = move |points: &Vec<[f32; 3]>, posed: &mut [_]| {
            let mut turned = turned.borrow_mut();
            let from = Surface::positions(points).normals(points);
            let to = SurfaceMut::positions(posed).normals(&mut turned);
            job.pose(DualBlend::new(motions), from, to).expect("slices of one length");
        };
        let name = format!("dq8 DLB and normals {backend}");
        contest.add(name, Some(backend), memory, normals, numbers);
        contest.last_should(dual.clone());
    }
    glam(&mut contest, &scene);
    ozz_layout(&mut contest, &scene);
    nalgebra(&mut contest, &scene);
    contest.last_should(dual);
    run(&contest);
}

fn numbers<P: Element>(posed: &[P], index: usize) -> Vec<f64> {
    posed[index].numbers(0)
}

/// Matrices are summed, or moved points: whichever is faster here.
fn glam<'a>(contest: &mut Contest<'a>, scene: &'a Scene) {
    let (joints, weights) = (&scene.joints, &scene.weights);
    let memory = move || {
        let palette: Vec<_> = scene.motions.iter().map(Affine3A::from_motion).collect();
        let points: Vec<_> = scene.points.iter().map(|&point| Vec3A::from(point)).collect();
        ((palette, points.clone()), points)
    };
    let sums = move |(palette, points): &(Vec<Affine3A>, Vec<Vec3A>), posed: &mut [Vec3A]| {
        for (vertex, posed) in posed.iter_mut().enumerate() {
            let weight = weights[vertex];
            let joint = joints[vertex].map(|joint| &palette[usize::from(joint)]);
            let sum = |column: [Vec3A; 4]| {
                column[0] * weight[0]
                    + column[1] * weight[1]
                    + column[2] * weight[2]
                    + column[3] * weight[3]
            };
            let linear = Mat3A::from_cols(
                sum(joint.map(|m| m.x_axis)),
                sum(joint.map(|m| m.y_axis)),
                sum(joint.map(|m| m.z_axis)),
            );
            *posed = linear * points[vertex] + sum(joint.map(|m| m.translation));
        }
    };
    contest.add("glam Affine3A LBS, sum of matrices", None, memory, sums, numbers);
    let points = move |(palette, points): &(Vec<Affine3A>, Vec<Vec3A>), posed: &mut [Vec3A]| {
        for (vertex, posed) in posed.iter_mut().enumerate() {
            *posed = Vec3A::ZERO;
            for (&joint, &weight) in joints[vertex].iter().zip(&weights[vertex]) {
                *posed += palette[usize::from(joint)].transform_point3a(points[vertex]) * weight;
            }
        }
    };
    contest.add("glam Affine3A LBS, sum of points", None, memory, points, numbers);
}

/// Points of three numbers, joints of 16 bits, one weight less than joints, matrices of four
/// columns of four numbers; for one vertex after the other the matrices are summed, and the point
/// is a sum of columns.
fn ozz_layout<'a>(contest: &mut Contest<'a>, scene: &'a Scene) {
    /// The palette, weights, points.
    type Given = (Vec<Mat4>, Vec<[f32; 3]>, Vec<[f32; 3]>);
    let memory = move || {
        let palette: Vec<_> = scene.motions.iter().map(Mat4::from_motion).collect();
        let weights: Vec<_> = scene.weights.iter().map(|&[a, b, c, _]| [a, b, c]).collect();
        ((palette, weights, scene.points.clone()), scene.points.clone())
    };
    let joints = &scene.joints;
    let pass = move |(palette, weights, points): &Given, posed: &mut [[f32; 3]]| {
        let vertices = posed.iter_mut().zip(joints).zip(weights).zip(points);
        for (((posed, joints), &[a, b, c]), &[x, y, z]) in vertices {
            let [i, j, k, l] = joints.map(|joint| palette[usize::from(joint)]);
            let sum = i * a + j * b + k * c + l * (1.0 - (a + b + c));
            let point = sum.x_axis * x + sum.y_axis * y + sum.z_axis * z + sum.w_axis;
            *posed = point.truncate().to_array();
        }
    };
    contest.add("ozz's layout, 4×4 matrices LBS", None, memory, pass, numbers);
}

/// With the signs that nalgebra does not choose by itself.
fn nalgebra<'a>(contest: &mut Contest<'a>, scene: &'a Scene) {
    type Palette = Vec<DualQuaternion<f32>>;
    let (joints, weights) = (&scene.joints, &scene.weights);
    let memory = move || {
        let palette: Vec<_> = scene.motions.chunks(1).map(DualQuaternion::gather).collect();
        let points: Vec<_> = scene.points.iter().map(|&point| Point3::from(point)).collect();
        ((palette, points.clone()), points)
    };
    let pass = move |(palette, points): &(Palette, Vec<Point3<f32>>), posed: &mut [Point3<f32>]| {
        for (vertex, posed) in posed.iter_mut().enumerate() {
            let (joints, weights) = (joints[vertex], weights[vertex]);
            let mut pivot = 0;
            for i in 1..4 {
                pivot = if weights[i] > weights[pivot] { i } else { pivot };
            }
            let pivot = palette[usize::from(joints[pivot])].real;
            let mut sum = palette[usize::from(joints[0])] * 0.0;
            for (&joint, &weight) in joints.iter().zip(&weights) {
                let motion = palette[usize::from(joint)];
                let away = motion.real.dot(&pivot) < 0.0;
                sum += motion * if away { -weight } else { weight };
            }
            *posed = UnitDualQuaternion::new_normalize(sum) * points[vertex];
        }
    };
    contest.add("nalgebra DualQuaternion DLB", None, memory, pass, numbers);
}
