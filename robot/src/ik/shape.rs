//! The shape of the normal equations of many goals, which is that of the tree: see `tree.rs`.

use super::freedom::Freedom;
use super::goal::Goal;
use crate::mechanism::step::{NONE, Step};
use dq8::Real;

/// Finds the place of each freedom in the tree. How many entries the system has; none where it does
/// not have the shape: where a joint that mimics shares a column, weights differ from axis to axis,
/// or a pose is all that is asked.
pub(super) fn shape<R: Real>(
    steps: &[Step<R>],
    goals: &[Goal<R>],
    rows: usize,
    of_rates: &mut [Freedom<R>],
) -> usize {
    if rows <= 6 || !goals.iter().all(Goal::is_even) {
        return 0;
    }
    let column = |of_rates: &[Freedom<R>], step: &Step<R>, index: usize| {
        of_rates.get(step.rate as usize + index).map_or(NONE, |freedom| freedom.column)
    };
    let (mut twist, mut entries) = (0, 0);
    for step in steps {
        if column(of_rates, step, 0) == NONE {
            continue;
        }
        if step.mimics {
            return 0;
        }
        let of_link = |link: u32| steps.get(steps.get(link as usize)?.position as usize);
        let (mut above, mut carrier) = (NONE, of_link(step.parent));
        while let Some(other) = carrier {
            if other.kind.rates() > 0 {
                above = column(of_rates, other, other.kind.rates() - 1);
                break;
            }
            carrier = of_link(other.parent);
        }
        for index in 0..step.kind.rates() {
            let own = column(of_rates, step, index);
            let depth = of_rates.get(above as usize).map_or(0, |carrier| carrier.depth + 1);
            if let Some(freedom) = of_rates.get_mut(own as usize) {
                (freedom.above, freedom.depth, freedom.twist) = (above, depth, twist);
                freedom.first = entries;
            }
            (above, twist, entries) = (own, twist + 6, entries + depth + 1);
        }
    }
    entries as usize
}
