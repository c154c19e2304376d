//! What Arends says of hyper-dual numbers and quaternions in his chapter 5.

use crate::report::{Section, Table, scientific};
use crate::{HyperDual, HyperDualQuat, hyper_dual, hyper_dual_parts};
use dq8::{DualQuat, Quat, Twist};
use std::error::Error;

type Number = HyperDual<f64>;
type Four = HyperDualQuat<f64>;

/// How many samples each claim is tried with.
const SAMPLES: u32 = 1000;

/// Runs the experiment and writes it up.
///
/// # Errors
/// Never; other experiments can fail.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let claims = claims();
    let mut table = Table::new(
        &format!("Largest errors over {SAMPLES} samples with components from −1 to 1"),
        &["where", "claim", "error", "verdict"],
    );
    for Claim { place, text, error, verdict } in &claims {
        table.row([*place, *text, &scientific(*error), *verdict]);
    }
    let wrong = claims.iter().filter(|claim| claim.error > 1e-6);
    let right = claims.len() - wrong.clone().count();
    let mut found =
        vec![format!("{right} of the {} lines of the table hold up to rounding.", claims.len())];
    found.extend(wrong.map(|claim| {
        format!(
            "{} ({}): off by up to {}. {}",
            claim.text,
            claim.place,
            scientific(claim.error),
            claim.verdict
        )
    }));
    Ok(Section {
        title: "Hyper-dual numbers and quaternions".to_owned(),
        tried: "Hyper-dual numbers as his formulas have them, against dual numbers of dual numbers; \
                quaternions of hyper-dual numbers, written as four quaternions, moving points."
            .to_owned(),
        claimed: [
            "Arends §5.1: sum, product and inverse of hyper-dual numbers.",
            "Arends §5.2 to §5.4: rotation and translation work just as with dual quaternions, by qpq†.",
            "Arends §5.5: hyper-dual quaternions are of use only if the other two quaternions, which are \
             zero here, are used for further transformations.",
            "Arends §5.6: scaling by three factors and shearing is impossible with them all the same.",
            "Arends, conclusion: hyper-dual quaternions add no transformation and cannot be recommended.",
        ]
        .map(str::to_owned)
        .to_vec(),
        found,
        verdict: "The arithmetic is right; he does not say that a = 0 has no inverse. With b = c = 0 the \
                  numbers are dual quaternions over again, ε₁ε₂ for ε, and that is all he uses. The sum \
                  printed for rotation with translation is wrong, his code is right. The dagger is the \
                  conjugate of a product only while b and c are zero, so the other two quaternions cannot \
                  be used with it; with a proper conjugate they can, and still move points by nothing but \
                  |a|² times a rotation and a shift, so his advice stands, for transformations. What the second \
                  unit does buy is derivatives, the purpose for which Fike & Alonso made these numbers: \
                  σ + ε₁σ̇ is a motion with its velocity, and products of such numbers follow the product rule."
            .to_owned(),
        body: table.to_html(),
    })
}

struct Claim {
    place: &'static str,
    text: &'static str,
    error: f64,
    verdict: &'static str,
}

fn claims() -> Vec<Claim> {
    let claim = |place, text, error, verdict| Claim { place, text, error, verdict };
    vec![
        claim(
            "§5.1",
            "products as printed are those of dual numbers of dual numbers",
            largest(printed_product),
            "right",
        ),
        claim(
            "§5.1",
            "the printed inverse times the number is 1",
            largest(printed_inverse),
            "right where a is not 0",
        ),
        claim(
            "§5.2",
            "(xy)† = y†x†, b = c = 0",
            largest(|s| dagger(s.motion(), s.other_motion())),
            "right",
        ),
        claim(
            "§5.2",
            "(xy)† = y†x†, all four used",
            largest(|s| dagger(s.four(), s.other_four())),
            "wrong: −ε₁ times −ε₂ is not −ε₁ε₂",
        ),
        claim(
            "§5.2",
            "the same with ε₁ → −ε₁ alone",
            largest(|s| {
                let (x, y) = (s.four(), s.other_four());
                four_distance((x * y).conjugate_first(), y.conjugate_first() * x.conjugate_first())
            }),
            "what to use instead",
        ),
        claim(
            "§5.3",
            "rotation",
            largest(|s| moved(s, Four::from_rotation(s.rotation()), [0.0; 3])),
            "right",
        ),
        claim(
            "§5.4",
            "rotation and translation, the sum as printed",
            largest(|s| {
                let half = Quat::from_parts(s.vector(4).map(|c| c / 2.0), 0.0);
                let printed = Four { mixed: half, ..Four::from_rotation(s.rotation()) };
                moved(s, printed, s.vector(4))
            }),
            "wrong: shifts by cos(θ/2) t + sin(θ/2) n × t",
        ),
        claim(
            "§5.4",
            "rotation and translation, his code",
            largest(|s| moved(s, s.motion(), s.vector(4))),
            "right",
        ),
        claim(
            "§5.6",
            "points move by v ↦ |a|²Rv + constant, all four used",
            largest(linear_part),
            "right",
        ),
        claim(
            "dq8",
            "σ + ε₁σ̇ follows the product rule",
            largest(product_rule),
            "what it is good for",
        ),
    ]
}

/// Sixteen numbers from −1 to 1.
#[derive(Clone, Copy)]
struct Sample([f64; 16]);

impl Sample {
    /// Weyl's sequence with the roots of primes: evenly spread, and the same in every run.
    fn new(number: u32) -> Self {
        let primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53].map(f64::from);
        Self(primes.map(|prime| 2.0 * (f64::from(number) * prime.sqrt()).fract() - 1.0))
    }

    /// With a real part of size ½ to 1½.
    fn number(&self, from: usize) -> Number {
        let [a, b, c, d] = core::array::from_fn(|i| self.0[from + i]);
        hyper_dual(a.signum() * (0.5 + a.abs()), b, c, d)
    }

    fn quat(&self, from: usize) -> Quat<f64> {
        Quat::from_array(core::array::from_fn(|i| self.0[(from + i) % 16]))
    }

    fn vector(&self, from: usize) -> [f64; 3] {
        self.quat(from).xyz()
    }

    fn rotation(&self) -> Quat<f64> {
        self.quat(0).normalize()
    }

    fn four(&self) -> Four {
        Four::new(self.quat(0), self.quat(4), self.quat(8), self.quat(12))
    }

    fn other_four(&self) -> Four {
        Four::new(self.quat(6), self.quat(10), self.quat(14), self.quat(2))
    }

    fn motion(&self) -> Four {
        Four::from_rotation_translation(self.rotation(), self.vector(4))
    }

    fn other_motion(&self) -> Four {
        Four::from_rotation_translation(self.quat(8).normalize(), self.vector(12))
    }
}

fn largest(error: impl Fn(&Sample) -> f64) -> f64 {
    // NaN must not be lost, as `f64::max` would.
    (1..=SAMPLES).map(|number| error(&Sample::new(number))).fold(0.0, dq8::Real::max_or_nan)
}

fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, dq8::Real::max_or_nan)
}

fn four_distance(x: Four, y: Four) -> f64 {
    let difference = x - y;
    [difference.real, difference.first, difference.second, difference.mixed]
        .map(Quat::norm)
        .into_iter()
        .fold(0.0, dq8::Real::max_or_nan)
}

/// aa′ + (ab′ + ba′)ε₁ + (ac′ + ca′)ε₂ + (ad′ + bc′ + cb′ + da′)ε₁ε₂
fn printed_product(sample: &Sample) -> f64 {
    let (x, y) = (sample.number(0), sample.number(4));
    let ([a, b, c, d], [e, f, g, h]) = (hyper_dual_parts(x), hyper_dual_parts(y));
    let printed = [a * e, a * f + b * e, a * g + c * e, a * h + b * g + c * f + d * e];
    distance(hyper_dual_parts(x * y), printed)
}

fn printed_inverse(sample: &Sample) -> f64 {
    let x = sample.number(0);
    let [a, b, c, d] = hyper_dual_parts(x);
    let squared = a * a;
    let mixed = 2.0 * b * c / (squared * a) - d / squared;
    let printed = hyper_dual(1.0 / a, -b / squared, -c / squared, mixed);
    distance(hyper_dual_parts(x * printed), [1.0, 0.0, 0.0, 0.0])
}

fn dagger(x: Four, y: Four) -> f64 {
    four_distance((x * y).dagger(), y.dagger() * x.dagger())
}

/// How far from turned and then shifted by `translation` a point goes.
fn moved(sample: &Sample, x: Four, translation: [f64; 3]) -> f64 {
    let point = sample.vector(8);
    let sigma = DualQuat::from_rotation_translation(sample.rotation(), translation);
    distance(x.transform_point(point), sigma.transform_point(point))
}

fn linear_part(sample: &Sample) -> f64 {
    let (x, v) = (sample.four(), sample.vector(9));
    let image = |v| (x * Four::point(v) * x.conjugate_first()).mixed.xyz();
    let (origin, moved) = (image([0.0; 3]), image(v));
    let turned = (x.real * Quat::from_parts(v, 0.0) * x.real.conjugate()).xyz();
    distance(moved, core::array::from_fn(|i| origin[i] + turned[i]))
}

fn product_rule(sample: &Sample) -> f64 {
    let dual_quat = |x: Four| DualQuat::new(x.real, x.mixed);
    let twist = |from: usize| {
        let (angular, linear) = (sample.vector(from), sample.vector(from + 5));
        Twist { angular, linear }
    };
    let (a, b) = (dual_quat(sample.motion()), dual_quat(sample.other_motion()));
    let (of_a, of_b) = (a.derivative_spatial(twist(1)), b.derivative_spatial(twist(3)));
    let (_, rate) = (Four::from_moving(a, of_a) * Four::from_moving(b, of_b)).to_moving();
    distance(rate.to_array(), (of_a * b + a * of_b).to_array())
}
