//! Operation counts: the numbers that are facts of algebra, and the number that counts them.

use dq8::{DualQuat, Quat, Real};
use dq8_fixtures::textbook::Textbook;
use lab::operations::{Operation, find, operations};

use lab::{Counted, Counts};

#[test]
fn counts_are_those_of_the_formulas() {
    let list = operations();
    for (name, multiplications, additions) in [
        ("matrix 4×4 product", 64, 48),
        ("matrix 3×4 product", 36, 27),
        ("matrix 4×3 times 3×4", 48, 32),
        ("matrix 4×4 times column", 16, 12),
        ("matrix 3×4, point", 9, 9),
        ("matrix 3×3, vector", 9, 6),
        ("Euler angles applied to a point, by 4×4", 144, 108),
        ("quaternion product", 16, 12),
        ("quaternion, vector by qpq*", 32, 24),
        ("quaternion, vector", 18, 12),
        ("quaternion + vector, product", 34, 27),
        ("dual quaternion product", 48, 40),
        ("dual quaternion product of Kenwright's class", 56, 43),
        ("dual quaternion, conjugate", 0, 0),
        ("dual quaternion normalized, unguarded", 20, 10),
        ("dual quaternion, point by qpq†", 100, 80),
        ("matrix 3×3, Gram–Schmidt", 24, 12),
        ("hyper-dual quaternion product, written out", 144, 128),
        ("hyper-dual quaternion product, Quat<Dual<Dual>>", 144, 128),
        ("SLERP of quaternions, angle given", 10, 5),
    ] {
        let Operation { counts, .. } = find(&list, name).unwrap_or_else(|| panic!("no {name}"));
        assert_eq!(
            (counts.multiplications, counts.additions),
            (multiplications, additions),
            "{name}"
        );
    }
}

/// What a printed count says of a kind: "35 mul, 24 add" of "add" is 24.
fn printed(operation: &Operation, kind: &str) -> Option<u32> {
    let mut parts = operation.printed.split(", ");
    parts.find_map(|part| part.strip_suffix(kind)?.trim().parse().ok())
}

#[test]
fn rows_that_claim_to_agree_do_and_the_others_do_not() {
    for operation in operations().iter().filter(|operation| !operation.printed.is_empty()) {
        let counts = operation.counts;
        let agrees = [
            (printed(operation, "mul"), counts.multiplications),
            (printed(operation, "add"), counts.additions),
            (printed(operation, "trig"), counts.trigonometric),
            (printed(operation, "div"), counts.divisions),
            (printed(operation, "exp"), counts.exponentials),
            (printed(operation, "ln"), counts.logarithms),
        ]
        .into_iter()
        .all(|(printed, measured)| printed.is_none_or(|printed| printed == measured));
        let says_so =
            operation.reason.starts_with("agrees") || operation.reason.starts_with("This has");
        assert_eq!(agrees, says_so, "{}: {}", operation.name, operation.printed);
    }
}

/// Kenwright §§3.5.2 and 10.2: the repair of a matrix against that of a dual quaternion.
#[test]
fn gram_schmidt_costs_about_as_much_as_normalizing_and_one_root_more() {
    let list = operations();
    let counts = |name| find(&list, name).expect("in the list").counts;
    let matrix = counts("matrix 3×3, Gram–Schmidt");
    let dual = counts("dual quaternion normalized, unguarded");
    assert_eq!((matrix.divisions, matrix.square_roots), (2, 2));
    assert_eq!((dual.divisions, dual.square_roots), (1, 1));
    let sum = |counts: Counts| counts.multiplications + counts.additions;
    assert_eq!((sum(matrix), sum(dual)), (36, 30));
}

/// Arends ch. 2 §4: what is to be quicker than Euler angles takes more of what is slow.
#[test]
fn keyframes_by_elements_take_more_transcendental_functions_than_euler_angles() {
    let list = operations();
    let slow = |name| {
        let counts = find(&list, name).expect("in the list").counts;
        counts.trigonometric + counts.exponentials + counts.logarithms
    };
    assert_eq!(slow("keyframes, element by element"), 21);
    assert_eq!(slow("Euler angles applied to a point, by 4×4"), 6);
    assert_eq!(slow("SLERP of quaternions, angle given"), 4);
}

/// What the remarks in the table say of Arends' sums.
#[test]
fn with_negations_as_multiplications_arends_sums_are_found() {
    let list = operations();
    let counts = |name| find(&list, name).expect("in the list").counts;
    let products = |name| counts(name).multiplications + counts(name).negations;
    assert_eq!(products("quaternion, vector by qpq*"), 35);
    assert_eq!(products("dual quaternion, point by qpq†"), 2 * 48 + 10);
    assert_eq!(counts("dual quaternion, point by qpq†").additions, 72 + 8);
    assert_eq!(products("hyper-dual quaternion, point by qpq†"), 312);
    assert_eq!(counts("hyper-dual quaternion, point by qpq†").additions, 216 + 40);
}

#[test]
fn every_operation_of_a_number_counts_once() {
    let (x, y) = (Counted(0.5), Counted(0.25));
    let none = Counts::of(|| ());
    let with = |change: fn(&mut Counts)| {
        let mut counts = none;
        change(&mut counts);
        counts
    };
    let assigned = |operate: fn(&mut Counted)| {
        let mut z = Counted(0.5);
        Counts::of(|| operate(&mut z))
    };
    for counted in [Counts::of(|| x + y), Counts::of(|| x - y), assigned(|z| *z += Counted(1.0))] {
        assert_eq!(counted, with(|counts| counts.additions = 1));
    }
    assert_eq!(assigned(|z| *z -= Counted(1.0)), with(|counts| counts.additions = 1));
    for counted in [Counts::of(|| x * y), assigned(|z| *z *= Counted(1.0))] {
        assert_eq!(counted, with(|counts| counts.multiplications = 1));
    }
    for counted in [Counts::of(|| x / y), assigned(|z| *z /= Counted(1.0))] {
        assert_eq!(counted, with(|counts| counts.divisions = 1));
    }
    assert_eq!(Counts::of(|| -x), with(|counts| counts.negations = 1));
    assert_eq!(Counts::of(|| x.sqrt()), with(|counts| counts.square_roots = 1));
    for function in [Real::sin, Real::cos, Real::tan, Real::asin, Real::acos, Real::atan] {
        assert_eq!(Counts::of(|| function(x)), with(|counts| counts.trigonometric = 1));
    }
    assert_eq!(Counts::of(|| x.atan2(y)), with(|counts| counts.trigonometric = 1));
    assert_eq!(Counts::of(|| x.exp()), with(|counts| counts.exponentials = 1));
    assert_eq!(Counts::of(|| x.ln()), with(|counts| counts.logarithms = 1));
    for counted in [
        Counts::of(|| x < y),
        Counts::of(|| x == y),
        Counts::of(|| x.abs()),
        Counts::of(|| x.is_finite()),
    ] {
        assert_eq!(counted, with(|counts| counts.comparisons = 1));
    }
}

#[test]
fn counting_inside_of_counting_is_apart() {
    let (x, mut inner) = (Counted(2.0), None);
    let outer = Counts::of(|| {
        let sum = x + x;
        inner = Some(Counts::of(|| x * x));
        sum / x
    });
    assert_eq!((outer.additions, outer.multiplications, outer.divisions), (1, 0, 1));
    assert_eq!(inner.map(|counts| (counts.additions, counts.multiplications)), Some((0, 1)));
}

/// Or the branches that are counted would not be those that are taken. Floats themselves have
/// quicker forms, which are not what is counted.
#[test]
fn counted_numbers_compute_what_floats_compute_by_the_book() {
    fn way<R: Real>() -> [f64; 8] {
        let number = R::from_f64;
        let turn = |angle| Quat::from_axis_angle([0.48, 0.6, 0.64].map(number), number(angle));
        let a = DualQuat::from_rotation_translation(turn(0.3), [1.0, 2.0, 3.0].map(number));
        let b = DualQuat::from_rotation_translation(turn(-1.3), [0.5, 0.0, -3.0].map(number));
        let mixed = a.sclerp(b, number(0.3)) * a.nlerp(b, number(0.7)).inverse();
        mixed.normalize().to_array().map(Into::into)
    }
    assert_eq!(way::<Counted>(), way::<Textbook<f64>>());
}
