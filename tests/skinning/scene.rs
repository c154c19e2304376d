//! Random skins, palettes and meshes.

use dq8::skinning::{Blender, Skin, Surface, SurfaceMut};
use dq8::{Backend, DualQuat, Quat, Scalar};
use dq8_contract::random::Random;

pub(crate) const JOINTS: usize = 11;

pub(crate) struct Scene<R> {
    pub(crate) influences: usize,
    pub(crate) joints: Vec<u16>,
    pub(crate) weights: Vec<R>,
    pub(crate) motions: Vec<DualQuat<R>>,
    pub(crate) stretches: Vec<[[R; 4]; 3]>,
    pub(crate) positions: Vec<[R; 3]>,
    pub(crate) normals: Vec<[R; 3]>,
}

pub(crate) fn vector<R: Scalar>(vector: [f64; 3]) -> [R; 3] {
    vector.map(<R as dq8::Real>::from_f64)
}

pub(crate) fn motion<R: Scalar>(random: &mut Random) -> DualQuat<R> {
    let turn = Quat::from_axis_angle(vector(random.direction()), from(random.between(-3.0, 3.0)));
    let motion = DualQuat::from_rotation_translation(turn, vector(random.direction()));
    if random.between(0.0, 1.0) < 0.5 { motion } else { -motion }
}

pub(crate) fn from<R: Scalar>(value: f64) -> R {
    <R as dq8::Real>::from_f64(value)
}

impl<R: Scalar> Scene<R> {
    pub(crate) fn new(vertices: usize, influences: usize) -> Self {
        let mut random = Random(1 + vertices as u64 + 1000 * influences as u64);
        let (mut joints, mut weights) = (Vec::new(), Vec::new());
        for _ in 0..vertices {
            let some: Vec<_> = (0..influences).map(|_| random.between(0.0, 1.0)).collect();
            let total: f64 = some.iter().sum();
            for weight in some {
                weights.push(from(weight / total));
                joints.push(random.below(JOINTS) as u16);
            }
        }
        let stretch = |random: &mut Random| {
            let mut row = || vector(random.direction()).map(|c: R| c * from(0.3));
            let [[a, b, c], [d, e, f], [g, h, i]] = [row(), row(), row()];
            let one = R::ONE;
            [[one + a, b, c, R::ZERO], [d, one + e, f, R::ZERO], [g, h, one + i, R::ZERO]]
        };
        Self {
            influences,
            joints,
            weights,
            motions: (0..JOINTS).map(|_| motion(&mut random)).collect(),
            stretches: (0..JOINTS).map(|_| stretch(&mut random)).collect(),
            positions: (0..vertices).map(|_| vector(random.direction())).collect(),
            normals: (0..vertices).map(|_| vector(random.direction())).collect(),
        }
    }

    pub(crate) fn skin(&self) -> Skin<'_, u16, R>
    where
        R: dq8::skinning::Weight,
    {
        Skin::new(JOINTS, self.influences, &self.joints, &self.weights).unwrap()
    }

    pub(crate) fn matrices(&self) -> Vec<[[R; 4]; 3]> {
        self.motions.iter().map(|motion| motion.to_matrix3x4()).collect()
    }
}

/// What becomes of the positions.
pub(crate) fn posed<R: Scalar + dq8::skinning::Weight>(
    backend: Backend,
    skin: &Skin<'_, u16, R>,
    blend: impl Blender<R>,
    positions: &[[R; 3]],
) -> Vec<[R; 3]> {
    let mut posed = vec![[R::NAN; 3]; positions.len()];
    let (from, to) = (Surface::positions(positions), SurfaceMut::positions(&mut posed));
    skin.job().backend(backend).pose(blend, from, to).unwrap();
    posed
}

pub(crate) fn distance<R: Scalar>(a: [R; 3], b: [R; 3]) -> f64 {
    let square = |i: usize| (a[i].into() - b[i].into()).powi(2);
    (square(0) + square(1) + square(2)).sqrt()
}
