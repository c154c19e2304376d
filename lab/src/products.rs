//! Long products: what rounding does to a motion that many are multiplied onto, and what
//! normalizing mends (Kenwright §8 and §12, Fabisch on mistakes).

use crate::report::{Section, Table, paragraph, scientific};
use dq8::{DualQuat, batch};
use dq8_fixtures::random::Random;

/// Chains per number; enough that its second digit is steady.
pub const CHAINS: u64 = 16;

/// After how many products errors are looked at. A million take a quarter of a minute, and without
/// optimisation minutes.
pub const LENGTHS: &[usize] =
    if cfg!(debug_assertions) { &[1_000, 10_000] } else { &[1_000, 10_000, 100_000, 1_000_000] };

/// A way of keeping a product normalized.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// How often, and by what.
    pub name: &'static str,
    /// What it makes of product number `n`.
    keep: fn(DualQuat<f32>, usize) -> DualQuat<f32>,
}

/// In the order of the tables.
pub const METHODS: [Method; 7] = [
    Method { name: "never", keep: |product, _| product },
    Method { name: "exact, every product", keep: |product, _| product.normalize() },
    Method { name: "exact, every product, lanes", keep: |product, _| on_lanes(product) },
    Method { name: "exact, every 64", keep: |product, n| every(product, n, 64) },
    Method { name: "exact, every 1024", keep: |product, n| every(product, n, 1024) },
    Method { name: "wrong: real part only, every product", keep: |product, _| real_only(product) },
    Method { name: "wrong: one Newton step, every product", keep: |product, _| newton(product) },
];

/// Of |p| − 1, of p·q relative to the distance, of the rotation in radians, and of the
/// translation relative to the distance, which is max(1, |t|).
pub type Errors = [f64; 4];

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

/// Any turn, and a translation of at most 1.
fn motion(random: &mut Random) -> DualQuat<f32> {
    let motion = DualQuat::from_array(random.vector()).normalize();
    let t = motion.translation();
    let longest = t.iter().fold(1.0_f64, |longest, c| longest.max(c.abs()));
    let short = DualQuat::from_rotation_translation(motion.rotation(), t.map(|c| c / longest));
    short.cast()
}

fn squares(product: DualQuat<f32>, exact: DualQuat<f64>) -> Errors {
    let product = product.cast::<f64>();
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

/// Root mean squares over the chains, by length and method. All methods multiply the same motions.
pub fn errors(lengths: &[usize]) -> Vec<[Errors; METHODS.len()]> {
    let mut sums = vec![[[0.0; 4]; METHODS.len()]; lengths.len()];
    for seed in 1..=CHAINS {
        let mut random = Random(seed);
        let mut products = [DualQuat::<f32>::IDENTITY; METHODS.len()];
        let mut exact = DualQuat::<f64>::IDENTITY;
        for n in 1..=lengths.iter().copied().max().unwrap_or(0) {
            let next = motion(&mut random);
            for (product, method) in products.iter_mut().zip(METHODS) {
                *product = (method.keep)(*product * next, n);
            }
            // The factors are unit to 2⁻²⁴ only, and the exact product is that of the motions
            // they mean.
            exact = (exact * next.cast().normalize()).normalize();
            if let Some(row) = lengths.iter().position(|&length| length == n) {
                for (sums, product) in sums[row].iter_mut().zip(products) {
                    let squares = squares(product, exact);
                    sums.iter_mut().zip(squares).for_each(|(sum, square)| *sum += square);
                }
            }
        }
    }
    sums.into_iter().map(|row| row.map(|s| s.map(|sum| (sum / CHAINS as f64).sqrt()))).collect()
}

/// Runs the experiment and writes it up.
///
/// # Errors
/// None; other experiments draw charts.
pub fn section() -> Result<Section, Box<dyn std::error::Error>> {
    let all = errors(LENGTHS);
    let headings = ["normalized", "norm", "p·q", "rotation, rad", "translation"];
    let mut body = paragraph(
        "Root mean squares. p·q and the translation are relative to the distance travelled, max(1, |t|).",
    );
    for (length, row) in LENGTHS.iter().zip(&all) {
        let mut table = Table::new(&format!("After {length} products"), &headings);
        for (method, errors) in METHODS.iter().zip(row) {
            let name = method.name.to_owned();
            table.row(core::iter::once(name).chain(errors.map(scientific)));
        }
        body += &table.to_html();
    }
    let last = all[all.len() - 1];
    let [never, exact, _, _, _, real_only, newton] = last;
    let longest = LENGTHS[LENGTHS.len() - 1];
    Ok(Section {
        title: "Long products and normalizing",
        tried: format!(
            "Random unit motions (turns up to π, translations up to 1) are multiplied in single precision, \
             {longest} in a chain, with several ways of normalizing, and compared with the product of the \
             same motions in double precision; {CHAINS} chains."
        ),
        claimed: vec![
            "Kenwright §8: long chains have to be normalized now and then.",
            "Fabisch, Mistakes: an approximation of the norm is good enough for most use cases.",
        ],
        found: vec![
            format!(
                "Never normalized, the norm is off by {} after {longest} products, the rotation by {} and \
                 the translation by {}.",
                scientific(never[0]),
                scientific(never[2]),
                scientific(never[3]),
            ),
            format!(
                "Normalized at every product, the norm is off by {}, the rotation by {} and the translation \
                 by {}.",
                scientific(exact[0]),
                scientific(exact[2]),
                scientific(exact[3]),
            ),
            format!(
                "By the real part only p·q grows to {}; with one step of Newton's method the translation is \
                 off by {}.",
                scientific(real_only[1]),
                scientific(newton[3]),
            ),
        ],
        verdict: "Normalizing keeps the norm, as claimed, but does not make the rotation more exact. Scaling \
                  by the real part alone leaves what q has along p, which grows; one step of Newton's method \
                  always errs to the same side, and shortens the way that was travelled.",
        body,
    })
}
