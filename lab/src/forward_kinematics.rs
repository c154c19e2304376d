//! First and second derivatives of an arm, exact and by differences over the step.

use crate::Arm;
use crate::hessian::Derivatives;
use crate::report::{Chart, Section, Series, Table, paragraph, scientific};
use dq8::Real;
use std::error::Error;

/// Where the arm stands: nothing is at rest, and nothing aligned.
const VARIABLES: [f64; 6] = [0.3, -0.8, 1.2, 0.5, -0.4, 2.0];

/// Steps in a decade of the chart.
const PER_DECADE: i32 = 4;

type Method = (&'static str, fn(f64) -> Derivatives, u32);

/// What differentiates, and how many poses of the arm a Hessian takes.
const METHODS: [Method; 2] = [
    (
        "hyper-dual numbers",
        |h| Derivatives::by_hyper_dual_numbers(&Arm::example(), VARIABLES, h),
        21,
    ),
    (
        "central differences",
        |h| Derivatives::by_central_differences(&Arm::example(), VARIABLES, h),
        96,
    ),
];

/// Runs the experiment and writes it up.
///
/// # Errors
/// If the chart cannot be drawn.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let screws = Derivatives::by_screws(&Arm::example(), VARIABLES)?;
    let exponents = (-16 * PER_DECADE..=0).map(|n| f64::from(n) / f64::from(PER_DECADE));
    let errors = |(_, by, _): Method| -> Vec<(f64, [f64; 2])> {
        let at = |exponent: f64| (exponent, by(10_f64.powf(exponent)).distances(&screws));
        exponents.clone().map(at).collect()
    };
    let measured = METHODS.map(|method| (method, errors(method)));
    let mut series = Vec::new();
    let mut found = Vec::new();
    let mut table = Table::new(
        "Errors in metres over radians, against the derivatives by screws",
        &[
            "method",
            "derivative",
            "best step",
            "error there",
            "worst error, steps 1 to 10⁻¹⁶",
            "poses",
        ],
    );
    for ((name, _, poses), errors) in &measured {
        for (order, derivative) in ["first", "second"].into_iter().enumerate() {
            let points: Vec<_> = errors.iter().map(|(x, error)| (*x, error[order])).collect();
            let best = points.iter().copied().fold((0.0, f64::INFINITY), |best: (f64, f64), at| {
                if at.1 < best.1 { at } else { best }
            });
            let worst = points.iter().fold(0.0, |worst: f64, at| worst.max_or_nan(at.1));
            let step = scientific(10_f64.powf(best.0));
            let (error, worst) = (scientific(best.1), scientific(worst));
            found.push(format!(
                "{name}, {derivative} derivatives: off by {error} at the best step, by {worst} at the worst."
            ));
            table.row([*name, derivative, &step, &error, &worst, &poses.to_string()]);
            series.push(Series { name: format!("{name}, {derivative}"), points });
        }
    }
    let chart = Chart {
        title: "Errors of derivatives over the step".to_owned(),
        x: "step h, log₁₀; for hyper-dual numbers what stands on ε₁ and ε₂".to_owned(),
        y: "largest error".to_owned(),
        logarithmic: true,
        series,
    };
    Ok(Section {
        title: "Derivatives of forward kinematics",
        tried: "An arm of six joints, one of them a lead screw, as a product of exponentials of joint \
                screws, written once for every number type: all first and second derivatives of the \
                position of its effector, by hyper-dual numbers, by central differences, and by screws \
                (geometric Jacobian and Lie brackets of its columns)."
            .to_owned(),
        claimed: vec![
            "Fike & Alonso (2011, cited by Arends §5.1): first and second derivatives by hyper-dual \
             numbers are exact, whatever the step.",
            "Arends §5.5 uses the numbers for transformations and does not mention derivatives.",
        ],
        found,
        verdict: "Right. Hyper-dual numbers give every second derivative of the arm to rounding, with any \
                  step, and agree with ∂Jᵢ/∂qⱼ = [Jⱼ, Jᵢ]. Differences have the V: the error falls with h² \
                  until rounding, divided by h or h², takes over, and the best step leaves about two \
                  thirds of the digits of first derivatives and half of those of second ones. The screws \
                  are as exact and cheaper, where somebody has worked out the formula; the numbers need \
                  none.",
        body: paragraph(
            "A Hessian by hyper-dual numbers takes one pose for each pair of joints, ε₁ on the one and \
             ε₂ on the other. A product of hyper-dual numbers costs nine of plain ones.",
        ) + &table.to_html()
            + &chart.to_svg()?,
    })
}
