//! The built-in tube of two joints, twisted and bent, by three methods.

use crate::drawing::{Panel, Triangle, svg};
use dq8::scalar::vector::{cross, dot, norm, sub};
use dq8::skinning::{DualBlend, Linear, Mixed, Skin, SkinningError, Surface, SurfaceMut};
use dq8::{DualQuat, Quat};

const RINGS: usize = 49;
const AROUND: usize = 32;
const LENGTH: f64 = 4.0;
const RADIUS: f64 = 0.6;

/// The mesh at rest, along x, and the weights of the joints.
struct Tube {
    points: Vec<[f64; 3]>,
    joints: Vec<u8>,
    weights: Vec<f64>,
}

impl Tube {
    fn new() -> Self {
        let (mut points, mut joints, mut weights) = (Vec::new(), Vec::new(), Vec::new());
        for ring in 0..RINGS {
            let along = ring as f64 / (RINGS - 1) as f64;
            // The joints share the middle half; the ends are one joint's alone.
            let share = (2.0 * along - 0.5).clamp(0.0, 1.0);
            for i in 0..AROUND {
                let (sin, cos) = (core::f64::consts::TAU * i as f64 / AROUND as f64).sin_cos();
                points.push([LENGTH * (along - 0.5), RADIUS * cos, RADIUS * sin]);
                joints.extend([0, 1]);
                weights.extend([1.0 - share, share]);
            }
        }
        Self { points, joints, weights }
    }

    /// The second joint turns in the middle of the tube; 0 is linear, 1 dual.
    fn posed(&self, turn: Quat<f64>, share: f64) -> Result<Vec<[f64; 3]>, SkinningError> {
        let skin = Skin::new(2, 2, &self.joints, &self.weights)?;
        let motions = [DualQuat::IDENTITY, DualQuat::from_rotation(turn)];
        let matrices = motions.map(|motion| motion.to_matrix3x4());
        let shares = vec![share; self.points.len()];
        let mix = Mixed::new(Linear::new(&matrices), DualBlend::new(&motions), &shares)?;
        let mut posed = self.points.clone();
        let to = SurfaceMut::positions(&mut posed);
        skin.pose(mix, Surface::positions(&self.points), to)?;
        Ok(posed)
    }
}

fn center(points: &[[f64; 3]], ring: usize) -> [f64; 3] {
    let ring = &points[ring * AROUND..(ring + 1) * AROUND];
    [0, 1, 2].map(|c| ring.iter().map(|point| point[c]).sum::<f64>() / AROUND as f64)
}

/// The sides, and the caps with a center each.
fn triangles(points: &[[f64; 3]]) -> Vec<Triangle> {
    let point = |ring: usize, i: usize| points[ring * AROUND + i % AROUND];
    let mut all = Vec::new();
    for i in 0..AROUND {
        for ring in 0..RINGS - 1 {
            all.push([point(ring, i), point(ring, i + 1), point(ring + 1, i)]);
            all.push([point(ring, i + 1), point(ring + 1, i + 1), point(ring + 1, i)]);
        }
        all.push([center(points, 0), point(0, i + 1), point(0, i)]);
        all.push([center(points, RINGS - 1), point(RINGS - 1, i), point(RINGS - 1, i + 1)]);
    }
    all
}

/// A sixth of the sum of the determinants of the corners.
fn volume(triangles: &[Triangle]) -> f64 {
    let determinants = triangles.iter().map(|&[a, b, c]| dot(a, cross(b, c)));
    // Outward is where the triangles go round clockwise here.
    determinants.sum::<f64>().abs() / 6.0
}

/// Along the centers of the rings.
fn length(points: &[[f64; 3]]) -> f64 {
    (1..RINGS).map(|ring| norm(sub(center(points, ring), center(points, ring - 1)))).sum()
}

/// The triangles of the tube, and its volume and length relative to rest.
pub(crate) fn measured(
    turn: Quat<f64>,
    share: f64,
) -> Result<(Vec<Triangle>, f64, f64), SkinningError> {
    let tube = Tube::new();
    let posed = tube.posed(turn, share)?;
    let (rest, bent) = (triangles(&tube.points), triangles(&posed));
    let (volume, length) = (volume(&bent) / volume(&rest), length(&posed) / length(&tube.points));
    Ok((bent, volume, length))
}

pub(crate) fn twist() -> Quat<f64> {
    Quat::from_axis_angle([1.0, 0.0, 0.0], core::f64::consts::PI)
}

pub(crate) fn bend() -> Quat<f64> {
    Quat::from_axis_angle([0.0, 0.0, 1.0], 110_f64.to_radians())
}

/// A table, and the pictures.
pub(crate) fn report() -> Result<(String, String), SkinningError> {
    let mut report = String::from("tube            method  volume  length (rest = 1)\n");
    let mut panels = Vec::new();
    for (what, turn) in [("twisted by 180°", twist()), ("bent by 110°", bend())] {
        for (method, share) in [("LBS", 0.0), ("mix", 0.5), ("DLB", 1.0)] {
            let (triangles, volume, length) = measured(turn, share)?;
            report += &format!("{what:15} {method:6} {volume:7.3} {length:7.3}\n");
            let title = format!("{what}, {method}: volume {volume:.3}, length {length:.3}");
            panels.push(Panel { title, triangles });
        }
    }
    Ok((report, svg(&panels)))
}
