//! What becomes of keys near half a turn.

use crate::keyframe::{interpolate, matrix};
use crate::report::Table;
use dq8::{DualQuat, Twist};

/// Keys 2° apart that come to half a turn and pass it.
const KEYS: [(f64, f64); 5] =
    [(170.0, 172.0), (177.0, 179.0), (178.0, 180.0), (179.0, 181.0), (181.0, 183.0)];

const STEPS: u32 = 100;

/// The table, and the degrees that C turns on its way from 179° to 181°.
pub(super) fn table() -> (String, f64) {
    let mut table = Table::new(
        "Keys about one axis, 2° apart",
        &["from, °", "to, °", "C turns, °", "ScLERP turns, °"],
    );
    let mut longest = 0.0_f64;
    for (from, to) in KEYS {
        let (a, b) = (about_z(from), about_z(to));
        let alexa = way(|t| {
            let middle =
                interpolate(&matrix(a), &matrix(b), t).map_err(|error| error.to_string())?;
            Ok(middle[(1, 0)].atan2(middle[(0, 0)]))
        });
        let sclerp = way(|t| {
            let twice = a.sclerp(b, t).canonical().real();
            Ok(2.0 * twice.z().atan2(twice.w()))
        });
        longest = alexa.iter().copied().fold(longest, f64::max);
        let degrees = |way: Result<f64, String>| way.map_or_else(|e| e, |way| format!("{way:.3}"));
        table.row([from.to_string(), to.to_string(), degrees(alexa), degrees(sclerp)]);
    }
    (table.to_html(), longest)
}

fn about_z(degrees: f64) -> DualQuat<f64> {
    let angular = [0.0, 0.0, degrees.to_radians()];
    DualQuat::from_twist(Twist { angular, linear: [0.0; 3] })
}

/// The sum of the small turns about z on the way, in degrees.
fn way(angle: impl Fn(f64) -> Result<f64, String>) -> Result<f64, String> {
    let mut total = 0.0;
    let mut before = angle(0.0)?;
    for step in 1..=STEPS {
        let now = angle(f64::from(step) / f64::from(STEPS))?;
        let turn = now - before;
        total += turn.sin().atan2(turn.cos()).abs();
        before = now;
    }
    Ok(total.to_degrees())
}
