//! [`Goals`]: the goals of the links of a call.

use crate::argument::{Argument, Input};
use crate::error::misshapen;
use crate::links::{in_order, link_of};
use dq8_robot::ik::Goal;
use pyo3::exceptions::PyValueError;
use pyo3::intern;
use pyo3::prelude::*;

/// The goals of a call, one for each link that was asked for.
#[derive(Debug)]
pub struct Goals {
    pub(crate) goals: Vec<Goal<f64>>,
    /// `true` if the caller gave one link or goal, and no sequence of them.
    pub(crate) one: bool,
    count: [usize; 1],
}

impl Goals {
    /// Makes goals of the argument `links`, where links have these names: links, or goals of
    /// Python. Links have the weights of the call; where it asks for positions, their rotation is
    /// free.
    pub fn of(
        names: &[String],
        links: &Bound<'_, PyAny>,
        weights: Option<&Argument<'_>>,
        positions: bool,
    ) -> PyResult<Self> {
        let plain = if positions { Goal::position } else { Goal::pose };
        let mut own = None;
        let mut goal = |item: &Bound<'_, PyAny>, index| match goal_of(names, item)? {
            Some(goal) => {
                own.get_or_insert(index);
                Ok::<_, PyErr>(goal)
            }
            None => Ok(plain(link_of(names, "links", item)?)),
        };
        let one = is_one(links)?;
        let mut goals = Vec::new();
        if one {
            goals.push(goal(links, 0)?);
        } else {
            for (index, item) in in_order(links)?.enumerate() {
                goals.push(goal(&item?, index)?);
            }
        }
        if let Some(weights) = weights {
            if let Some(goal) = own {
                let message = format!("`weights`: goal {goal} of `links` has weights of its own.");
                return Err(PyValueError::new_err(message));
            }
            weigh(&mut goals, one, weights)?;
        }
        let turns = |goal: &Goal<f64>| goal.angular.iter().any(|&weight| weight != 0.0);
        if let (true, Some(goal)) = (positions, goals.iter().position(turns)) {
            let message = format!("`targets` are positions, and goal {goal} asks for a rotation.");
            return Err(PyValueError::new_err(message));
        }
        Ok(Self { count: [goals.len()], goals, one })
    }

    /// The dimension of the targets that counts goals; empty if the caller gave one goal alone.
    pub(crate) fn each(&self) -> &[usize] {
        if self.one { &[] } else { &self.count }
    }
}

/// Returns `true` for a link or a goal, and `false` for a sequence of them.
fn is_one(links: &Bound<'_, PyAny>) -> PyResult<bool> {
    let is_link = links.extract::<String>().is_ok() || links.extract::<i64>().is_ok();
    Ok(is_link || links.hasattr(intern!(links.py(), "link"))?)
}

/// Reads a `dq8.Goal` of Python. Returns `None` for any other object.
fn goal_of(names: &[String], item: &Bound<'_, PyAny>) -> PyResult<Option<Goal<f64>>> {
    let py = item.py();
    let Some(link) = item.getattr_opt(intern!(py, "link"))? else { return Ok(None) };
    let three = |name| item.getattr(name)?.extract::<[f64; 3]>();
    Ok(Some(Goal {
        link: link_of(names, "links", &link)?,
        angular: three(intern!(py, "angular"))?,
        linear: three(intern!(py, "linear"))?,
        point: three(intern!(py, "point"))?,
    }))
}

/// Gives goals the weights of a call, the same to all or each its own.
fn weigh(goals: &mut [Goal<f64>], one: bool, weights: &Argument<'_>) -> PyResult<()> {
    let weights = Input::<f64>::of(weights)?;
    let count = goals.len();
    if !matches!(weights.full_leading(), []) && (one || weights.full_leading() != [count]) {
        let others = if one { String::new() } else { format!(" or ({count}, 6)") };
        return Err(misshapen("weights", &format!("(6,){others}"), &weights.shape()));
    }
    let weights = weights.filled(&[count])?;
    for (goal, &[a, b, c, x, y, z]) in goals.iter_mut().zip(weights.records::<6>()) {
        (goal.angular, goal.linear) = ([a, b, c], [x, y, z]);
    }
    Ok(())
}
