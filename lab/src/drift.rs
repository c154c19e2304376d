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

use crate::counted::{Counted, Counts};
use crate::matrix;
use crate::report::{Chart, Section, Series, Table, paragraph, scientific};
use dq8::{DualQuat, Real};
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
    let (step_last, missed) = finals(FRAMES, Order::StateStep);
    let (step_first, _) = finals(FRAMES, Order::StepState);
    let mut body = charts()?;
    body += &paragraph(
        "Skew and scale are the largest elements of AᵀA − 1, beside the diagonal and on it, over the \
         frames of all links as they act on points; norm is |det A − 1|, ||p| − 1|, and for dual \
         quaternions the larger of this and |p·q|; the end is compared with where the same steps lead in \
         double precision. A jump is what upkeep moves the end by in one frame.",
    );
    let each = "the joint turns about itself: state · step";
    body += &table(&format!("After {FRAMES} frames, {each}"), &step_last);
    let each = "the step carries the link: step · state";
    body += &table(&format!("After {FRAMES} frames, {each}"), &step_first);
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
            "Kenwright §10.2: dual quaternions drift from unit length, which renormalising mends; \
             repairing a matrix is much more complicated.",
            "Kenwright §12: the problem and cost of drifting and normalising is less with dual quaternions.",
            "Kenwright §13.1: Normalize, which divides by the square of the norm.",
        ]
        .map(str::to_owned)
        .to_vec(),
        found: found(&step_last, &step_first),
        verdict: "That matrices skew and scale is true, and so do dual quaternions and quaternions that \
                  nobody normalises: here more than matrices, so the drift itself is not less. \
                  That making matrices orthonormal only moves the error elsewhere is false: the end \
                  effector comes closer to where it should be, and the jumps are of the size of \
                  rounding. Once kept in order, all three point the links equally well. What is \
                  true of dual quaternions is that normalising mends the translation too: where steps carry \
                  the links, these keep their length, and the links of orthonormal matrices do not. It \
                  costs no fewer multiplications than Gram–Schmidt, so it is not much less \
                  complicated either. Kenwright's Normalize keeps nothing normalised."
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
    Ok(chart(Measure::Skew, "Skew of the worst link", "largest element beside the diagonal")?
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

fn found(step_last: &[Sample; METHODS.len()], step_first: &[Sample; METHODS.len()]) -> Vec<String> {
    let [matrix, orthonormal, dual, normalised, kenwright, _, pair] = step_last;
    let skew = |sample: &Sample| scientific(sample.error(Measure::Skew));
    let position = |sample: &Sample| scientific(sample.error(Measure::Position));
    let link = |sample: &Sample| scientific(sample.error(Measure::Link));
    let [_, links_orthonormal, _, links_normalised, ..] = step_first;
    let (gram_schmidt, normalize) = upkeep_costs();
    let cost = |counts: Counts| {
        format!(
            "{} multiplications, {} additions, {} divisions and {} roots",
            counts.multiplications, counts.additions, counts.divisions, counts.square_roots
        )
    };
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
             dual quaternions, normalised in every frame, {} and {}; quaternion and vector {} and {}.",
            skew(orthonormal),
            position(orthonormal),
            skew(normalised),
            position(normalised),
            skew(pair),
            position(pair),
        ),
        format!(
            "Gram–Schmidt moves the end by {} links in a frame; normalising dual quaternions, by {}.",
            scientific(orthonormal.error(Measure::Jump)),
            scientific(normalised.error(Measure::Jump)),
        ),
        format!(
            "Where the step carries the link, links are wrong by {} with orthonormal matrices and by {} \
             with normalised dual quaternions.",
            link(links_orthonormal),
            link(links_normalised),
        ),
        format!("With Kenwright's Normalize the skew is {}.", skew(kenwright)),
        format!("Gram–Schmidt takes {}.", cost(gram_schmidt)),
        format!("Exact normalisation of a dual quaternion takes {}.", cost(normalize)),
    ]
}

/// Of Gram–Schmidt and of the exact normalisation of a dual quaternion.
#[must_use]
pub fn upkeep_costs() -> (Counts, Counts) {
    let tilt = matrix::about([0.6, 0.0, 0.8].map(Counted), Counted(0.5));
    let motion =
        DualQuat::from_array([0.5, 0.5, 0.5, 0.5, 0.1, 0.2, 0.3, 0.4].map(Counted::from_f64));
    (Counts::of(|| matrix::gram_schmidt(tilt)), Counts::of(|| motion.normalize()))
}
