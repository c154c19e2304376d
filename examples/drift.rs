//! What rounding does to long products of motions, and what normalizing mends.
//!
//! ```text
//! cargo run --release --example drift
//! ```
//!
//! Chains of random unit motions (angles up to π, translations up to 1) are multiplied in `f32`, with
//! several ways of normalizing, and compared with the product of the same motions in `f64`. Each
//! number is the root mean square over several chains. Translations are compared relative to the
//! distance travelled, as max(1, |t|).

use dq8::{DualQuat, batch};
use dq8_contract::random::Random;

/// Chains per number; enough that its second digit is steady.
const CHAINS: u64 = 16;

/// A way of keeping a product normalized: its name, and what it makes of product number `n`.
struct Method {
    name: &'static str,
    keep: fn(DualQuat<f32>, usize) -> DualQuat<f32>,
}

const METHODS: &[Method] = &[
    Method { name: "never", keep: |product, _| product },
    Method { name: "exact, every product", keep: |product, _| product.normalize() },
    Method { name: "exact, every product, lanes", keep: |product, _| on_lanes(product) },
    Method { name: "exact, every 64", keep: |product, n| every(product, n, 64) },
    Method { name: "exact, every 1024", keep: |product, n| every(product, n, 1024) },
    Method { name: "wrong: real part only, every product", keep: |product, _| real_only(product) },
    Method { name: "wrong: one Newton step, every product", keep: |product, _| newton(product) },
];

fn every(product: DualQuat<f32>, n: usize, k: usize) -> DualQuat<f32> {
    if n.is_multiple_of(k) { product.normalize() } else { product }
}

/// The lanes' own normalization, on the one lane that is needed.
fn on_lanes(product: DualQuat<f32>) -> DualQuat<f32> {
    DualQuat::from_array(batch::DualQuat::from_array(product.to_array()).normalize().to_array())
}

/// Divides by |p| and leaves the part of q along p.
fn real_only(product: DualQuat<f32>) -> DualQuat<f32> {
    product.scale(1.0 / product.real().norm())
}

/// 1/|p| by one step of Newton's method from 1: (3 − |p|²)/2.
fn newton(product: DualQuat<f32>) -> DualQuat<f32> {
    product.scale(0.5 * (3.0 - product.real().dot(product.real())))
}

fn motion(random: &mut Random) -> DualQuat<f32> {
    let motion = DualQuat::from_array([(); 8].map(|()| random.signed())).normalize();
    let t = motion.translation();
    let longest = t.iter().fold(1.0_f64, |longest, c| longest.max(c.abs()));
    let short = DualQuat::from_rotation_translation(motion.rotation(), t.map(|c| c / longest));
    DualQuat::from_array(short.to_array().map(|c| c as f32))
}

/// Squares of the errors of one chain: |p| − 1, p·q / max(1, |t|), rotation (radians), translation
/// (relative).
fn errors(method: &Method, seed: u64, products: usize) -> [f64; 4] {
    let mut random = Random(seed);
    let mut product = DualQuat::<f32>::IDENTITY;
    let mut exact = DualQuat::<f64>::IDENTITY;
    for n in 1..=products {
        let next = motion(&mut random);
        product = (method.keep)(product * next, n);
        // The factors are unit to 2⁻²⁴ only, and the exact product is that of the motions they mean.
        exact = (exact * wide(next).normalize()).normalize();
    }
    let product = wide(product);
    let norm = product.norm();
    let difference = exact.conjugate() * product.normalize();
    let [x, y, z] = difference.real().xyz();
    let rotation = 2.0 * (x * x + y * y + z * z).sqrt().atan2(difference.real().w().abs());
    // As a user reads it, without normalizing first.
    let (t, wanted) = (product.translation(), exact.translation());
    let distance = |a: [f64; 3], b: [f64; 3]| {
        a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
    };
    let size = distance(wanted, [0.0; 3]).max(1.0);
    [norm.real - 1.0, norm.dual / size, rotation, distance(t, wanted) / size].map(|e| e * e)
}

fn wide(motion: DualQuat<f32>) -> DualQuat<f64> {
    DualQuat::from_array(motion.to_array().map(f64::from))
}

fn main() {
    println!(
        "| products | normalized | norm | p·q, relative | rotation, rad | translation, relative |"
    );
    println!("|---|---|---|---|---|---|");
    for products in [1_000, 10_000, 100_000, 1_000_000] {
        for method in METHODS {
            let mut sums = [0.0; 4];
            for seed in 1..=CHAINS {
                for (sum, square) in sums.iter_mut().zip(errors(method, seed, products)) {
                    *sum += square;
                }
            }
            let [norm, along, rotation, translation] = sums.map(|sum| (sum / CHAINS as f64).sqrt());
            let name = method.name;
            println!(
                "| {products} | {name} | {norm:.1e} | {along:.1e} | {rotation:.1e} | {translation:.1e} |"
            );
        }
    }
}
