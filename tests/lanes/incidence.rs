//! Lines, planes and points: the same answers, and a mask where the scalar reference has an error.

use super::{Provable, columns, exact, holds, measure, on_every_level, rounded, row};
use dq8::simd::Float;
use dq8::{Line, Plane, Real, incidence::IncidenceError};
use dq8_contract::inputs::for_all;
use dq8_contract::ledger::{Ledger, line};
use proptest::prelude::*;
use std::cell::RefCell;

/// Three points or directions, a fourth, and a tolerance.
#[derive(Clone, Debug)]
struct Case {
    p: [f64; 3],
    u: [f64; 3],
    q: [f64; 3],
    v: [f64; 3],
    tolerance: f64,
}

/// Numbers in the end, whatever they were: NaN and `true` where there is no answer.
type Answer = ([f64; 12], bool);

/// As many as there are, and zeros.
fn filled<const N: usize>(numbers: [f64; N]) -> [f64; 12] {
    std::array::from_fn(|i| numbers.get(i).copied().unwrap_or(0.0))
}

fn by_the_book<const N: usize>(result: Result<[f64; N], IncidenceError>) -> Answer {
    result.map_or((filled([f64::NAN; N]), true), |numbers| (filled(numbers), false))
}

fn six<R: Real>(line: Line<R>) -> [f64; 6] {
    let ([a, b, c], [d, e, f]) = (exact(line.direction), exact(line.moment));
    [a, b, c, d, e, f]
}

fn four<R: Real>(plane: Plane<R>) -> [f64; 4] {
    let [a, b, c] = exact(plane.normal);
    [a, b, c, plane.offset.into()]
}

const NAMES: [&str; 14] = [
    "Line::from_points",
    "Line::from_planes",
    "Line::try_normalize",
    "Line::is_line",
    "Line::distance_to_point",
    "Line::intersection_with_plane",
    "Line::distance_to_plane",
    "Line::dual_angle",
    "Line::distance_to_line",
    "Line::common_perpendicular",
    "Line::intersection",
    "Plane::from_points",
    "Plane::from_line_point",
    "Plane::try_normalize",
];

/// What the scalar reference says of one case, in the order of the names.
fn scalar<R: Real>(case: &Case) -> [Answer; 14] {
    let [p, u, q, v] = [case.p, case.u, case.q, case.v].map(rounded::<R, 3>);
    let tolerance = R::from_f64(case.tolerance);
    let (a, b) = (Line::from_point_direction(p, u), Line::from_point_direction(q, v));
    let (c, d) = (Plane::from_point_normal(p, u), Plane::from_point_normal(q, v));
    // With a pitch, which is taken out.
    let screw = Line { direction: u, moment: v };
    let one = |number: R| [number.into()];
    [
        by_the_book(Line::from_points(p, q).map(six)),
        by_the_book(Line::from_planes(c, d).map(six)),
        by_the_book(screw.try_normalize().map(six)),
        (filled([f64::from(u8::from(screw.is_line(tolerance)))]), false),
        by_the_book(a.distance_to_point(q).map(one)),
        by_the_book(a.intersection_with_plane(d).map(exact)),
        by_the_book(a.distance_to_plane(d).map(one)),
        by_the_book(a.dual_angle(b).map(|angle| [angle.real.into(), angle.dual.into()])),
        by_the_book(a.distance_to_line(b).map(one)),
        by_the_book(a.common_perpendicular(b).map(|found| {
            let ([d, e, f, g, h, i], [first, second]) = (six(found.axis), found.feet.map(exact));
            let ([j, k, l], [m, n, o]) = (first, second);
            // Two numbers in one, for the length of the row; and whether they are parallel.
            let parallel = f64::from(u8::from(found.parallel));
            [d, e, f, g, h, i, j, k, l, m / 2.0 + n / 2.0, o, parallel]
        })),
        by_the_book(a.intersection(b, tolerance).map(exact)),
        by_the_book(Plane::from_points(p, q, v).map(four)),
        by_the_book(Plane::from_line_point(a, q).map(four)),
        by_the_book(d.try_normalize().map(four)),
    ]
}

/// What lanes say of as many as there are lanes.
fn on_lanes<L: Provable>(cases: &[Case]) -> Vec<[Answer; 14]> {
    let p = columns::<L, _, 3>(cases, |case| case.p);
    let u = columns::<L, _, 3>(cases, |case| case.u);
    let q = columns::<L, _, 3>(cases, |case| case.q);
    let v = columns::<L, _, 3>(cases, |case| case.v);
    let [tolerance] = columns::<L, _, 1>(cases, |case| [case.tolerance]);
    let (a, b) = (Line::from_point_direction(p, u), Line::from_point_direction(q, v));
    let (c, d) = (Plane::from_point_normal(p, u), Plane::from_point_normal(q, v));
    let screw = Line { direction: u, moment: v };

    let points = Line::from_points_checked(p, q);
    let planes = Line::from_planes_checked(c, d);
    let unit = screw.normalize_checked();
    let is_line = screw.is_line_mask(tolerance);
    let to_point = a.distance_to_point_checked(q);
    let crossing = a.intersection_with_plane_checked(d);
    let to_plane = a.distance_to_plane_checked(d);
    let angle = a.dual_angle_checked(b);
    let to_line = a.distance_to_line_checked(b);
    let between = a.common_perpendicular_checked(b);
    let meeting = a.intersection_checked(b, tolerance);
    let three = Plane::from_points_checked(p, q, v);
    let through = Plane::from_line_point_checked(a, q);
    let plane = d.normalize_checked();

    let answer = |index: usize| {
        let six = |line: Line<L>| {
            let (l, m) = (row(line.direction, index), row(line.moment, index));
            [l[0], l[1], l[2], m[0], m[1], m[2]]
        };
        let four = |plane: Plane<L>| {
            let (n, [d]) = (row(plane.normal, index), row([plane.offset], index));
            [n[0], n[1], n[2], d]
        };
        let flag = |mask: L::Mask| holds(mask, index);
        let ([d, e, f, g, h, i], [first, second]) = (six(between.0.axis), between.0.feet);
        let ([j, k, l], [m, n, o]) = (row(first, index), row(second, index));
        let parallel =
            if flag(between.1) { f64::NAN } else { f64::from(u8::from(flag(between.0.parallel))) };
        [
            (filled(six(points.0)), flag(points.1)),
            (filled(six(planes.0)), flag(planes.1)),
            (filled(six(unit.0)), flag(unit.1)),
            (filled([f64::from(u8::from(flag(is_line)))]), false),
            (filled(row([to_point.0], index)), flag(to_point.1)),
            (filled(row(crossing.0, index)), flag(crossing.1)),
            (filled(row([to_plane.0], index)), flag(to_plane.1)),
            (filled(row([angle.0.real, angle.0.dual], index)), flag(angle.1)),
            (filled(row([to_line.0], index)), flag(to_line.1)),
            ([d, e, f, g, h, i, j, k, l, m / 2.0 + n / 2.0, o, parallel], flag(between.1)),
            (filled(row(meeting.0, index)), flag(meeting.1)),
            (filled(four(three.0)), flag(three.1)),
            (filled(four(through.0)), flag(through.1)),
            (filled(four(plane.0)), flag(plane.1)),
        ]
    };
    (0..cases.len()).map(answer).collect()
}

fn length(v: [f64; 3]) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

fn sine(a: [f64; 3], b: [f64; 3]) -> f64 {
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    length(cross) / (length(a) * length(b))
}

/// Cases of every kind in which no threshold is near, and those of the table of
/// [`Line::common_perpendicular`], with small whole numbers.
fn cases() -> Vec<Case> {
    let vector =
        || dq8_contract::inputs::vector().prop_filter("a direction", |v| length(*v) > 0.25);
    let found = RefCell::new(Vec::new());
    for_all(400, &(vector(), vector(), vector(), vector(), -3.0..3.0_f64), |(p, u, q, v, e)| {
        let size = 10.0_f64.powf(e);
        let [p, q] = [p, q].map(|point| point.map(|c| c * size));
        let to_q = [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
        let to_v = [v[0] - p[0], v[1] - p[1], v[2] - p[2]];
        let far =
            [sine(u, v), sine(u, to_q), sine(to_q, to_v), (1.0 - sine(u, v).powi(2)).abs().sqrt()];
        if far.into_iter().all(|sine| sine > 0.05) && length(to_q) > 0.05 * size {
            found.borrow_mut().push(Case { p, u, q, v, tolerance: 1e6 });
        }
    });
    let mut cases = found.into_inner();
    let (x, y, none) = ([1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0; 3]);
    let (p, q) = ([3.0, -1.0, 2.0], [1.0, 4.0, -2.0]);
    // The line x and the plane across it meet too far away to say where, at a finite point.
    let nearly_y = [1e-17, 2.0, 0.0];
    for (u, v) in
        [(x, y), (x, nearly_y), (x, x), (x, [-2.0, 0.0, 0.0]), (x, none), (none, y), (none, none)]
    {
        // Far from the origin and near each other, among them.
        let near = ([0.0, 10.0, 0.0], [0.0, 10.5, 0.0]);
        for (p, q) in [(p, q), (p, p), (p, [5.0, -1.0, 2.0]), (none, none), (none, x), near] {
            for tolerance in [0.0, 1e-3, 100.0] {
                cases.push(Case { p, u, q, v, tolerance });
            }
        }
    }
    cases
}

fn incidences_agree<L: Provable>(ledger: &Ledger) {
    for chunk in cases().chunks(L::LANES) {
        for (case, answers) in chunk.iter().zip(on_lanes::<L>(chunk)) {
            let size = 1.0 + length(case.p) + length(case.q) + length(case.v);
            for ((name, got), wanted) in NAMES.iter().zip(answers).zip(scalar::<L::Real>(case)) {
                assert_eq!(got.1, wanted.1, "{name}: whether it failed, {case:?}");
                measure::<L, 12>(ledger, (name, ""), got.0, wanted.0, size, case);
            }
        }
    }
}

#[test]
fn lines_planes_and_points_on_lanes_are_those_of_the_scalar_reference() {
    #[rustfmt::skip]
    let bounds = [
        line(NAMES[0], &[], 2.5, "two lengths and a cross product"),
        line(NAMES[1], &[], 36.0, "the offsets over the sine of the planes, no less than 1/20"),
        line(NAMES[2], &[], 5.0, "a length and a difference"),
        line(NAMES[3], &[], 0.0, "a truth value"),
        line(NAMES[4], &[], 5.0, "a cross product and a length"),
        line(NAMES[5], &[], 60.0, "the distance over the sine, no less than 1/20"),
        line(NAMES[6], &[], 0.0, "zero, or whole numbers"),
        line(NAMES[7], &[], 8.0, "feet, whose difference is projected"),
        line(NAMES[8], &[], 8.0, "as the dual angle"),
        line(NAMES[9], &[], 82.0, "feet over the square of the sine, no less than 1/400"),
        line(NAMES[10], &[], 41.0, "as the common perpendicular"),
        line(NAMES[11], &[], 3.0, "a normal over the sine of the points"),
        line(NAMES[12], &[], 10.0, "a normal over the distance"),
        line(NAMES[13], &[], 2.5, "a length and two quotients"),
    ];
    Ledger::keep("incidences", &bounds, |ledger| {
        on_every_level!(incidences_agree, ledger);
    });
}

/// Vectors that are zero, subnormal, very large, infinite or not a number, each with each.
fn hard_cases(single: bool) -> Vec<Case> {
    let (tiny, huge) = if single { (1e-44, 2e38) } else { (1e-320, 1e308) };
    let vectors = [
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [0.0, -tiny, 0.0],
        [0.0, 3.0, 4.0],
        [huge, 0.0, 0.0],
        [huge, huge, huge],
        [f64::INFINITY, 0.0, 1.0],
        [0.0, f64::NAN, 1.0],
    ];
    let mut cases = Vec::new();
    for p in vectors {
        for u in vectors {
            for q in vectors {
                for v in vectors {
                    // Any distance will do: those of such lines are noise.
                    cases.push(Case { p, u, q, v, tolerance: f64::INFINITY });
                }
            }
        }
    }
    cases
}

/// Hard cases, and what the scalar reference says of each.
struct Hard {
    cases: Vec<Case>,
    wanted: Vec<[Answer; 14]>,
}

impl Hard {
    fn of<R: Real + Float>() -> Self {
        let cases = hard_cases(<R as Float>::SINGLE);
        let wanted = cases.iter().map(scalar::<R>).collect();
        Self { cases, wanted }
    }
}

fn failures_agree<L: Provable>(single: &Hard, double: &Hard) {
    let hard = if <L::Real as Float>::SINGLE { single } else { double };
    let mut wanted = hard.wanted.iter();
    for chunk in hard.cases.chunks(L::LANES) {
        for ((case, answers), wanted) in chunk.iter().zip(on_lanes::<L>(chunk)).zip(&mut wanted) {
            for ((name, got), wanted) in NAMES.iter().zip(answers).zip(wanted) {
                assert_eq!(got.1, wanted.1, "{name}: whether it failed, {case:?}");
                let (nan, finite) =
                    (got.0.iter().any(|c| c.is_nan()), got.0.iter().all(|c| c.is_finite()));
                assert!(if got.1 { nan } else { finite }, "{name}: {:?} for {case:?}", got.0);
            }
        }
    }
}

#[test]
fn lanes_fail_where_the_scalar_reference_has_an_error_and_are_finite_elsewhere() {
    let (single, double) = (Hard::of::<f32>(), Hard::of::<f64>());
    on_every_level!(failures_agree, &single, &double);
}
