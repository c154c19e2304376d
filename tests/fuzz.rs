//! Random calls of public functions with anything: no panic, refusals that write nothing, and
//! answers that two ways of computing agree on. `DQ8_FUZZ_SECONDS` says how long (a fifth of one by
//! default), `DQ8_FUZZ_SEED` from where; a failure names the seed of its round.

use dq8::storage::{self, Block};
use dq8::{
    Backend, DualQuat, Hierarchy, Quat, Skeleton, Twist,
    hierarchy::{Poses, RotationsTranslations},
    representation::{Affine, Polar},
};
use dq8_contract::fuzz;
use dq8_contract::random::Random;
use std::cell::Cell;
use std::hint::black_box;

/// Some units of the last place in `f32`.
const IN_SINGLE: f32 = 1e-6;
/// Products of up to as many joints as are drawn, on the scale of their sum.
const MODELS: f32 = 2e-4;

/// Random numbers, and how many functions were called.
struct Fuzz {
    random: Random,
    calls: Cell<u64>,
}

impl Fuzz {
    fn bits(&mut self) -> u64 {
        self.random.bits()
    }
    fn below(&mut self, end: usize) -> usize {
        self.random.below(end)
    }
    fn called(&self, times: u64) {
        self.calls.set(self.calls.get() + times);
    }
    fn signed(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / (1 << 23) as f32 - 1.0
    }
    /// Any bits, numbers at the edges, and ordinary ones.
    fn number(&mut self) -> f32 {
        const EDGES: [f32; 12] = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            f32::INFINITY,
            f32::NEG_INFINITY,
            f32::NAN,
            f32::MAX,
            f32::MIN,
            f32::MIN_POSITIVE,
            1e-45,
            f32::EPSILON,
        ];
        match self.below(4) {
            0 => f32::from_bits(self.bits() as u32),
            1 => EDGES[self.below(EDGES.len())],
            _ => 4.0 * self.signed(),
        }
    }
    fn numbers<const N: usize>(&mut self) -> [f32; N] {
        [(); N].map(|()| self.number())
    }
    /// A rigid motion.
    fn motion(&mut self) -> DualQuat<f32> {
        self.random.motion(3.0).cast()
    }
    fn any(&mut self) -> DualQuat<f32> {
        if self.below(2) == 0 { self.motion() } else { DualQuat::from_array(self.numbers()) }
    }
}

/// Single operations on anything: those that promise more than not to panic, which
/// `differential_fuzz` tries of all in the tables, and those that are in none.
fn operations(fuzz: &mut Fuzz) {
    let (a, v, w) = (fuzz.any(), fuzz.numbers::<3>(), fuzz.numbers::<3>());
    let _ = black_box(a.to_cols_array_2d());
    if let Ok(unit) = a.try_normalize() {
        // What is left of q has the rounding of what was taken away from it.
        let (a, unit) = (a.cast::<f64>(), unit.cast::<f64>());
        let size = (a.dual().norm() / a.real().norm()).max(1.0);
        let along = unit.real().dot(unit.dual()).abs();
        assert!(
            unit.real().is_unit(IN_SINGLE.into()) && along <= f64::from(IN_SINGLE) * size,
            "{a:?} is normalized to {unit:?}"
        );
    }
    if let Ok(inverse) = a.try_inverse() {
        assert!(inverse.is_finite(), "{a:?} has the inverse {inverse:?}");
    }
    // Of quaternions of any length; those of the table are normalized first.
    let _ = black_box((a.real().to_axis_angle(), a.real().to_scaled_axis(), a.real().to_rpy()));
    let _ = black_box((a.real().log(), Quat::exp(v), a.real().pow(w[0])));
    let others = [fuzz.any(), a];
    let _ = black_box((DualQuat::mean(&others), Quat::mean(&others.map(DualQuat::real))));
    if let Ok(turn) = Quat::look_to(v, w) {
        assert!(turn.is_unit(IN_SINGLE), "{v:?} {w:?} {turn:?}");
    }
    assert_eq!(a.is_finite(), a.to_array().iter().all(|c| c.is_finite()));
    if a.is_finite() {
        assert_eq!(a.to_string().parse(), Ok(a));
    }
    fuzz.called(8);
}

/// Text of a motion with a few characters changed: refused, or numbers that are written and read
/// again as they are.
fn texts(fuzz: &mut Fuzz) {
    let mut text: Vec<char> = fuzz.any().to_string().chars().collect();
    for _ in 0..fuzz.below(4) {
        let any: Vec<char> = "0123456789+-.eEinfNa,;[]() \t\n\u{a0}\u{2212}x".chars().collect();
        let (at, letter) = (fuzz.below(text.len()), any[fuzz.below(any.len())]);
        match fuzz.below(3) {
            0 => text[at] = letter,
            1 => text.insert(at, letter),
            _ => text.truncate(at.max(1)),
        }
    }
    let text = String::from_iter(text);
    if let Ok(motion) = text.parse::<DualQuat<f32>>() {
        let again: DualQuat<f32> = motion.to_string().parse().unwrap();
        let bits = |motion: DualQuat<f32>| {
            motion.to_array().map(|c| if c.is_nan() { u32::MAX } else { c.to_bits() })
        };
        assert_eq!(bits(again), bits(motion), "{text:?}");
    }
    let _ = (text.parse::<Quat<f64>>(), text.parse::<Twist<f32>>());
    fuzz.called(3);
}

/// Matrices of anything, and of motions.
fn matrices(fuzz: &mut Fuzz) {
    let mut rows = fuzz.motion().to_matrix3x4();
    for _ in 0..fuzz.below(4) {
        let (row, column) = (fuzz.below(3), fuzz.below(4));
        rows[row][column] = fuzz.number();
    }
    let tolerance = fuzz.number();
    if let Ok(motion) = DualQuat::try_from_matrix3x4(rows, tolerance) {
        assert!(
            motion.is_finite() && motion.rotation().is_unit(IN_SINGLE),
            "{rows:?} {tolerance} {motion:?}"
        );
    }
    let map = Affine::from_matrix3x4(rows);
    if let Ok((motion, stretch)) = map.try_decompose() {
        assert!(motion.is_finite() && motion.rotation().is_unit(IN_SINGLE), "{rows:?} {motion:?}");
        assert!(stretch.as_flattened().iter().all(|c| c.is_finite()), "{rows:?} {stretch:?}");
    }
    if let Ok(polar) = Polar::try_from_matrix3(map.linear) {
        assert!(polar.rotation.is_unit(IN_SINGLE), "{rows:?} {polar:?}");
    }
    let _ = black_box(dq8::representation::gram_schmidt(map.linear));
    fuzz.called(5);
}

/// A parent array that may be wrong; what it gives is what a plain loop gives.
fn hierarchies(fuzz: &mut Fuzz) {
    let joints = fuzz.below(40);
    let mut parents: Vec<u32> = (0..joints)
        .map(|joint| if fuzz.below(5) == 0 { u32::MAX } else { fuzz.below(joint.max(1)) as u32 })
        .collect();
    if let Some(first) = parents.first_mut() {
        *first = u32::MAX;
    }
    if joints > 0 && fuzz.below(4) == 0 {
        parents[fuzz.below(joints)] =
            [fuzz.below(joints + 2) as u32, fuzz.bits() as u32][fuzz.below(2)];
    }
    let _ = black_box(Skeleton::sorted(&parents));
    fuzz.called(2);
    let Ok(hierarchy) = Hierarchy::new(&parents) else {
        assert!(Skeleton::new(&parents).is_err());
        return;
    };
    let skeleton = Skeleton::new(&parents).expect("the hierarchy has been checked");
    let instances = [1, 1, 2, 9][fuzz.below(4)];
    let count = joints * instances + [0, 0, 0, 1][fuzz.below(4)];
    let locals: Vec<_> = (0..count).map(|_| fuzz.motion()).collect();
    let length = count + [0, 0, 0, 0, 1][fuzz.below(5)];
    let backends: Vec<_> = Backend::available().collect();
    let backend = backends[fuzz.below(backends.len())];
    let root = fuzz.motion();
    let untouched = DualQuat::from_array([7.0; 8]);
    let seven: Vec<[f32; 7]> = locals
        .iter()
        .map(|&l| dq8::representation::RotationTranslation::from(l).to_array())
        .collect();
    let mut all = [vec![untouched; length], vec![untouched; length], vec![untouched; length]];
    let [first, second, third] = &mut all;
    let fits = [
        hierarchy.job().backend(backend).root(root).local_to_model(&locals, first).is_ok(),
        skeleton.job().backend(backend).root(root).locals_to_model(Poses(&locals), second).is_ok(),
        skeleton.job().root(root).locals_to_model(RotationsTranslations(&seven), third).is_ok(),
    ];
    fuzz.called(4);
    let whole = count.is_multiple_of(joints);
    assert_eq!(
        fits,
        [whole && length == count; 3],
        "{joints} joints, {count} locals, {length} models"
    );
    if !fits[0] {
        assert!(all.iter().flatten().all(|model| *model == untouched));
        return;
    }
    let mut wanted = locals.clone();
    for instance in wanted.chunks_mut(joints.max(1)) {
        for joint in 0..instance.len() {
            let above = instance.get(parents[joint] as usize).copied().unwrap_or(root);
            instance[joint] = above * instance[joint];
        }
    }
    for models in all {
        for (model, wanted) in models.into_iter().zip(&wanted) {
            let scale = wanted.dual().norm().max(1.0);
            assert!(model.abs_diff_eq(*wanted, MODELS * scale), "{parents:?}: {model} {wanted}");
        }
    }
}

/// Slices and blocks of any length, aligned to nothing.
fn slices(fuzz: &mut Fuzz) {
    let (count, skip) = (fuzz.below(40), fuzz.below(3));
    let a: Vec<_> = (0..count + skip).map(|_| fuzz.any()).collect();
    let b: Vec<_> = (0..count + skip).map(|_| fuzz.any()).collect();
    let (a, b) = (&a[skip..], &b[skip..]);
    let t = fuzz.number();
    let mut out = vec![DualQuat::IDENTITY; count + skip];
    let out = &mut out[skip..];
    for backend in Backend::available() {
        backend.mul(a, b, out).expect("lengths fit");
        for ((&a, &b), &product) in a.iter().zip(b).zip(out.iter()) {
            let scale = (a.real().norm() + a.dual().norm()) * (b.real().norm() + b.dual().norm());
            if scale < 1e30 && scale > 1e-30 {
                assert!(
                    product.abs_diff_eq(a * b, 1e-5 * scale),
                    "{backend}: {a:?} {b:?} {product:?}"
                );
            }
        }
        backend.sclerp(a, b, t, out).expect("lengths fit");
        backend.nlerp(a, b, t, out).expect("lengths fit");
        backend.inverse(a, out).expect("lengths fit");
        backend.normalize(a, out).expect("lengths fit");
        for (&a, &unit) in a.iter().zip(out.iter()) {
            assert_eq!(a.try_normalize().is_ok(), unit.is_finite(), "{backend}: {a:?} {unit:?}");
        }
        fuzz.called(5);
    }
    let joints = 1 + fuzz.below(5);
    let blocks = (count / joints).div_ceil(8) * joints;
    let mut packed = vec![Block::<f32, 8>::splat([3.0; 8]); blocks];
    let mut back = vec![DualQuat::ZERO; count];
    let fits = count.is_multiple_of(joints);
    assert_eq!(storage::pack(joints, a, &mut packed).is_ok(), fits);
    assert_eq!(storage::unpack(joints, &packed, &mut back).is_ok(), fits);
    let bits = |motion: &DualQuat<f32>| motion.to_array().map(f32::to_bits);
    assert!(!fits || back.iter().map(bits).eq(a.iter().map(bits)));
    fuzz.called(2);
}

#[test]
fn anything_may_be_given_to_public_functions() {
    fuzz::rounds(|seed| {
        let mut fuzz = Fuzz { random: fuzz::random(seed), calls: Cell::new(0) };
        for _ in 0..50 {
            for _ in 0..20 {
                operations(&mut fuzz);
                matrices(&mut fuzz);
                texts(&mut fuzz);
            }
            hierarchies(&mut fuzz);
            slices(&mut fuzz);
        }
        fuzz.calls.get()
    });
}
