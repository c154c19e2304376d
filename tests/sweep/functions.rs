//! Functions of one variable on the lanes of every backend, and those of single `f32`, in units of
//! the last place. The guide has the worst of all floats: the bounds are read from it.

use crate::stride;
use crate::worst::WORST;
use dq8::batch::Dual;
use dq8::storage::{self, Element};
use dq8::{Backend, Kernel, Lanes, Level, Real};
use dq8_contract::fusing::PORTABLE_FUSES;
use std::f64::consts::FRAC_PI_2;

/// How many floats a backend gets at once.
const BLOCK: usize = 4096;

/// Of so many blocks, one is computed with the other sign too: rounding to the nearest does not see
/// signs.
const NEGATIVE: u32 = 16;

/// The largest angle that lanes have a sine of.
const FAR: f64 = 65_536.0;

/// 2¹²⁸, the first number beyond those of `f32`.
const BEYOND: f64 = 340_282_366_920_938_463_463_374_607_431_768_211_456.0;

/// What −x does to the function.
#[derive(Clone, Copy, PartialEq)]
enum Parity {
    Even,
    Odd,
    Neither,
}
use Parity::{Even, Neither, Odd};

/// A function of one variable, on lanes.
trait Function {
    fn of<L: Lanes>(x: L) -> L;
}

/// numbers[i] ← f(numbers[i])
struct Each<'s, F, E>(&'s mut [E], F);

impl<F: Function, E: Element<1>> Kernel for Each<'_, F, E> {
    type Output = ();
    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        for tile in storage::tiles::<E, V, 1>(self.0.len()) {
            let Some([x]) = E::load(level, self.0, tile, &storage::identity()) else { return };
            E::store([F::of(x)], self.0, tile);
        }
    }
}

/// One row of the guide's table.
struct Row {
    name: &'static str,
    parity: Parity,
    exact: fn(f64) -> f64,
    /// By each implementation.
    forms: Vec<Form>,
}

type Form = (String, Box<dyn Fn(&mut [f32])>);

fn on_every_backend<F: Function + Copy + 'static>(function: F) -> Vec<Form> {
    let form = move |backend: Backend| -> Form {
        (backend.to_string(), Box::new(move |numbers| backend.run(Each(numbers, function))))
    };
    Backend::available().map(form).collect()
}

fn of_single(function: fn(f32) -> f32) -> Vec<Form> {
    let each = move |numbers: &mut [f32]| numbers.iter_mut().for_each(|x| *x = function(*x));
    vec![("f32".to_owned(), Box::new(each))]
}

/// Rows of functions of [`Dual`]: the value, or what multiplies the dual part.
macro_rules! on_lanes {
    ($($name:literal $parity:ident $function:ident $part:ident $exact:expr;)*) => {
        vec![$({
            #[derive(Clone, Copy)]
            struct Of;
            impl Function for Of {
                #[inline(always)]
                fn of<L: Lanes>(x: L) -> L {
                    Dual::new(x, x.constant(1.0)).$function().$part
                }
            }
            Row { name: $name, parity: $parity, exact: $exact, forms: on_every_backend(Of) }
        }),*]
    };
}

fn near(x: f64) -> f64 {
    if x.abs() <= FAR { x } else { f64::NAN }
}

fn rows() -> Vec<Row> {
    let mut rows = on_lanes! {
        "sin" Odd sin real |x| near(x).sin();
        "cos" Even cos real |x| near(x).cos();
        "tan" Odd tan real |x| near(x).tan();
        "tan, dual part" Even tan dual |x| near(x).cos().powi(-2);
        "asin" Odd asin real f64::asin;
        "asin, dual part" Even asin dual |x| 1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
        "acos" Neither acos real f64::acos;
        "atan" Odd atan real f64::atan;
        // Where the square is infinite, the derivative is below 3·10⁻³⁹.
        "atan, dual part" Even atan dual |x| if x * x < BEYOND { 1.0 / x.mul_add(x, 1.0) } else { 0.0 };
        "exp" Neither exp real f64::exp;
        "ln" Neither ln real f64::ln;
        "sqrt" Neither sqrt real f64::sqrt;
        "sqrt, dual part" Neither sqrt dual |x| 0.5 / x.sqrt();
        "recip" Odd recip real f64::recip;
        "recip, dual part" Even recip dual |x| -x.powi(-2);
    };
    let mut single = |name, parity, exact, function| {
        rows.push(Row { name, parity, exact, forms: of_single(function) });
    };
    single("sin, single", Odd, f64::sin, Real::sin);
    single("cos, single", Even, f64::cos, Real::cos);
    single("tan, single", Odd, f64::tan, Real::tan);
    single("asin, single", Odd, f64::asin, Real::asin);
    single("acos, single", Neither, f64::acos, Real::acos);
    single("atan, single", Odd, f64::atan, Real::atan);
    single("exp, single", Neither, f64::exp, Real::exp);
    single("ln, single", Neither, f64::ln, Real::ln);
    rows
}

/// The error in units of the last place of the exact value. What rounds to an infinity is 2¹²⁸.
fn places(got: f32, exact: f64) -> f64 {
    if exact.is_nan() || got.is_nan() {
        return if exact.is_nan() && got.is_nan() { 0.0 } else { f64::INFINITY };
    }
    let exact = exact.clamp(-BEYOND, BEYOND);
    let got = f64::from(got).clamp(-BEYOND, BEYOND);
    // The exponent of the exact value, at least that of the smallest normal number.
    let exponent = ((exact.abs().to_bits() >> 52) as i64 - 1023).clamp(-126, 127);
    (got - exact).abs() * f64::from_bits(((23 - exponent) + 1023) as u64 * (1 << 52))
}

/// The bound of a row, from the guide.
fn bound(name: &str) -> f64 {
    let guide = include_str!("../../src/guide/accuracy.md");
    let begin = format!("| {name} | ");
    let row = guide.lines().find_map(|line| line.strip_prefix(&begin));
    let cell = row.and_then(|row| row.split(' ').next()).unwrap_or_else(|| panic!("no row {name}"));
    cell.parse().unwrap_or_else(|_| panic!("{name}: {cell} is no number"))
}

/// The worst float of each form.
fn sweep(row: &Row) -> Vec<(f64, f32)> {
    let forms = &row.forms;
    let mut worst = vec![(0.0, 0.0); forms.len()];
    // Those with a sign bit come last.
    let last = if row.parity == Neither { u32::MAX } else { i32::MAX.cast_unsigned() };
    let mut all = (0..=last).step_by(stride() as usize).map(f32::from_bits).filter(|x| !x.is_nan());
    let (mut numbers, mut exact) = (Vec::new(), Vec::new());
    let (mut values, mut negative) = (Vec::new(), Vec::new());
    for block in 0.. {
        numbers.clear();
        numbers.extend(all.by_ref().take(BLOCK));
        if numbers.is_empty() {
            break;
        }
        exact.clear();
        exact.extend(numbers.iter().map(|&x| (row.exact)(f64::from(x))));
        for ((_, form), worst) in forms.iter().zip(&mut worst) {
            values.clone_from(&numbers);
            form(&mut values);
            for ((&x, &value), &exact) in numbers.iter().zip(&values).zip(&exact) {
                let places = places(value, exact);
                if places > worst.0 {
                    *worst = (places, x);
                }
            }
            if row.parity != Neither && block % NEGATIVE == 0 {
                negative.clear();
                negative.extend(numbers.iter().map(|x| -x));
                form(&mut negative);
                for ((x, value), &negative) in numbers.iter().zip(&values).zip(&negative) {
                    let same = if row.parity == Odd { -negative } else { negative };
                    assert!(same == *value || value.is_nan(), "{} of ±{x:e}", row.name);
                }
            }
        }
    }
    worst
}

#[test]
fn no_float_is_farther_off_than_the_guide_says() {
    for row in rows() {
        for ((form, _), (places, x)) in row.forms.iter().zip(sweep(&row)) {
            println!("{:12} {form:9} {places:6.3} of {}", row.name, bound(row.name));
            assert!(places <= bound(row.name), "{} {form}: {places} at {x:e}", row.name);
        }
    }
}

/// Known answers of 60 digits at the worst floats there are.
#[test]
fn the_worst_floats_are_as_far_off_as_the_guide_says() {
    // On both kinds of lanes: those that fuse, and those that do not.
    let both = cfg!(target_arch = "x86_64") && !PORTABLE_FUSES;
    for row in rows() {
        let mut worst = 0.0_f64;
        for &(_, bits, exact) in WORST.iter().filter(|(name, ..)| *name == row.name) {
            let x = f32::from_bits(bits);
            for (form, each) in &row.forms {
                let mut value = [x];
                each(&mut value);
                let places = places(value[0], exact);
                assert!(places <= bound(row.name), "{} {form}: {places} at {x:e}", row.name);
                worst = worst.max(places);
            }
        }
        // Rounded up to a hundredth.
        let is_tight = worst > bound(row.name) - 0.0101;
        assert!(is_tight || !both || Backend::avx2().is_none(), "{}: {worst}", row.name);
    }
}

/// In `f64` too, near multiples of a quarter turn, of which there are too many to try.
#[test]
fn sine_and_cosine_keep_their_digits_where_they_vanish() {
    let check = |x: f64| {
        let dual = Dual::new(x, 1.0);
        let [sin, cos] = [dual.sin().real, dual.cos().real];
        for (got, exact) in [(sin, x.sin()), (cos, x.cos())] {
            let off = (got - exact).abs() / exact.abs() / f64::EPSILON;
            assert!(off < 2.0, "{x:e}: {got:e} and {exact:e} are {off:e} ε apart");
        }
    };
    // So far k times the parts of π/2 is exact.
    for k in (1..1 << 26).step_by(stride() as usize).chain(1..1000) {
        check(f64::from(k) * FRAC_PI_2);
    }
}
