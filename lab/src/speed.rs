//! Times on this machine: products as plain code and on lanes, by the means of the compiler that
//! built this.

use crate::matrix::Matrix;
use crate::report::{Section, Table, paragraph};
use core::hint::black_box;
use dq8::{Backend, DualQuat, Quat};
use dq8_fixtures::random::Random;
use std::error::Error;
use std::time::Instant;

/// Operands that stay in the first cache.
const PRODUCTS: usize = 256;
/// Runs of all operands; the quickest counts.
const RUNS: usize = if cfg!(debug_assertions) { 40 } else { 4000 };

/// Nanoseconds per product, the quickest of all runs over all operands.
fn time<A: Copy, B: Copy, C: Copy>(
    a: &[A],
    b: &[B],
    out: &mut [C],
    work: impl Fn(A, B) -> C,
) -> f64 {
    best(a.len(), || {
        let (a, b) = (black_box(a), black_box(b));
        for ((out, a), b) in out.iter_mut().zip(a).zip(b) {
            *out = work(*a, *b);
        }
        black_box(&*out);
    })
}

fn best(count: usize, mut work: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        work();
        best = best.min(start.elapsed().as_nanos() as f64 / count as f64);
    }
    best
}

/// AB, element by element.
fn four_by_four(a: Matrix<f32, 4, 4>, [p, q, r, s]: Matrix<f32, 4, 4>) -> Matrix<f32, 4, 4> {
    a.map(|[x, y, z, w]| core::array::from_fn(|j| x * p[j] + y * q[j] + z * r[j] + w * s[j]))
}

/// `[AB | At + s]`, the last rows 0 0 0 1 left out.
fn three_by_four(a: Matrix<f32, 3, 4>, [p, q, r]: Matrix<f32, 3, 4>) -> Matrix<f32, 3, 4> {
    a.map(|[x, y, z, shift]| {
        let [i, j, k, l]: [f32; 4] = core::array::from_fn(|j| x * p[j] + y * q[j] + z * r[j]);
        [i, j, k, l + shift]
    })
}

/// The product of quaternions by its definition, without the quicker form that floats have in dq8.
fn quaternion(a: Quat<f32>, b: Quat<f32>) -> Quat<f32> {
    let ([x, y, z, w], [i, j, k, l]) = (a.to_array(), b.to_array());
    Quat::from_xyzw(
        w * i + x * l + y * k - z * j,
        w * j - x * k + y * l + z * i,
        w * k + x * j - y * i + z * l,
        w * l - x * i - y * j - z * k,
    )
}

/// (pp′, pq′ + qp′)
fn dual([p, q]: [Quat<f32>; 2], [s, t]: [Quat<f32>; 2]) -> [Quat<f32>; 2] {
    [quaternion(p, s), quaternion(p, t) + quaternion(q, s)]
}

/// aa′ + (ab′ + ba′)ε₁ + (ac′ + ca′)ε₂ + (ad′ + bc′ + cb′ + da′)ε₁ε₂
fn hyper([a, b, c, d]: [Quat<f32>; 4], [e, f, g, h]: [Quat<f32>; 4]) -> [Quat<f32>; 4] {
    let crossed = quaternion(b, g) + quaternion(c, f);
    [
        quaternion(a, e),
        quaternion(a, f) + quaternion(b, e),
        quaternion(a, g) + quaternion(c, e),
        quaternion(a, h) + crossed + quaternion(d, e),
    ]
}

/// What is timed, and nanoseconds per product.
pub type Timed = (&'static str, f64);

/// Times all products.
pub fn times() -> Vec<Timed> {
    let mut random = Random(1);
    let motions: Vec<DualQuat<f32>> = (0..2 * PRODUCTS)
        .map(|_| DualQuat::<f64>::from_array(random.vector()).normalize().cast())
        .collect();
    let (left, right) = motions.split_at(PRODUCTS);
    let four = |motions: &[DualQuat<f32>]| -> Vec<Matrix<f32, 4, 4>> {
        motions.iter().map(|motion| motion.to_matrix4()).collect()
    };
    let three = |motions: &[DualQuat<f32>]| -> Vec<Matrix<f32, 3, 4>> {
        motions.iter().map(|motion| motion.to_matrix3x4()).collect()
    };
    let parts = |motions: &[DualQuat<f32>]| -> Vec<[Quat<f32>; 2]> {
        motions.iter().map(|motion| [motion.real(), motion.dual()]).collect()
    };
    let four_parts = |motions: &[DualQuat<f32>], zeros: bool| -> Vec<[Quat<f32>; 4]> {
        let make = |motion: &DualQuat<f32>| {
            let (p, q) = (motion.real(), motion.dual());
            let between = if zeros { Quat::ZERO } else { q };
            [p, between, between, q]
        };
        motions.iter().map(make).collect()
    };
    let (wide, narrow, whole) = (four(left), three(left), parts(left));
    let mut products = vec![DualQuat::IDENTITY; PRODUCTS];
    let mut lanes = |backend: Backend| {
        best(PRODUCTS, || {
            let (left, right) = (black_box(left), black_box(right));
            // Of slices of one length, which these are.
            if backend.mul(left, right, &mut products).is_ok() {
                black_box(&products);
            }
        })
    };
    let on_lanes = lanes(Backend::best());
    let (full, zeros) = (four_parts(left, false), four_parts(left, true));
    vec![
        (FOUR, time(&wide, &four(right), &mut wide.clone(), four_by_four)),
        (THREE, time(&narrow, &three(right), &mut narrow.clone(), three_by_four)),
        (DUAL, time(&whole, &parts(right), &mut whole.clone(), dual)),
        (LANES, on_lanes),
        (HYPER, time(&full, &four_parts(right, false), &mut full.clone(), hyper)),
        (ZEROS, time(&zeros, &four_parts(right, true), &mut zeros.clone(), hyper)),
    ]
}

const FOUR: &str = "matrix 4×4, plain";
const THREE: &str = "matrix 3×4, plain";
const DUAL: &str = "dual quaternion, plain";
const LANES: &str = "dual quaternion, lanes of dq8";
const HYPER: &str = "hyper-dual quaternion, plain";
const ZEROS: &str = "hyper-dual quaternion with two zero parts, plain";

/// What the compiler was told beside what Cargo tells it.
const FLAGS: &str = env!("LAB_RUSTFLAGS");

/// Times and writes up.
///
/// # Errors
/// None; other experiments draw charts.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let times = times();
    let of =
        |name: &str| times.iter().find(|(known, _)| *known == name).map_or(f64::NAN, |time| time.1);
    let dual = of(DUAL);
    let mut table = Table::new(
        "Products in single precision, operands in the first cache",
        &["product", "ns", "relative to dual quaternion, plain"],
    );
    for (name, time) in &times {
        table.row([(*name).to_owned(), format!("{time:.2}"), format!("{:.2}", time / dual)]);
    }
    let flags = if FLAGS.is_empty() { "no flags of its own" } else { FLAGS };
    let scalar = FLAGS.contains("no-vectorize-slp") && FLAGS.contains("no-vectorize-loops");
    let simd = if scalar {
        "It may not use SIMD for plain code in this build."
    } else {
        "It may use SIMD for plain code too, and does for matrices: Kenwright's comparison, without SIMD, is \
         RUSTFLAGS=\"-C no-vectorize-slp -C no-vectorize-loops\" before the command above."
    };
    Ok(Section {
        title: "Times of products",
        tried: format!(
            "{PRODUCTS} products each of random motions, over and over; the quickest of {RUNS} runs. Plain code \
             is what the formula says, in Rust, and what the compiler makes of it, which was given: {flags}. {simd} \
             These numbers, unlike all others on this page, are those of this machine and change a little from \
             run to run."
        ),
        claimed: vec![
            "Kenwright §11: dual quaternion products are ten percent faster than those of matrices, without SIMD.",
            "Kenwright §11: SIMD makes both faster (Mehrotra).",
            "Arends §6: hyper-dual quaternions look no slower, perhaps as 0 times 0 costs the processor little.",
        ],
        found: vec![
            format!(
                "Plain dual quaternion products take {dual:.2} ns, 4×4 matrices {:.2} ns ({:.2} times as long), \
                 3×4 matrices {:.2} ns ({:.2} times as long).",
                of(FOUR),
                of(FOUR) / dual,
                of(THREE),
                of(THREE) / dual
            ),
            format!(
                "On lanes a dual quaternion product takes {:.2} ns, {:.1} times as fast as plain.",
                of(LANES),
                dual / of(LANES)
            ),
            format!(
                "A hyper-dual product takes {:.2} ns, with two of its four quaternions zero {:.2} ns.",
                of(HYPER),
                of(ZEROS)
            ),
        ],
        verdict: "Kenwright's ten percent are those of one machine and one compiler, against full 4×4 matrices; \
                  the table has this one's. A 3×4 product takes fewer operations than either (see the counts), \
                  and is what transforms need. SIMD makes more of a difference than the representation, and is \
                  why there is dq8. A zero costs a processor as much as another number: hyper-dual quaternions \
                  are slower, by what their nine products take, and a screen does not show it.",
        body: paragraph("Nanoseconds per product; one thread.") + &table.to_html(),
    })
}
