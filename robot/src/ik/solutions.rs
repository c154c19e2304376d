//! What an arm of six hinges can do for a target.

use core::ops::Deref;
use dq8::Real;

/// All ways in which an arm of six hinges has its tool at a target, the nearest to the start first.
/// A slice of them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solutions<R> {
    all: [Solution<R>; 8],
    count: usize,
    /// Whether there are no others. False where they were searched for: then there may be more.
    pub is_complete: bool,
}

/// One way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solution<R> {
    /// The values of the six hinges, from the base up, within their limits; of the turns that are
    /// there, the nearest to the start.
    pub values: [R; 6],
    /// How far they are from the start: the root of the sum of squares, radians.
    pub distance: R,
    /// Where the arm can move without moving its tool, or comes no farther.
    pub singular: Singular,
}

/// At which of its joints a solution is singular: it is two that meet, where the target is at the
/// edge of what can be reached, or one of infinitely many, of which the one with the angle of the
/// start is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Singular {
    /// The first axis. The centre of the wrist is on it, or as far from the plane of the arm as it
    /// gets.
    pub shoulder: bool,
    /// The second and third axis. The arm is stretched, or folded.
    pub elbow: bool,
    /// The fifth axis. It has put the last axis along one before.
    pub wrist: bool,
}

impl Singular {
    /// Whether it is singular at all.
    #[must_use]
    pub fn any(self) -> bool {
        self.shoulder || self.elbow || self.wrist
    }
}

impl<R: Real> Default for Solutions<R> {
    /// None.
    fn default() -> Self {
        let none =
            Solution { values: [R::ZERO; 6], distance: R::ZERO, singular: Singular::default() };
        Self { all: [none; 8], count: 0, is_complete: true }
    }
}

impl<R> Deref for Solutions<R> {
    type Target = [Solution<R>];

    fn deref(&self) -> &[Solution<R>] {
        self.all.get(..self.count).unwrap_or_default()
    }
}

impl<R: Real> Solutions<R> {
    /// Behind those that are nearer. Of more than eight, which a search may find, the farthest is
    /// left out.
    pub(super) fn insert(&mut self, solution: Solution<R>) {
        let nearer = self.iter().filter(|other| other.distance <= solution.distance).count();
        self.count = self.all.len().min(self.count + 1);
        if let Some([first, rest @ ..]) = self.all.get_mut(nearer..self.count) {
            let mut last = core::mem::replace(first, solution);
            for slot in rest {
                core::mem::swap(slot, &mut last);
            }
        }
    }

    pub(super) fn clear(&mut self, is_complete: bool) {
        (self.count, self.is_complete) = (0, is_complete);
    }
}
