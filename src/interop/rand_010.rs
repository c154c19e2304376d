//! Uniform rotations and poses for rand 0.10: `rng.random::<Quat<f32>>()`.

use crate::number::Real;
use crate::scalar::{DualQuat, Quat};
use rand::distr::{Distribution, StandardUniform};
use rand::{Rng, RngExt};

/// Draws uniformly from all rotations (Shoemake 1992): (x, y) and (z, w) are random points on
/// circles with the radii √(1−u) and √u, for a random u.
impl<R: Real> Distribution<Quat<R>> for StandardUniform
where
    Self: Distribution<R>,
{
    fn sample<G: Rng + ?Sized>(&self, rng: &mut G) -> Quat<R> {
        let [u, first, second]: [R; 3] = [rng.random(), rng.random(), rng.random()];
        let turn = R::TWO * R::PI;
        let (inner, outer) = ((R::ONE - u).sqrt(), u.sqrt());
        let (first, second) = (turn * first, turn * second);
        let [x, y] = [inner * first.sin(), inner * first.cos()];
        Quat::from_xyzw(x, y, outer * second.sin(), outer * second.cos()).normalize()
    }
}

/// Draws a uniform rotation, and a translation that is uniform in a cube: each coordinate is from
/// −1 to 1.
impl<R: Real> Distribution<DualQuat<R>> for StandardUniform
where
    Self: Distribution<R>,
{
    fn sample<G: Rng + ?Sized>(&self, rng: &mut G) -> DualQuat<R> {
        let rotation = <Self as Distribution<Quat<R>>>::sample(self, rng);
        let translation: [R; 3] = [rng.random(), rng.random(), rng.random()];
        DualQuat::from_rotation_translation(rotation, translation.map(|c| c * R::TWO - R::ONE))
    }
}
