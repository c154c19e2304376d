//! Arends' reading: e and ln of each element.

use crate::keyframe::{
    interpolate, interpolate_elements, matrix, orthonormality_error, smallest_offset,
};
use crate::report::{Chart, Series, Table};
use dq8::{DualQuat, Real, Twist};
use nalgebra::{Matrix4, Point3};
use std::error::Error;

/// What is added to the smallest offset that makes all elements positive.
const MORE: [f64; 3] = [0.0, 1.0, 100.0];

const STEPS: u32 = 40;

/// Table and chart, and the largest element of RᵀR − 1.
pub(super) fn write_up() -> Result<(String, f64), Box<dyn Error>> {
    // A quarter of a circle and more, at a distance of 1 from the axis.
    let [a, b] = [20.0_f64, 140.0].map(|degrees| {
        let turn = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
        matrix(DualQuat::from_twist(turn.scale(degrees.to_radians())))
    });
    let smallest = smallest_offset(&a, &b);
    let name = |more: f64| format!("elements + {:.2}", smallest + more);
    let headings = MORE.map(|more| [format!("{}: RᵀR − 1", name(more)), "off the arc".to_owned()]);
    let headings: Vec<&str> = ["t"]
        .into_iter()
        .chain(headings.as_flattened().iter().map(String::as_str))
        .chain(["Alexa: RᵀR − 1", "off the arc"])
        .collect();
    let mut table =
        Table::new("From a turn of 20° to one of 140°; a point at a distance of 1", &headings);
    let mut series = MORE.map(|more| Series { name: name(more), points: Vec::new() }).to_vec();
    series.push(Series { name: "Alexa".to_owned(), points: Vec::new() });
    let mut worst = 0.0_f64;
    for step in 0..=STEPS {
        let t = f64::from(step) / f64::from(STEPS);
        let arc = Matrix4::new_rotation(nalgebra::Vector3::z() * (20.0 + 120.0 * t).to_radians());
        let mut ways = MORE.map(|more| interpolate_elements(&a, &b, t, smallest + more)).to_vec();
        ways.push(interpolate(&a, &b, t)?);
        let mut cells = vec![t.to_string()];
        for (number, way) in ways.iter().enumerate() {
            let skew = orthonormality_error(way);
            let point = Point3::new(1.0, 0.0, 0.0);
            let off = (way.transform_point(&point) - arc.transform_point(&point)).norm();
            cells.extend([format!("{skew:.3}"), format!("{off:.3}")]);
            series[number].points.push((t, skew));
            if number < MORE.len() {
                worst = worst.max_or_nan(skew);
            }
        }
        if step % (STEPS / 4) == 0 {
            table.row(cells);
        }
    }
    let chart = Chart {
        title: "How far from a rotation, on the way from 20° to 140°".to_owned(),
        x: "t".to_owned(),
        y: "largest element of RᵀR − 1".to_owned(),
        logarithmic: false,
        series,
    };
    Ok((table.to_html() + &chart.to_svg()?, worst))
}
