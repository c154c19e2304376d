//! What the lane types have beside the contract, against the scalar reference of the same precision:
//! records and blocks in memory, quaternions, dual numbers.

use dq8::{
    Lanes, Real, Scalar, batch, scalar,
    simd::{Float, Mask, Portable},
};
use dq8_contract::bound::distance;
use dq8_contract::case::Case;
use dq8_contract::inputs;
use dq8_contract::ledger::{Line, line};
use dq8_contract::on_every_lane_type;
use dq8_contract::sample::{Proof, Sample};
use dq8_simd::{Block, Row};

fn round<R: Scalar>(numbers: [f64; 8]) -> [R; 8] {
    numbers.map(<R as Real>::from_f64)
}

fn lanes<L: Lanes<Level: Proof>>(numbers: &[f64]) -> L {
    <batch::DualQuat<L> as Sample>::real(numbers)
}

#[test]
fn records_fill_the_first_lanes_and_the_others_hold_the_identity() {
    fn check<L: Lanes<Level: Proof, Real: Scalar>>() {
        let name = std::any::type_name::<L>();
        let motions: Vec<_> = inputs::edge_motions().into_iter().map(round::<L::Real>).collect();
        let identity = scalar::DualQuat::<L::Real>::IDENTITY.to_array();
        for length in 0..=2 * L::LANES + 1 {
            let records = &motions[40..40 + length];
            let loaded = batch::DualQuat::<L>::load_records(L::Level::proof(), records).to_array();
            let rows = loaded.map(Lanes::to_array);
            for lane in 0..L::LANES {
                let held: [L::Real; 8] = std::array::from_fn(|c| rows[c].as_ref()[lane]);
                let wanted = *records.get(lane).unwrap_or(&identity);
                assert_eq!(held, wanted, "{name}: lane {lane} of {length} records");
            }
        }
    }
    on_every_lane_type!(check());
}

#[test]
fn records_beyond_the_lanes_are_left_alone() {
    fn check<L: Lanes<Level: Proof, Real: Scalar>>() {
        let name = std::any::type_name::<L>();
        let motions: Vec<_> = inputs::edge_motions().into_iter().map(round::<L::Real>).collect();
        let untouched = round::<L::Real>([9.0; 8]);
        for length in 0..=2 * L::LANES + 1 {
            let mut records = vec![untouched; length];
            batch::DualQuat::<L>::load_records(L::Level::proof(), &motions[40..])
                .store_records(&mut records);
            for (i, record) in records.iter().enumerate() {
                let wanted = if i < L::LANES { motions[40 + i] } else { untouched };
                assert_eq!(*record, wanted, "{name}: record {i} of {length}");
            }
        }
    }
    on_every_lane_type!(check());
}

/// A slice of any length, a chunk of lanes at a time, the last one partial.
#[test]
fn a_slice_gives_the_same_bits_whatever_its_length() {
    fn step<L: Lanes<Level: Proof>>(motion: batch::DualQuat<L>, t: L) -> batch::DualQuat<L> {
        (motion.normalize() * motion).pow(t)
    }
    fn check<L: Lanes<Level: Proof, Real: Scalar>>() {
        let name = std::any::type_name::<L>();
        let motions: Vec<_> = inputs::edge_motions().into_iter().map(round::<L::Real>).collect();
        let t = <L as Lanes>::splat(L::Level::proof(), <L::Real as From<f32>>::from(0.75));
        for length in 0..=2 * L::LANES + 1 {
            let mut records = motions[60..60 + length].to_vec();
            for chunk in records.chunks_mut(L::LANES) {
                step(batch::DualQuat::<L>::load_records(L::Level::proof(), chunk), t)
                    .store_records(chunk);
            }
            for (i, record) in records.iter().enumerate() {
                let mut alone = [round::<L::Real>([9.0; 8])];
                let splat = batch::DualQuat::<L>::splat(L::Level::proof(), motions[60 + i]);
                step(splat, t).store_records(&mut alone);
                assert_eq!(*record, alone[0], "{name}: record {i} of {length}");
            }
        }
    }
    on_every_lane_type!(check());
}

#[test]
fn a_block_gives_back_what_was_stored() {
    fn check<A: Row<Real: Scalar>, V: Proof>() {
        let motions = inputs::edge_motions();
        let mut block = Block::<A, 8>::splat(round([9.0; 8]));
        for lane in 0..A::LANES {
            assert!(block.set(lane, round(motions[40 + lane])).is_ok());
        }
        let level = V::proof();
        let loaded = batch::DualQuat::<A::Lanes<V>>::load(level, &block);
        let mut copy = Block::<A, 8>::splat(round([0.0; 8]));
        (-loaded).store(&mut copy);
        for lane in 0..A::LANES {
            let negated = motions[40 + lane].map(|c| -c);
            assert_eq!(copy.get(lane), Some(round(negated)), "lane {lane} of {}", A::LANES);
        }
    }
    fn every_length<V: Proof>() {
        if V::is_there() {
            check::<[f32; 4], V>();
            check::<[f32; 8], V>();
            check::<[f32; 16], V>();
            check::<[f64; 2], V>();
            check::<[f64; 4], V>();
            check::<[f64; 8], V>();
        }
    }
    every_length::<Portable>();
    #[cfg(target_arch = "x86_64")]
    {
        every_length::<dq8_contract::sample::Avx2>();
        every_length::<dq8_contract::sample::Avx512>();
    }
}

#[test]
fn is_normalized_says_what_scalar_says() {
    fn check<L: Lanes<Level: Proof, Real: Scalar>>() {
        let name = std::any::type_name::<L>();
        let unit = inputs::edge_motions()[60];
        let epsilon: f64 = <L::Real as Real>::EPSILON.into();
        // 32 units of the last place are allowed; rounding blurs that by two or so.
        for off in [0.0, 20.0, -20.0, 28.0, -28.0, 36.0, -36.0, 1e3, f64::NAN] {
            let motion = round::<L::Real>(unit.map(|c| c * (1.0 + off * epsilon)));
            let scalar = scalar::DualQuat::from_array(motion).is_normalized();
            assert_eq!(scalar, off.abs() < 32.0, "scalar, {off} units off");
            let mask = batch::DualQuat::<L>::splat(L::Level::proof(), motion).is_normalized();
            assert_eq!((mask.all(), mask.any()), (scalar, scalar), "{name}, {off} units off");
        }
    }
    on_every_lane_type!(check());
}

/// How far lanes may lie from scalar: about 1.6 times the worst of 60 000 random cases, in units of
/// u · max(1, |the number|).
#[rustfmt::skip]
const INHERENT: &[Line] = &[
    line("Quat::from_parts", &[], 0.0, "copies"),
    line("Quat::from_xyzw", &[], 0.0, "copies"),
    line("Quat::from_axis_angle", &[], 6.0, "sine and cosine are polynomials, where scalar asks the library"),
    line("Quat::conjugate", &[], 0.0, "signs"),
    line("Quat::dot", &[], 4.0, "a fused sum of four products"),
    line("Quat::norm", &[], 7.0, "scalar sums the squares of ratios to the largest component"),
    line("Quat::normalize", &[], 7.0, "another length"),
    line("Quat::scale", &[], 0.0, "one product"),
    line("Quat::rotate", &[], 20.0, "fused products, doubled at another step; |v| is up to 3.5"),
    line("Quat::to_matrix3", &[], 4.0, "fused products, doubled at another step"),
    line("Quat::from_matrix3", &[], 22.0, "another length divides; as a matrix again, to_matrix3 of two quaternions"),
    line("Quat::add", &[], 0.0, "one sum"),
    line("Quat::sub", &[], 0.0, "one difference"),
    line("Quat::mul", &[], 5.0, "fused products, another order of summands"),
    line("Quat::neg", &[], 0.0, "signs"),
    line("Dual::add", &[], 0.0, "one sum"),
    line("Dual::sub", &[], 0.0, "one difference"),
    line("Dual::mul", &[], 3.5, "a fused sum of two products"),
    line("Dual::div", &[], 27.0, "a fused difference that may cancel, divided by no less than 1/16"),
    line("Dual::neg", &[], 0.0, "signs"),
    line("Dual::sqrt", &[], 0.0, "the same quotient of the same root"),
    line("Dual::apply", &[], 0.0, "one product"),
    line("Dual::inverse", &[], 7.0, "the square of a reciprocal, where scalar divides twice"),
];

/// The operations of `Quat` have the same names on scalar and on lanes.
macro_rules! quat_operations {
    ($Quat:ident, $a:expr, $b:expr, $v:expr, $s:expr) => {{
        let (a, b) = ($Quat::from_array($a), $Quat::from_array($b));
        let [x, y, z] = a.xyz();
        vec![
            (
                "Quat::from_parts",
                $Quat::from_parts([a.x(), a.y(), a.z()], a.w()).to_array().to_vec(),
            ),
            ("Quat::from_xyzw", $Quat::from_xyzw(x, y, z, a.w()).to_array().to_vec()),
            ("Quat::from_axis_angle", $Quat::from_axis_angle($v, $s).to_array().to_vec()),
            ("Quat::conjugate", a.conjugate().to_array().to_vec()),
            ("Quat::dot", vec![a.dot(b)]),
            ("Quat::norm", vec![a.norm()]),
            ("Quat::normalize", a.normalize().to_array().to_vec()),
            ("Quat::scale", a.scale($s).to_array().to_vec()),
            ("Quat::rotate", a.rotate($v).to_vec()),
            ("Quat::to_matrix3", a.to_matrix3().concat()),
            // As a matrix again, which does not see the sign.
            ("Quat::from_matrix3", $Quat::from_matrix3(a.to_matrix3()).to_matrix3().concat()),
            ("Quat::add", (a + b).to_array().to_vec()),
            ("Quat::sub", (a - b).to_array().to_vec()),
            ("Quat::mul", (a * b).to_array().to_vec()),
            ("Quat::neg", (-a).to_array().to_vec()),
        ]
    }};
}

/// So do those of `Dual`, but for the reciprocal.
macro_rules! dual_operations {
    ($x:expr, $y:expr, $recip:expr) => {{
        let (x, y) = ($x, $y);
        let pair = |dual: [_; 2]| dual.to_vec();
        vec![
            ("Dual::add", pair([(x + y).real, (x + y).dual])),
            ("Dual::sub", pair([(x - y).real, (x - y).dual])),
            ("Dual::mul", pair([(x * y).real, (x * y).dual])),
            ("Dual::div", pair([(x / y).real, (x / y).dual])),
            ("Dual::neg", pair([(-x).real, (-x).dual])),
            ("Dual::sqrt", pair([x.sqrt().real, x.sqrt().dual])),
            ("Dual::apply", pair([x.apply(y.real, y.dual).real, x.apply(y.real, y.dual).dual])),
            ("Dual::inverse", pair([$recip.real, $recip.dual])),
        ]
    }};
}

type Answers<N> = Vec<(&'static str, Vec<N>)>;

fn on_scalar<R: Scalar>(case: &Case) -> Answers<R> {
    use scalar::{Dual, Quat};
    let real = <R as Real>::from_f64;
    let [ax, ay, az, aw, ..] = case.a.map(real);
    let [bx, by, bz, bw, ..] = case.b.map(real);
    let (s, v) = (real(case.s), case.v.map(real));
    let (x, y) = (Dual::new(real(case.weights[0]), s), Dual::new(real(case.weights[1]), v[0]));
    let quats = quat_operations!(Quat, [ax, ay, az, aw], [bx, by, bz, bw], v, s);
    let recip = x.inverse().expect("weights are not zero");
    [quats, dual_operations!(x, y, recip)].concat()
}

fn on_lanes<L: Lanes<Level: Proof>>(cases: &[Case]) -> Answers<L> {
    use batch::{Dual, Quat};
    let column = |pick: &dyn Fn(&Case) -> f64| {
        lanes::<L>(&(0..L::LANES).map(|i| pick(&cases[i % cases.len()])).collect::<Vec<_>>())
    };
    let a: [L; 4] = std::array::from_fn(|c| column(&|case| case.a[c]));
    let b: [L; 4] = std::array::from_fn(|c| column(&|case| case.b[c]));
    let v: [L; 3] = std::array::from_fn(|c| column(&|case| case.v[c]));
    let s = column(&|case| case.s);
    let x = Dual::new(column(&|case| case.weights[0]), s);
    let y = Dual::new(column(&|case| case.weights[1]), v[0]);
    [quat_operations!(Quat, a, b, v, s), dual_operations!(x, y, x.recip())].concat()
}

#[test]
fn quaternions_and_dual_numbers_agree() {
    fn check<L: Lanes<Level: Proof, Real: Scalar>>() {
        let name = std::any::type_name::<L>();
        for chunk in inputs::unit_cases().chunks(L::LANES) {
            let answers = on_lanes::<L>(chunk);
            for (lane, case) in chunk.iter().enumerate() {
                let scalar = on_scalar::<L::Real>(case);
                let held = answers.iter().zip(scalar).zip(INHERENT);
                for (((operation, got), (_, wanted)), Line { op, bound }) in held {
                    assert_eq!(operation, op, "the table has a line for each operation");
                    for (got, wanted) in got.iter().zip(wanted) {
                        let got: f64 = got.to_array().as_ref()[lane].into();
                        let wanted: f64 = wanted.into();
                        // Sums of a few numbers up to 4, and quotients by numbers above 1/16.
                        let scale = 1.0_f64.max(wanted.abs());
                        let units = distance(got, wanted, scale, L::Real::SINGLE);
                        assert!(
                            units <= bound.units,
                            "{name}: {operation} gives {got:e}, scalar {wanted:e}, {units:.2} units \
                             apart ({}) for {case:?}",
                            bound.reason
                        );
                    }
                }
            }
        }
    }
    on_every_lane_type!(check());
}

#[test]
fn the_table_has_one_line_for_each_inherent_operation() {
    let cases = inputs::unit_cases();
    let names = on_scalar::<f64>(&cases[0]).into_iter().map(|(name, _)| name);
    let lines = INHERENT.iter().map(|line| line.op);
    assert!(names.eq(lines));
}
