//! Interpolations of poses compared: paths, speeds, frames, signs, and where Arends' SLERP breaks.

mod measure;
mod method;
mod slerp_case;

pub use measure::{Facts, POINT, Pair, Speed, facts, pairs, speeds};
pub use method::{METHODS, Method};
pub use slerp_case::{Outcome, SlerpCase, largest_norm, slerp_cases};

use crate::report::{Chart, Section, Series, Table, decimal, paragraph};
use std::error::Error;

/// The pair whose speeds are drawn.
const DRAWN: usize = 3;

/// Runs the comparison and writes it up.
///
/// # Errors
/// If a chart cannot be drawn.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let measured: Vec<_> = METHODS
        .iter()
        .map(|method| (method.name, pairs().map(|pair| facts(*method, pair))))
        .collect();
    let body = charts()?
        + &paragraph(
            "Speed ratios are the largest over the smallest speed on the way; 1 is a constant speed. A \
             detour is the angle turned, to b or to −b, over the angle between the poses; 1 is the shortest. The three \
             columns of differences are the largest elements by which the way of changed poses differs \
             from the changed way of the poses: for another frame of the world (ca, cb), another frame \
             of the body (ac, bc), and the other sign of b (∞ where there is no answer).",
        )
        + &properties(&measured)
        + &by_pair("Length of the way of a body point", &measured, |facts| facts.path)
        + &by_pair("Largest over smallest speed of that point", &measured, |facts| facts.speed)
        + &by_pair("Largest over smallest speed of turning", &measured, |facts| facts.turning)
        + &paragraph(
            "SLERP as Arends prints it is told the angle Ω; dq8 finds it, and the shorter way. In single \
             precision.",
        )
        + &cases();
    Ok(Section {
        title: "Interpolations",
        tried: format!(
            "{} ways between {} pairs of poses, in double precision, with a point of the body that is not \
             its origin; and SLERP as Arends prints it, where it breaks.",
            METHODS.len(),
            pairs().len()
        ),
        claimed: vec![
            "Jia §10: ScLERP moves with constant rotation and translation speeds.",
            "Kenwright §4: shortest path interpolation, in a single invariant coordinate frame.",
            "Kenwright §3.5.2: the axes in a matrix cannot be interpolated.",
            "Kenwright §6.2: dual quaternions inherit SLERP.",
            "Tarini, slide 127: LERP with the sign of the shortest path, then re-unit and re-orthogonalise.",
            "Arends §6: SLERP of equal quaternions lengthens them, to 2√2; an if mends it. At Ω = π or 2π \
             objects are suddenly stretched.",
        ],
        found: found(&measured),
        verdict: "Jia is right: ScLERP turns and moves every point of the body at constant speed, and is \
                  the only one here that does so and stays rigid. It and NLERP do not depend on the frame, \
                  neither of the world nor of the body; SLERP with LERP depends on which point of the body \
                  is called its origin. Keyframes after Alexa are rigid, and depend on both frames (see there). \
                  NLERP turns by the same rotations as ScLERP at another speed. \
                  Matrix LERP and LERP without normalizing are not rigid on the way, as Kenwright says of \
                  the first. The shortest path is no gift of dual quaternions: the sign has to be \
                  turned, as Tarini says. Arends' example gives √2, not 2√2; his if mends it, but also takes \
                  rotations for equal that differ in w alone, and at Ω = π what comes out is rounding.",
        body,
    })
}

type Measured = (&'static str, [Facts; 5]);

fn worst(facts: &[Facts], pick: impl Fn(&Facts) -> f64) -> f64 {
    facts.iter().map(pick).fold(0.0, f64::max)
}

fn found(measured: &[Measured]) -> Vec<String> {
    let mut lines: Vec<_> = measured
        .iter()
        .map(|(name, facts)| {
            format!(
                "{name}: speed of a point changes by a factor of up to {}, AᵀA − 1 up to {}, differences in \
                 another frame of the world {}, of the body {}.",
                decimal(worst(facts, |facts| facts.speed)),
                decimal(worst(facts, |facts| facts.distortion)),
                decimal(worst(facts, |facts| facts.left)),
                decimal(worst(facts, |facts| facts.right)),
            )
        })
        .collect();
    lines.extend(slerp_cases().iter().map(|case| {
        let (printed, dq8) = (case.printed(), case.dq8());
        format!(
            "SLERP, {}: as Arends prints it norm {} and wrong by {} rad; in dq8 {} and {}.",
            case.name,
            decimal(printed.norm.into()),
            decimal(printed.error.into()),
            decimal(dq8.norm.into()),
            decimal(dq8.error.into()),
        )
    }));
    lines.push(format!(
        "SLERP as Arends prints it from 1°, 2° … 90° to the same and a whole turn, Ω = π: norms up to {}.",
        decimal(largest_norm().into())
    ));
    lines
}

fn properties(measured: &[Measured]) -> String {
    let mut table = Table::new(
        "The worst of all pairs",
        &["way", "speed", "turning", "detour", "AᵀA − 1", "world frame", "body frame", "sign of b"],
    );
    for (name, facts) in measured {
        let ratios = [
            worst(facts, |facts| facts.speed),
            worst(facts, |facts| facts.turning),
            worst(facts, |facts| facts.detour),
        ];
        let errors = [
            worst(facts, |facts| facts.distortion),
            worst(facts, |facts| facts.left),
            worst(facts, |facts| facts.right),
            worst(facts, |facts| facts.sign),
        ];
        let cells = ratios.map(decimal).into_iter().chain(errors.map(decimal));
        table.row(core::iter::once((*name).to_owned()).chain(cells));
    }
    table.to_html()
}

fn by_pair(caption: &str, measured: &[Measured], pick: impl Fn(&Facts) -> f64) -> String {
    let names = pairs().map(|pair| pair.name);
    let headings: Vec<_> = core::iter::once("way").chain(names).collect();
    let mut table = Table::new(caption, &headings);
    for (name, facts) in measured {
        let cells = facts.iter().map(|facts| decimal(pick(facts)));
        table.row(core::iter::once((*name).to_owned()).chain(cells));
    }
    table.to_html()
}

fn cases() -> String {
    let mut table = Table::new(
        "SLERP where it breaks",
        &["rotations", "norm, printed", "error, printed, rad", "norm, dq8", "error, dq8, rad"],
    );
    for case in slerp_cases() {
        let (printed, dq8) = (case.printed(), case.dq8());
        table.row([
            case.name.to_owned(),
            decimal(printed.norm.into()),
            decimal(printed.error.into()),
            decimal(dq8.norm.into()),
            decimal(dq8.error.into()),
        ]);
    }
    table.to_html()
}

fn charts() -> Result<String, Box<dyn Error>> {
    let pair = pairs()[DRAWN];
    let runs = METHODS.map(|method| (method.name, speeds(method, pair)));
    let chart = |what: &str, y: &str, pick: fn(&Speed) -> f64| {
        let series = runs.iter().map(|(name, speeds)| Series {
            name: (*name).to_owned(),
            points: speeds.iter().map(|speed| (speed.t, pick(speed))).collect(),
        });
        Chart {
            title: format!("{what}: {}", pair.name),
            x: "t".to_owned(),
            y: y.to_owned(),
            logarithmic: false,
            series: series.collect(),
        }
        .to_svg()
    };
    Ok(chart("Speed of a body point", "length per unit of t", |speed| speed.point)?
        + &chart("Speed of turning", "radians per unit of t", |speed| speed.turning)?)
}
