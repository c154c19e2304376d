//! What copies numbers, flips signs or rounds once: the numbers of the scalar reference.

use super::scene::cases;
use super::{Provable, columns, exact, lane, rounded};
use dq8_contract::on_every_lane_type;

/// The same text for both.
macro_rules! answers {
    ($form:ident, $a:expr, $b:expr) => {{
        use dq8::$form::{Dual, Quat};
        let (a, b) = (Quat::from_array($a), Quat::from_array($b));
        let (x, y) = (Dual::new(a.x(), a.y()), Dual::new(b.x(), b.y()));
        let quats = [
            Quat::from_parts(a.xyz(), a.w()),
            Quat::from_xyzw(a.x(), a.y(), a.z(), a.w()),
            a.conjugate(),
            a.scale(b.w()),
            a + b,
            a - b,
            -a,
        ];
        let duals = [x + y, x - y, -x, x.apply(y.real, y.dual)];
        let duals = duals.map(|dual| [dual.real, dual.dual]);
        [quats.map(Quat::to_array).concat(), duals.concat()].concat()
    }};
}

fn agree<L: Provable>() {
    let quat = |[x, y, z, w, ..]: [f64; 8]| [x, y, z, w];
    for chunk in cases().chunks(L::LANES) {
        let (a, b) = (columns::<L, _, 4>(chunk, |x| quat(x.a)), columns(chunk, |x| quat(x.b)));
        let found = answers!(batch, a, b);
        for (index, case) in chunk.iter().enumerate() {
            let [a, b] = [case.a, case.b].map(|motion| rounded::<L::Real, 4>(quat(motion)));
            for (found, wanted) in found.iter().zip(answers!(scalar, a, b)) {
                assert_eq!([lane(*found, index)], exact([wanted]), "{case:?}");
            }
        }
    }
}

#[test]
fn what_rounds_once_is_what_the_scalar_reference_has() {
    on_every_lane_type!(agree());
}
