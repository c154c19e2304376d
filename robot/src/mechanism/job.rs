use super::tree::Mechanism;
use super::values::JointValues;
use super::walk::{Task, Walk};
use dq8::seams::{Choice, Outputs};
use dq8::storage::Layout;
use dq8::{Scalar, ShapeError};

/// A run over many configurations of a mechanism, as many at a time as there are lanes, with
/// options that all have a default.
///
/// `S` says of which links: [`AllLinks`], or those that [`links`](Self::links) names.
///
/// ```
/// use dq8::DualQuat;
/// use dq8_robot::{Joint, OwnedMechanism};
/// let up = DualQuat::from_translation([0.0_f64, 0.0, 1.0]);
/// let joints = [None, Some(0), Some(1)].map(|on| Joint::prismatic(on, up, [0.0, 0.0, 1.0]));
/// let lift = OwnedMechanism::new(&joints)?;
/// // Two configurations of three values; the third link is the tool.
/// let values = [0.0, 0.5, 0.0, 0.0, 0.0, 0.25];
/// let mut tools = [DualQuat::IDENTITY; 2];
/// lift.job().links(&[2]).poses(&values, &mut tools)?;
/// assert_eq!(tools.map(|tool| tool.translation()[2]), [3.5, 3.25]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Job<'a, R, S = AllLinks> {
    pub(crate) mechanism: Mechanism<'a, R>,
    pub(crate) links: S,
    pub(crate) choice: Choice,
}

/// A [`Job`] over all links of the mechanism.
#[derive(Clone, Copy, Debug)]
pub struct AllLinks;

impl<'a, R: Copy> Mechanism<'a, R> {
    /// A run over many configurations.
    pub fn job(self) -> Job<'a, R> {
        Job { mechanism: self, links: AllLinks, choice: Choice::default() }
    }
}

impl<'a, R: Copy> Job<'a, R> {
    /// Only these links, in this order. Links that carry none of them are not computed; for a tool
    /// at the end of an arm nothing else is stored.
    pub fn links(self, links: &'a [usize]) -> Job<'a, R, &'a [usize]> {
        Job { mechanism: self.mechanism, links, choice: self.choice }
    }
}

impl<R: Copy> Job<'_, R, &[usize]> {
    /// Whether there are these links.
    pub(crate) fn check_links(&self) -> Result<(), ShapeError> {
        let links = self.mechanism.links();
        match self.links.iter().find(|&&link| link >= links) {
            Some(&link) => Err(ShapeError::NoLink { link, links }),
            None => Ok(()),
        }
    }
}

impl<R, S> Job<'_, R, S> {
    dq8::seams::options!();
}

impl<R: Scalar, S: Sync> Job<'_, R, S> {
    /// The walk over all configurations, on as many threads as are asked for. `task` takes a part
    /// of the outputs, from some configuration or block of them on, and says how many it holds.
    pub(crate) fn walk<Y, T, O, K>(
        &self,
        values: &[T],
        outputs: O,
        task: impl Fn(usize, O) -> (usize, K) + Sync,
    ) where
        Y: Layout<Real = R>,
        T: JointValues<Y>,
        O: Outputs,
        K: Task<Y>,
    {
        let (mechanism, backend) = (self.mechanism, self.choice.instructions());
        // Some microseconds of work for each thread, and a multiple of the most lanes.
        let grain = 2048_usize.div_ceil(mechanism.links().max(1));
        let grain = grain.next_multiple_of(dq8_simd::MAX_LANES);
        backend.share(grain, outputs, &|first, part| {
            let (elements, task) = task(first, part);
            let values = T::part(values, mechanism.values, first, elements);
            backend.run(Walk::<Y, _, _> { mechanism, values, elements, task });
        });
    }
}

/// How many configurations, or blocks of them, a part of the output holds, `width` elements each;
/// `all` where that is none.
pub(crate) fn things<E>(part: &[E], width: usize, all: usize) -> usize {
    part.len().checked_div(width).unwrap_or(all)
}
