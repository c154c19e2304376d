use crate::real::Real;
use crate::scalar::DualQuat;

/// How many an arm keeps. Twice as many raise the success on an arm with narrow limits by half a per cent, half as
/// many lower it by as much.
pub(super) const KEPT: usize = 128;

/// Configurations of a mechanism with one goal, and where they take it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beginnings<'a, R> {
    /// `[configuration][value]`
    pub(super) values: &'a [R],
    pub(super) poses: &'a Poses<R>,
}

/// Rotations and halves of translations, number by number, as lanes take them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Poses<R>(pub(super) [[R; KEPT]; 7]);

impl<R: Real> Poses<R> {
    pub(super) const NONE: Self = Self([[R::ZERO; KEPT]; 7]);

    pub(super) fn set(&mut self, index: usize, pose: DualQuat<R>) {
        let ([x, y, z, w], [tx, ty, tz]) = (pose.rotation().to_array(), pose.translation());
        let numbers = [x, y, z, w, tx * R::HALF, ty * R::HALF, tz * R::HALF];
        for (row, number) in self.0.iter_mut().zip(numbers) {
            if let Some(slot) = row.get_mut(index) {
                *slot = number;
            }
        }
    }
}
