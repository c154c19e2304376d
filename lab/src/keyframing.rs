//! Keyframes after Alexa: what his operators do, where they end, and what becomes of them element
//! by element.

mod elements;
mod half_turn;
mod pair;

use crate::LogarithmError;
use crate::keyframe::{add, interpolate, matrix};
use crate::report::{Section, Table, paragraph, scientific};
use dq8::{DualQuat, Twist};
use nalgebra::{Matrix4, Vector3};
use pair::{Facts, Pair};
use std::error::Error;

/// Runs the experiment and writes it up.
///
/// # Errors
/// If a key has no logarithm that must have one, or a chart cannot be drawn.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let facts = Pair::ALL.map(|pair| (pair, pair.facts()));
    let mut rows = Vec::new();
    for (pair, facts) in facts {
        rows.push((pair, facts?));
    }
    let (elements, worst_element) = elements::write_up()?;
    let (half_turns, detour) = half_turn::table();
    let body = pairs(&rows)
        + &pair::chart()?
        + &half_turns
        + &affine()?
        + &paragraph(
            "Element by element, numbers must be positive, so Arends adds something to all elements \
             before and takes it away after; how much, he leaves open. Three amounts:",
        )
        + &elements;
    Ok(Section {
        title: "Keyframes after Alexa",
        tried: "s ⊙ A = exp(s log A), A ⊕ B = exp(log A + log B) and C(t) = ((1 − t) ⊙ A) ⊕ (t ⊙ B), with \
                the exponential and the logarithm of matrices, compared with ScLERP; and with those of each \
                element."
            .to_owned(),
        claimed: vec![
            "Arends §2.4 (after Alexa 2002): C(½) lies exactly on the arc between A and B.",
            "Arends §2.4: e and ln are taken of each element; elements must be positive, else translate \
             A and B and the result back.",
            "Arends §2.6, conclusion: logarithms are not defined for all numbers and make trouble.",
        ],
        found: found(&rows, worst_element, detour)?,
        verdict: "With matrix functions the operators do what Alexa says: s ⊙ A is the power of the screw, \
                  ⊕ commutes, rigid keys give rigid motions, and scale and shear are interpolated too, \
                  which no dual quaternion can. Between motions on one screw, or from no motion, C(t) is \
                  ScLERP. Between others it is not: it takes a longer way at a changing speed, and which \
                  way depends on what pose counts as no motion; it does not depend on how the axes of the \
                  fixed frame lie. Half a turn is where the logarithm ends: a key there has none, and keys \
                  on both sides go the long way round, however near each other. ScLERP asks only for the \
                  turn from key to key. Element by element it is no interpolation of rotations at all, and \
                  the result depends on a number that nobody gives. His complaint about logarithms is \
                  about those of elements.",
        body,
    })
}

fn pairs(rows: &[(Pair, Facts)]) -> String {
    let mut table = Table::new(
        "C(t) against ScLERP; largest differences of matrix elements on the way",
        &[
            "keys",
            "A ⊕ B from AB",
            "C from ScLERP",
            "way of C over way of ScLERP",
            "slowest over fastest turning of C",
            "of ScLERP",
            "other axes, GAG⁻¹",
            "other pose for no motion, GA",
            "RᵀR − 1",
        ],
    );
    for (pair, facts) in rows {
        table.row([
            pair.name().to_owned(),
            scientific(facts.sum_from_product),
            scientific(facts.from_sclerp),
            format!("{:.4}", facts.detour),
            format!("{:.4}", facts.evenness),
            format!("{:.4}", facts.sclerp_evenness),
            scientific(facts.other_axes),
            scientific(facts.other_rest),
            scientific(facts.orthonormality),
        ]);
    }
    table.to_html()
}

/// Volumes and axes of what is not a rigid motion.
fn affine() -> Result<String, LogarithmError> {
    let a = Matrix4::new_nonuniform_scaling(&Vector3::new(1.0, 4.0, 0.5));
    let turn = Twist { angular: [0.0, 0.0, 1.0], linear: [1.0, 0.0, 0.0] };
    let mut shear = Matrix4::identity();
    shear[(0, 1)] = 1.0;
    let b = matrix(DualQuat::from_twist(turn)) * shear * 2.0_f64.powf(1.0 / 3.0);
    let b = Matrix4::from_fn(|i, j| if i == 3 { Matrix4::identity()[(i, j)] } else { b[(i, j)] });
    let mut table = Table::new(
        "From a scale by 1, 4, ½ to a shear, a turn and a uniform scale: volumes are geometric means",
        &["t", "det C(t)", "det A¹⁻ᵗ det Bᵗ", "shortest axis", "longest axis"],
    );
    for step in 0..=4 {
        let t = f64::from(step) / 4.0;
        let between = interpolate(&a, &b, t)?;
        let volume = a.determinant().powf(1.0 - t) * b.determinant().powf(t);
        let axes = between.fixed_view::<3, 3>(0, 0).singular_values();
        table.row(
            [t, between.determinant(), volume, axes.min(), axes.max()].map(|x| format!("{x:.4}")),
        );
    }
    Ok(table.to_html())
}

fn found(
    rows: &[(Pair, Facts)],
    worst_element: f64,
    detour: f64,
) -> Result<Vec<String>, LogarithmError> {
    let mut lines: Vec<_> = rows
        .iter()
        .map(|(pair, facts)| {
            format!(
                "{}: C differs from ScLERP by {}, turning at {:.1} % of its fastest at the slowest.",
                pair.name(),
                scientific(facts.from_sclerp),
                100.0 * facts.evenness
            )
        })
        .collect();
    let [a, b] = Pair::Crossed.keys().map(matrix);
    let commutes = (add(&a, &b)? - add(&b, &a)?).amax();
    lines.push(format!(
        "A ⊕ B and B ⊕ A differ by {}, AB and BA by {}.",
        scientific(commutes),
        scientific((a * b - b * a).amax())
    ));
    lines.push(format!(
        "Keys 2° apart on both sides of half a turn: C turns {detour:.0}° on the way between them."
    ));
    lines.push(format!(
        "Element by element RᵀR − 1 reaches {worst_element:.2}; after Alexa {}.",
        scientific(rows.iter().fold(0.0, |worst: f64, (_, facts)| worst.max(facts.orthonormality)))
    ));
    Ok(lines)
}
