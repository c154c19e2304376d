//! Drift (Kenwright §10 and §11): a linked chain follows a target, and every frame multiplies a small
//! step onto the state of every joint.

mod chain;
mod experiment;
mod representation;
mod target;

pub use chain::{Chain, LINKS, Order, Steps};
pub use experiment::{METHODS, Measure, Method, ROUNDS, Sample, finals, trace};
pub use representation::{Homogeneous, Representation, RotationTranslation, kenwright_normalize};
pub use target::follow;

use crate::report::{Chart, Section, Series, Table, paragraph, scientific};
use std::error::Error;

const FRAMES: usize = 20_000;
/// Frames for one round of the target whose curves are drawn.
const DRAWN: usize = 1000;
/// Frames between points of a curve.
const EVERY: usize = 100;

/// Runs the experiment and writes it up.
///
/// # Errors
/// If a chart cannot be drawn.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let (state_step, missed) = finals(FRAMES, Order::StateStep);
    let (step_state, _) = finals(FRAMES, Order::StepState);
    let mut body = charts()?;
    body += &paragraph(&format!(
        "Skew and scale are the largest elements of AᵀA − 1, off the diagonal and on it, over the \
         frames of all links as they act on points; norm is |det A − 1|, ||p| − 1|, and for dual \
         quaternions the larger of this and |p·q|; the end is compared with where the same steps lead in \
         double precision. A jump is what upkeep moves the end by in one frame. A quaternion turns points by \
         v + 2r × (r × v + wv), as everyone computes it; this takes |p| = 1 for granted, and skews where \
         that is not so. By pvp* it would only scale, by |p|². The curves are those of a target that goes \
         round in {DRAWN} frames, with steps that carry the links."
    ));
    let each = "the joint turns about itself: state · step";
    body += &table(&format!("After {FRAMES} frames, {each}"), &state_step);
    let each = "the step carries the link: step · state";
    body += &table(&format!("After {FRAMES} frames, {each}"), &step_state);
    Ok(Section {
        title: "Drift: a chain that follows a target".to_owned(),
        tried: format!(
            "A chain of {LINKS} links of length 1 follows a target of six degrees of freedom for {FRAMES} \
             frames. Damped least squares in double precision find the small turn of each joint; this is \
             rounded to single precision and multiplied onto the state of the joint, again and again, in \
             each representation by its own arithmetic. Tables hold root mean squares over targets of \
             {} speeds (a round in {} to {} frames); the exact chain misses its target by at most {} \
             links.",
            ROUNDS.len(),
            ROUNDS[0],
            ROUNDS[ROUNDS.len() - 1],
            scientific(missed),
        ),
        claimed: [
            "Kenwright §10.1: concatenated matrices show skewing and scaling.",
            "Kenwright §10.1: making them orthonormal between updates removes both, but the joints show \
             discontinuities and the end effector is not where it should be.",
            "Kenwright §10.2: dual quaternions drift from unit length, which renormalizing mends; \
             repairing a matrix is much more complicated.",
            "Kenwright §12: the problem and cost of drifting and normalizing is less with dual quaternions.",
            "Kenwright §13.1: Normalize, which divides by the square of the norm.",
        ]
        .map(str::to_owned)
        .to_vec(),
        found: found(&state_step, &step_state),
        verdict: "That matrices skew and scale is true; dual quaternions that nobody normalizes do no less, \
                  here rather more, so the drift itself is not less. That making matrices orthonormal moves \
                  the error elsewhere is not confirmed: the end effector comes closer to where it should be, \
                  and the jumps are of the size of rounding. Kept in order, all representations point the \
                  links equally well, and Gram–Schmidt costs about as much as normalizing a dual quaternion \
                  (see the operation counts). What is true of dual quaternions is that normalizing mends \
                  the translation too: where steps carry the links, these keep their length, and the links \
                  of orthonormal matrices do not. Kenwright's Normalize keeps nothing normalized."
            .to_owned(),
        body,
    })
}

fn charts() -> Result<String, Box<dyn Error>> {
    let (steps, _) = follow(FRAMES, DRAWN, Order::StepState);
    let traces =
        METHODS.map(|method| (method.name, (method.trace)(&steps, Order::StepState, EVERY)));
    let chart = |measure: Measure, title: &str, y: &str| {
        let series = traces.iter().map(|(name, samples)| {
            let points = samples.iter().map(|sample| (sample.frame as f64, sample.error(measure)));
            Series { name: (*name).to_owned(), points: points.collect() }
        });
        Chart {
            title: title.to_owned(),
            x: "frame".to_owned(),
            y: y.to_owned(),
            logarithmic: true,
            series: series.collect(),
        }
        .to_svg()
    };
    Ok(chart(Measure::Skew, "Skew of the worst link", "largest element off the diagonal")?
        + &chart(Measure::Stretch, "Scale of the worst link", "largest element on the diagonal")?
        + &chart(Measure::Position, "Error of the end effector", "links")?
        + &chart(Measure::Link, "Error of the length of the worst link", "relative")?)
}

fn table(caption: &str, samples: &[Sample]) -> String {
    let headings: Vec<_> =
        core::iter::once("representation").chain(Measure::ALL.map(Measure::name)).collect();
    let mut table = Table::new(caption, &headings);
    for (method, sample) in METHODS.iter().zip(samples) {
        let errors = Measure::ALL.map(|measure| scientific(sample.error(measure)));
        table.row(core::iter::once(method.name.to_owned()).chain(errors));
    }
    table.to_html()
}

fn found(
    state_step: &[Sample; METHODS.len()],
    step_state: &[Sample; METHODS.len()],
) -> Vec<String> {
    let [matrix, orthonormal, dual, normalized, kenwright, _, pair] = state_step;
    let skew = |sample: &Sample| scientific(sample.error(Measure::Skew));
    let position = |sample: &Sample| scientific(sample.error(Measure::Position));
    let link = |sample: &Sample| scientific(sample.error(Measure::Link));
    let [_, links_orthonormal, _, links_normalized, ..] = step_state;
    vec![
        format!(
            "Left alone, matrices come to a skew of {}, dual quaternions of {}; the end is off by {} and \
             {} links.",
            skew(matrix),
            skew(dual),
            position(matrix),
            position(dual)
        ),
        format!(
            "Made orthonormal in every frame, matrices have a skew of {} and an end off by {} links; \
             dual quaternions, normalized in every frame, {} and {}; quaternion and vector {} and {}.",
            skew(orthonormal),
            position(orthonormal),
            skew(normalized),
            position(normalized),
            skew(pair),
            position(pair),
        ),
        format!(
            "Gram–Schmidt moves the end by {} links in a frame; normalizing dual quaternions, by {}.",
            scientific(orthonormal.error(Measure::Jump)),
            scientific(normalized.error(Measure::Jump)),
        ),
        format!(
            "Where the step carries the link, links are wrong by {} with orthonormal matrices and by {} \
             with normalized dual quaternions.",
            link(links_orthonormal),
            link(links_normalized),
        ),
        format!("With Kenwright's Normalize the skew is {}.", skew(kenwright)),
    ]
}
