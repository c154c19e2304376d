//! Where links are, and the screws of the joints that move them.

use super::model::Model;
use super::scratch::{GOAL, POSE, Rows, TARGET};
use crate::mechanism::step::NONE;
use crate::mechanism::values::JointNumbers;
use crate::mechanism::walk::Placed;
use crate::mechanism::walk::{Joined, moved};
use dq8::batch::vector;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, Level};

/// Of which values.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    /// Of where the lanes are: screws too.
    Values,
    /// Of where they might begin again.
    Candidates,
}

struct Numbers<'r, 's, L: Lanes>(&'r Rows<'s, L>);

impl<L: Lanes> JointNumbers<L> for Numbers<'_, '_, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn get(&mut self, level: L::Level, index: usize) -> L {
        self.0.get(level, index)
    }
}

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// The poses of the links with goals, from the base up; links that carry none are left out.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn place(&mut self, of: Of) {
        let (level, reach) = (self.level, self.reach);
        let scratch = &mut self.scratch;
        let values = match of {
            Of::Values => &scratch.values,
            Of::Candidates => &scratch.candidate,
        };
        let mut numbers = Numbers(values);
        let one_half = L::splat(level, L::Real::HALF);
        let (mut position, mut twist) = (0, 0);
        while let Some(step) = reach.mechanism.steps.get(position) {
            if !reach.moves_goal(position) {
                position += step.size as usize;
                continue;
            }
            position += 1;
            let before = if step.parent == NONE {
                Placed::root(level, step)
            } else {
                get(level, &scratch.slots, step.parent_slot as usize * POSE).place(step)
            };
            let pose = moved(level, before, step, &mut numbers);
            put(&mut scratch.slots, step.slot as usize * POSE, pose);
            if of == Of::Values {
                let joined = Joined { before, pose };
                for index in 0..step.kind.rates() {
                    scratch.twists.set_record(twist, joined.screw(step, index).to_array());
                    twist += 6;
                }
            }
            for (index, goal) in reach.goals.iter().enumerate() {
                if goal.link == step.link as usize {
                    let mut there = pose;
                    if goal.is_off() {
                        let half = vector::scale(vector::splat(level, goal.point), one_half);
                        there.half = pose.moved(half);
                    }
                    put(&mut scratch.goals, index * GOAL + TARGET, there);
                }
            }
        }
    }

    /// The same for a search that needs both kinds of values. In line it holds the code twice, and
    /// takes a tenth less time for one configuration: firmware calls it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn place_or_call(&mut self, of: Of) {
        if cfg!(target_os = "none") { self.call_place(of) } else { self.place(of) }
    }

    #[inline(never)]
    fn call_place(&mut self, of: Of) {
        self.level.run(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || self.place(of),
        );
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn put<L: Lanes<Real: Scalar>>(rows: &mut Rows<'_, L>, at: usize, pose: Placed<L>) {
    rows.set_record(at, pose.rotation);
    rows.set_record(at + 4, pose.half);
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn get<L: Lanes<Real: Scalar>>(
    level: L::Level,
    rows: &Rows<'_, L>,
    at: usize,
) -> Placed<L> {
    Placed { rotation: rows.record(level, at), half: rows.record(level, at + 4) }
}
