//! Drift (Kenwright §10 and §11): a linked chain follows a target, and every frame multiplies a
//! small step onto the state of every joint.

mod chain;
mod experiment;
mod ideal;
mod representation;
mod target;

pub use chain::{Chain, LINKS, Order, Steps};
pub use experiment::{Findings, METHODS, Measure, Method, ROUNDS, Sample, findings, trace};
pub use ideal::{Deviation, Frames, Loop, Repair, against_ideal};
pub use representation::{
    Homogeneous, Listing, Representation, kenwright_normalize, with_unit_rotation,
};
pub use target::{ARRIVAL, Miss, follow};

use crate::report::{Chart, Section, Series, Table, paragraph, scientific};
use dq8::DualQuat;
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
    let Findings { last: state_step, worst, missed } = findings(FRAMES, Order::StateStep);
    let Findings { last: step_state, .. } = findings(FRAMES, Order::StepState);
    let mut body = charts()?;
    body += &paragraph(&format!(
        "Skew and scale are the largest elements of AᵀA − 1, off the diagonal and on it, over the \
         frames of all links as they act on points; norm is |det A − 1|, ||p| − 1|, and for dual \
         quaternions the larger of this and |p·q|; the end is compared with where the same steps lead in \
         double precision. A jump is what upkeep moves the end by in one frame. A quaternion turns points by \
         v + 2r × (r × v + wv), as dq8 computes it; this takes |p| = 1 for granted, and skews where \
         that is not so. The matrix of Kenwright's listing, w² + x² − y² − z² and so on, only scales, by |p|²: \
         in the row \"Kenwright's matrix\" the same numbers are read by it. The curves are those of a target that goes \
         round in {DRAWN} frames, with steps that carry the links."
    ));
    let each = "the joint turns about itself: state · step";
    body += &table(&format!("After {FRAMES} frames, {each}"), &state_step);
    let each = "the step carries the link: step · state";
    body += &table(&format!("After {FRAMES} frames, {each}"), &step_state);
    body += &table("The worst of all frames and speeds, state · step", &worst);
    let rows = ideal_rows();
    body += &paragraph(
        "Against the ideal chain, as he compares: it takes the same steps exactly. In the open loop the \
         solver looks at the ideal chain, in the closed loop at the drifted one, whose end it then brings to \
         the target all the same. States are repaired between frames, levels while they are concatenated. A \
         jump is how far a joint moves against the ideal one from one frame to the next.",
    );
    body += &ideal_table(&rows);
    Ok(Section {
        title: "Drift: a chain that follows a target",
        tried: format!(
            "A chain of {LINKS} links of length 1 follows a target of six degrees of freedom for {FRAMES} \
             frames. Damped least squares in double precision find the small turn of each joint; this is \
             rounded to single precision and multiplied onto the state of the joint, again and again, in \
             each representation by its own arithmetic. Tables hold root mean squares over targets of \
             {} speeds (a round in {} to {} frames). From frame {ARRIVAL} on, the exact chain misses its target \
             by at most {} links and {} rad. Then the solver looks at the drifting chain itself, and each \
             level of the concatenation is repaired.",
            ROUNDS.len(),
            ROUNDS[0],
            ROUNDS[ROUNDS.len() - 1],
            scientific(missed.position),
            scientific(missed.angle),
        ),
        claimed: vec![
            "Kenwright §10.1: concatenated matrices show skewing and scaling.",
            "Kenwright §10.1: making them orthonormal between updates removes both, but the joints show \
             discontinuities and the end effector is not where it should be.",
            "Kenwright §10.2: dual quaternions drift from unit length, which renormalizing mends; \
             repairing a matrix is much more complicated.",
            "Kenwright §12: the problem and cost of drifting and normalizing is less with dual quaternions.",
            "Kenwright §13.1: Normalize, which divides by the square of the norm.",
        ],
        found: found(&state_step, &step_state, &rows),
        verdict: "That matrices skew and scale is true. Dual quaternions that nobody normalizes scale and lose the \
                  end no less, here rather more; they skew where they are taken for unit, and not by the matrix \
                  of Kenwright's listing. That joints jump where matrices are made orthonormal is not \
                  confirmed in any frame, whether states or levels are repaired, and whether or not the solver \
                  sees the drift: jumps are of the size of rounding. That the end is off the ideal one is \
                  true, by rounding: about twice as far as with normalized dual quaternions, and nearer than \
                  without repair. Gram–Schmidt costs about as much as normalizing a dual quaternion \
                  (see the operation counts). Where steps carry the links, normalizing mends the translation \
                  too: these keep their length, and the links of orthonormal matrices do not: errors of \
                  another form, as he says. Kenwright's Normalize keeps nothing normalized.",
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

/// A row of the comparison with the ideal chain.
type IdealRow = (&'static str, Repair, Loop, Deviation);

/// The frames of one round of the target that the chain is compared on.
const COMPARED: [usize; 2] = [FRAMES, DRAWN];

fn ideal_rows() -> Vec<IdealRow> {
    let mut rows = Vec::new();
    for closed in [Loop::Open, Loop::Closed] {
        for repair in Repair::ALL {
            let order = Order::StepState;
            let upkeep = (repair, Homogeneous::<f32>::gram_schmidt as fn(_) -> _);
            rows.push(("matrix", repair, closed, against_ideal(COMPARED, order, upkeep, closed)));
            let upkeep = (repair, DualQuat::<f32>::normalize as fn(_) -> _);
            let deviation = against_ideal(COMPARED, order, upkeep, closed);
            rows.push(("dual quaternion", repair, closed, deviation));
        }
    }
    rows
}

fn ideal_table(rows: &[IdealRow]) -> String {
    let caption = format!("Against the ideal chain: the worst of {FRAMES} frames, step · state");
    let mut table = Table::new(
        &caption,
        &[
            "representation",
            "solver looks at",
            "repaired",
            "skew",
            "scale",
            "end, links",
            "end, rad",
            "link length",
            "jump, links",
            "misses target, links",
        ],
    );
    for (name, repair, closed, deviation) in rows {
        let looked_at = if *closed == Loop::Open { "ideal chain" } else { "chain itself" };
        let Deviation { skew, stretch, position, angle, link, jump, missed, .. } = *deviation;
        let numbers = [skew, stretch, position, angle, link, jump, missed.position].map(scientific);
        let names = [*name, looked_at, repair.name()].map(str::to_owned);
        table.row(names.into_iter().chain(numbers));
    }
    table.to_html()
}

fn found(
    state_step: &[Sample; METHODS.len()],
    step_state: &[Sample; METHODS.len()],
    ideal: &[IdealRow],
) -> Vec<String> {
    let [matrix, orthonormal, dual, listing, normalized, kenwright, _, pair] = state_step;
    let skew = |sample: &Sample| scientific(sample.error(Measure::Skew));
    let position = |sample: &Sample| scientific(sample.error(Measure::Position));
    let link = |sample: &Sample| scientific(sample.error(Measure::Link));
    let [_, links_orthonormal, _, _, links_normalized, ..] = step_state;
    let mut lines = vec![
        format!(
            "Left alone, matrices come to a skew of {}, dual quaternions of {} by the formula for unit \
             quaternions and of {} by the matrix of Kenwright's listing; the end is off by {} and {} links.",
            skew(matrix),
            skew(dual),
            skew(listing),
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
    ];
    for repaired in [Repair::Levels, Repair::Both] {
        let of = |name: &str, closed: Loop| {
            let row = ideal.iter().find(|row| (row.0, row.1, row.2) == (name, repaired, closed));
            row.map_or((f64::NAN, f64::NAN), |row| (row.3.position, row.3.jump))
        };
        let [matrix, dual] = ["matrix", "dual quaternion"].map(|name| of(name, Loop::Closed));
        lines.push(format!(
            "Closed loop, repaired: {}. Ends are {} (matrices) and {} links (dual quaternions) from those of \
             the ideal chain; no joint jumps by more than {} and {}.",
            repaired.name(),
            scientific(matrix.0),
            scientific(dual.0),
            scientific(matrix.1),
            scientific(dual.1),
        ));
    }
    lines
}
