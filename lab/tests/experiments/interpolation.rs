//! Interpolations: what the report says of them.

use dq8::Quat;
use lab::arends::slerp;
use lab::interpolation::{Facts, METHODS, facts, largest_norm, pairs, slerp_cases};

/// The facts of one method for all pairs.
fn of(name: &str) -> Vec<Facts> {
    let method = METHODS.iter().find(|method| method.name == name);
    let method = method.unwrap_or_else(|| panic!("no method {name}"));
    pairs().map(|pair| facts(*method, pair)).to_vec()
}

fn worst(facts: &[Facts], pick: impl Fn(&Facts) -> f64) -> f64 {
    facts.iter().map(pick).fold(0.0, f64::max)
}

#[test]
fn every_way_leads_from_the_first_to_the_second() {
    for method in METHODS {
        for pair in pairs() {
            for (t, end) in [(0.0, pair.from), (1.0, pair.to)] {
                let reached = (method.at)(pair.from, pair.to, t);
                let errors =
                    reached.as_flattened().iter().zip(end.to_matrix3x4().into_iter().flatten());
                for (a, b) in errors {
                    assert!((a - b).abs() < 1e-14, "{}, {}: {reached:?}", method.name, pair.name);
                }
            }
        }
    }
}

#[test]
fn sclerp_is_rigid_and_of_constant_speed_and_keeps_both_frames_and_the_shorter_way() {
    let facts = of("ScLERP");
    for (fact, pair) in facts.iter().zip(pairs()) {
        assert!((fact.speed - 1.0).abs() < 1e-6, "{}: {fact:?}", pair.name);
        assert!(
            fact.turning.is_nan() || (fact.turning - 1.0).abs() < 1e-6,
            "{}: {fact:?}",
            pair.name
        );
        assert!(
            fact.detour.is_nan() || (fact.detour - 1.0).abs() < 1e-6,
            "{}: {fact:?}",
            pair.name
        );
    }
    for pick in
        [|f: &Facts| f.distortion, |f: &Facts| f.left, |f: &Facts| f.right, |f: &Facts| f.sign]
    {
        assert!(worst(&facts, pick) < 2e-14, "{facts:?}");
    }
}

#[test]
fn nlerp_keeps_both_frames_but_not_the_speed_and_is_dlb_of_two() {
    let (nlerp, dlb) = (of("NLERP"), of("DLB"));
    for facts in [&nlerp, &dlb] {
        for pick in
            [|f: &Facts| f.distortion, |f: &Facts| f.left, |f: &Facts| f.right, |f: &Facts| f.sign]
        {
            assert!(worst(facts, pick) < 2e-14, "{facts:?}");
        }
        assert!(worst(facts, |fact| fact.turning) > 1.5, "{facts:?}");
        assert!((worst(facts, |fact| fact.detour) - 1.0).abs() < 1e-6, "{facts:?}");
    }
    for (a, b) in nlerp.iter().zip(&dlb) {
        assert_eq!((a.path, a.speed), (b.path, b.speed));
    }
}

#[test]
fn slerp_and_lerp_keep_the_frame_of_the_world_only() {
    let facts = of("SLERP and LERP");
    assert!(worst(&facts, |fact| fact.left) < 2e-14, "{facts:?}");
    assert!(worst(&facts, |fact| fact.right) > 1.0, "{facts:?}");
    assert!((worst(&facts, |fact| fact.turning) - 1.0).abs() < 1e-6, "{facts:?}");
    assert!(worst(&facts, |fact| fact.speed) > 2.0, "{facts:?}");
}

#[test]
fn lerp_of_matrices_and_of_dual_quaternions_is_not_rigid() {
    for name in ["matrix LERP", "LERP"] {
        let facts = of(name);
        assert!(worst(&facts, |fact| fact.distortion) > 0.5, "{name}: {facts:?}");
        // A translation is none of their troubles.
        assert!(facts[0].distortion < 1e-14, "{name}: {facts:?}");
    }
}

#[test]
fn no_other_way_sees_the_sign() {
    for method in METHODS.iter().filter(|method| method.name != "ScLERP, sign kept") {
        assert!(worst(&of(method.name), |fact| fact.sign) < 1e-14, "{}", method.name);
    }
}

#[test]
fn a_sign_that_is_kept_is_a_detour() {
    let facts = of("ScLERP, sign kept");
    // 150° the one way are 210° the other.
    assert!((facts[3].detour - 210.0 / 150.0).abs() < 1e-9, "{facts:?}");
    // From σ to the −σ of a translation there is no axis.
    assert_eq!(facts[0].sign, f64::INFINITY);
}

#[test]
fn arends_slerp_breaks_where_the_report_says_and_dq8_does_not() {
    let cases = slerp_cases();
    for case in &cases {
        let dq8 = case.dq8();
        assert!((dq8.norm - 1.0).abs() < 2e-7 && dq8.error < 2e-7, "{}: {dq8:?}", case.name);
    }
    let [plain, equal, tested, only_w, opposite, rounded, longer] =
        cases.map(|case| case.printed());
    assert!((plain.norm - 1.0).abs() < 2e-7 && plain.error < 2e-7, "{plain:?}");
    assert!((equal.norm - 2_f32.sqrt()).abs() < 2e-7, "√2, not the 2√2 he prints: {equal:?}");
    assert!((tested.norm - 1.0).abs() < 2e-7 && tested.error < 2e-7, "{tested:?}");
    assert!((only_w.error - core::f32::consts::PI / 3.0).abs() < 1e-6, "{only_w:?}");
    assert!(opposite.norm < 0.1 && opposite.error.is_nan(), "{opposite:?}");
    assert!((rounded.norm - 1.0).abs() > 0.1, "{rounded:?}");
    assert!((longer.error - core::f32::consts::PI).abs() < 1e-6, "{longer:?}");
    assert!(largest_norm() > 1.1, "{}", largest_norm());
}

/// What is nearer than 10⁻⁵ is equal to his code, which then gives the beginning; what is
/// farther apart is not, and with a foreign angle becomes longer by √2.
#[test]
fn arends_if_takes_for_equal_what_differs_by_no_more_than_a_hundred_thousandth() {
    let begin = Quat::from_wxyz([0.0_f64, 1.0, 0.0, 0.0]);
    for axis in 0..3 {
        for (off, equal) in [(0.0, true), (0.9e-5, true), (1.1e-5, false), (1e-3, false)] {
            let mut end = begin.to_array();
            end[axis] += off;
            let his = slerp(begin, Quat::from_array(end), 0.5, core::f64::consts::FRAC_PI_2);
            assert_eq!(his == begin, equal, "{axis}, {off}");
            let norm = if equal { 1.0 } else { 2_f64.sqrt() };
            assert!((his.norm() - norm).abs() < 1e-3, "{axis}, {off}: {}", his.norm());
        }
    }
}
