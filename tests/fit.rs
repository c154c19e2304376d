//! Maps of points to points with least squares, against singular value decompositions of nalgebra.

use dq8::fit::{Fit, FitError, Maps, PairSets, PointPairs, Quality};
use dq8::{Backend, Dual, DualQuat, Quat, Real, Scalar};
use dq8_contract::random::Random;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;
use std::mem::discriminant;
use std::ops::Range;

type Points<R> = Vec<[R; 3]>;

/// Some dozens of units of roundoff.
const ROUNDING: f64 = 1e-14;

/// Points in a box, thin along z by the factor, and where a motion with a scale brings them, with
/// noise; and weights, some of them zero.
struct Problem {
    points: Points<f64>,
    moved: Points<f64>,
    weights: Vec<f64>,
}

impl Problem {
    fn new(random: &mut Random, thin: f64, scale: f64, noise: f64) -> Self {
        let count = 4 + random.below(20);
        let motion = random.motion(10.0);
        let tilt = random.motion(10.0);
        let flat = |[x, y, z]: [f64; 3]| tilt.transform_point([x, y, thin * z]);
        let points: Points<f64> = (0..count).map(|_| flat(random.vector())).collect();
        let move_one = |p: &[f64; 3]| {
            let shaken = random.vector::<3>().map(|c| noise * c);
            let moved = motion.transform_point(p.map(|c| scale * c));
            std::array::from_fn(|i| moved[i] + shaken[i])
        };
        let moved = points.iter().map(move_one).collect();
        let weigh = |i| if i % 5 == 4 { 0.0 } else { random.between(0.1, 10.0) };
        Self { points, moved, weights: (0..count).map(weigh).collect() }
    }

    fn mirrored(mut self) -> Self {
        self.moved = self.moved.into_iter().map(|[x, y, z]| [-x, y, z]).collect();
        self
    }
}

fn round<R: Real>(points: &[[f64; 3]]) -> Points<R> {
    points.iter().map(|p| p.map(R::from_f64)).collect()
}

fn vector<R: Real>(p: [R; 3]) -> Vector3<f64> {
    Vector3::from(p.map(Into::into))
}

fn matrix<R: Real>(fit: &Fit<R>) -> Matrix3<f64> {
    let rows = fit.motion.rotation().to_matrix3();
    Matrix3::from_fn(|i, j| rows[i][j].into())
}

/// Umeyama's equations 34 to 43, by a singular value decomposition.
struct Opinion {
    rotation: Matrix3<f64>,
    scale: f64,
    translation: Vector3<f64>,
    singular: Vector3<f64>,
    /// σ₂ ± σ₃
    gap: f64,
    rms: f64,
}

fn opinion<R: Real>(x: &[[R; 3]], y: &[[R; 3]], w: &[R], scaled: bool) -> Opinion {
    let w: Vec<f64> = w.iter().map(|w| (*w).into()).collect();
    let total: f64 = w.iter().sum();
    let mean = |of: &[[R; 3]]| -> Vector3<f64> {
        of.iter().zip(&w).map(|(p, w)| vector(*p) * *w).sum::<Vector3<f64>>() / total
    };
    let (from, to) = (mean(x), mean(y));
    let (mut products, mut squares) = (Matrix3::zeros(), 0.0);
    for ((x, y), w) in x.iter().zip(y).zip(&w) {
        let x = vector(*x) - from;
        products += (vector(*y) - to) * x.transpose() * *w;
        squares += x.norm_squared() * w;
    }
    let svd = products.svd(true, true);
    let (u, v_t, singular) = (svd.u.unwrap(), svd.v_t.unwrap(), svd.singular_values);
    let sign = (u * v_t).determinant().signum();
    let flip = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, sign));
    let rotation = u * flip * v_t;
    let sum = singular[0] + singular[1] + sign * singular[2];
    let scale = if scaled { sum / squares } else { 1.0 };
    let translation = to - rotation * from * scale;
    let left = |((x, y), w): ((&[R; 3], &[R; 3]), &f64)| {
        (vector(*y) - rotation * vector(*x) * scale - translation).norm_squared() * w
    };
    let rms = (x.iter().zip(y).zip(&w).map(left).sum::<f64>() / total).sqrt();
    let gap = singular[1] + sign * singular[2];
    Opinion { rotation, scale, translation, singular, gap, rms }
}

/// Everything of a fit, rigid and with a scale, within the rounding of the type; how ill the
/// problem is makes it larger.
fn compare<R: Real>(problem: &Problem) {
    let [x, y] = [round::<R>(&problem.points), round(&problem.moved)];
    let w: Vec<R> = problem.weights.iter().map(|w| R::from_f64(*w)).collect();
    let pairs = PointPairs::weighted(&x, &y, &w).unwrap();
    for scaled in [false, true] {
        let wanted = opinion(&x, &y, &w, scaled);
        let fit = if scaled { pairs.similarity() } else { pairs.rigid() }.unwrap();
        let epsilon: f64 = R::EPSILON.into();
        let condition = (wanted.singular[0] + wanted.singular[1]) / wanted.gap;
        let near = 100.0 * epsilon * condition;
        let turned = (matrix(&fit) - wanted.rotation).amax();
        assert!(turned < near, "{turned:e} {condition}");
        assert!((fit.scale.into() - wanted.scale).abs() < near * wanted.scale);
        let shift = (vector(fit.motion.translation()) - wanted.translation).amax();
        assert!(shift < 40.0 * near, "{shift:e} {condition}");
        let there = vector(fit.transform_point(x[1]));
        let expected = wanted.rotation * vector(x[1]) * wanted.scale + wanted.translation;
        assert!((there - expected).amax() < 40.0 * near);
        let quality = pairs.quality(&fit);
        assert!((quality.rms.into() - wanted.rms).abs() < 40.0 * near, "{:?}", quality.rms);
        let found: f64 = quality.condition.into();
        assert!((found / condition - 1.0).abs() < near, "{found} {condition}");
    }
}

#[test]
fn fits_are_those_of_the_singular_value_decomposition() {
    let mut random = Random(1);
    for _ in 0..500 {
        let scale = random.between(0.2, 5.0);
        let thin = [1.0, 0.1][random.below(2)];
        for noise in [0.0, 0.05] {
            let problem = Problem::new(&mut random, thin, scale, noise);
            compare::<f64>(&problem);
            compare::<f32>(&problem);
        }
    }
}

/// No rotation brings points onto their image in a mirror: the smallest axis is turned over.
#[test]
fn mirrored_points_have_a_rotation_all_the_same() {
    let mut random = Random(2);
    for _ in 0..500 {
        let problem = Problem::new(&mut random, 0.1, 1.0, 0.01).mirrored();
        compare::<f64>(&problem);
    }
    // The path of a car, whose height is noise: by `Polar` it would turn by half a turn.
    let corners = [[10.0, 0.0], [0.0, 5.0], [-10.0, 0.0], [0.0, -5.0]];
    let noise = [1e-3, -1e-3, 1e-3, -1e-3];
    let at = |sign: f64| [0, 1, 2, 3].map(|i| [corners[i][0], corners[i][1], sign * noise[i]]);
    let (x, y) = (at(1.0), at(-1.0));
    let pairs = PointPairs::new(&x, &y).unwrap();
    let fit = pairs.rigid().unwrap();
    assert!((matrix(&fit) - Matrix3::identity()).amax() < ROUNDING);
    let quality = pairs.quality(&fit);
    assert_eq!(quality.rank, 3);
    assert!((quality.rms - 2e-3).abs() < ROUNDING);
    assert!(!quality.mirrored);
}

#[test]
fn points_in_space_are_called_mirrored_and_others_are_not() {
    let mut random = Random(9);
    for _ in 0..500 {
        let problem = Problem::new(&mut random, 0.5, 1.0, 1e-3);
        let straight = problem.moved.clone();
        let mirrored = problem.mirrored();
        for (moved, expected) in [(&straight, false), (&mirrored.moved, true)] {
            for scaled in [1.0, 3.0] {
                let moved: Points<f64> = moved.iter().map(|p| p.map(|c| scaled * c)).collect();
                let pairs =
                    PointPairs::weighted(&mirrored.points, &moved, &mirrored.weights).unwrap();
                let fit = if scaled == 1.0 { pairs.rigid() } else { pairs.similarity() }.unwrap();
                let quality = pairs.quality(&fit);
                let counted = mirrored.weights.iter().filter(|w| **w > 0.0).count();
                // Four points and noise may be nearly in a plane.
                assert!(counted < 6 || quality.mirrored == expected, "{quality:?}");
            }
        }
    }
}

#[test]
fn points_in_a_plane_have_the_rank_two_and_one_answer() {
    let mut random = Random(3);
    for _ in 0..200 {
        let problem = Problem::new(&mut random, 0.0, 1.0, 0.0);
        let pairs =
            PointPairs::weighted(&problem.points, &problem.moved, &problem.weights).unwrap();
        let fit = pairs.rigid().unwrap();
        let quality = pairs.quality(&fit);
        assert_eq!(quality.rank, 2);
        assert!(quality.rms < 1e-13, "{quality:?}");
        compare::<f64>(&problem);
    }
}

/// Across the axis, pairs of complex numbers: the angle is that of Σ w x̄ y.
#[test]
fn a_fit_about_an_axis_is_that_of_complex_numbers() {
    let mut random = Random(4);
    for _ in 0..500 {
        let problem = Problem::new(&mut random, 1.0, 1.0, 0.3);
        let axis = random.direction::<3>();
        let size = 10.0_f64.powf(random.between(-3.0, 3.0));
        let pairs =
            PointPairs::weighted(&problem.points, &problem.moved, &problem.weights).unwrap();
        let fit = pairs.about(axis.map(|c| size * c)).unwrap();
        let upright = Rotation3::rotation_between(&Vector3::from(axis), &Vector3::z());
        let upright = upright.expect("not the opposite");
        let (mut real, mut imaginary) = (0.0, 0.0);
        let all = problem.points.iter().zip(&problem.moved).zip(&problem.weights);
        for ((x, y), w) in all {
            let x = upright * (vector(*x) - vector(fit.from));
            let y = upright * (vector(*y) - vector(fit.to));
            real += w * (x[0] * y[0] + x[1] * y[1]);
            imaginary += w * (x[0] * y[1] - x[1] * y[0]);
        }
        let angle = imaginary.atan2(real);
        let wanted = UnitQuaternion::from_scaled_axis(Vector3::from(axis) * angle);
        let turned = (matrix(&fit) - wanted.to_rotation_matrix().into_inner()).amax();
        let strength = real.hypot(imaginary);
        assert!(turned < 1e-12 * (1.0 + 1.0 / strength), "{turned:e} {strength}");
        let held = vector(fit.motion.rotation().rotate(axis)) - Vector3::from(axis);
        assert!(held.amax() < ROUNDING);
    }
}

#[test]
fn whole_weights_are_pairs_that_are_repeated() {
    let mut random = Random(5);
    for _ in 0..200 {
        let problem = Problem::new(&mut random, 1.0, 2.0, 0.2);
        let times: Vec<usize> = problem.points.iter().map(|_| random.below(4)).collect();
        let repeated = |of: &Points<f64>| -> Points<f64> {
            { of.iter().zip(&times) }.flat_map(|(p, n)| std::iter::repeat_n(*p, *n)).collect()
        };
        let (x, y) = (repeated(&problem.points), repeated(&problem.moved));
        let Ok(wanted) = PointPairs::new(&x, &y).and_then(|pairs| pairs.similarity()) else {
            continue;
        };
        let plain = PointPairs::new(&x, &y).unwrap();
        // Only the ratios matter, even where sums of the weights overflow or vanish.
        for size in [1.0, 7.0, 1e308 / 3.0, 1e-300] {
            let weights: Vec<f64> = times.iter().map(|n| size * *n as f64).collect();
            let pairs = PointPairs::weighted(&problem.points, &problem.moved, &weights).unwrap();
            let fit = pairs.similarity().unwrap();
            let [rms, same] = [pairs.quality(&fit), plain.quality(&wanted)];
            let near = 1e-13 * same.condition;
            assert!((matrix(&fit) - matrix(&wanted)).amax() < near);
            assert!((fit.scale / wanted.scale - 1.0).abs() < near);
            assert!((rms.rms - same.rms).abs() < near && rms.rank == same.rank);
        }
    }
}

/// A million metres away `f32` has coordinates in sixteenths of a metre. What these say is kept.
#[test]
fn far_from_the_origin_nothing_is_lost_that_the_coordinates_have() {
    let mut random = Random(6);
    let offset = [1e6, -1e6, 1e6_f32];
    for _ in 0..200 {
        let grid = |random: &mut Random| random.vector().map(|c| (640.0 * c).round() as f32 / 16.0);
        let near: Points<f32> = (0..12).map(|_| grid(&mut random)).collect();
        // A turn that keeps the coordinates on the grid.
        let turn = Quat::from_axis_angle([0.0, 0.0, 1.0_f32], FRAC_PI_2 as f32);
        let far: Points<f32> =
            near.iter().map(|p| std::array::from_fn(|i| p[i] + offset[i])).collect();
        let moved: Points<f32> = far.iter().map(|[x, y, z]| [-y, *x, *z]).collect();
        let pairs = PointPairs::new(&far, &moved).unwrap();
        let fit = pairs.rigid().unwrap();
        let away = (fit.motion.rotation() - turn).norm();
        assert!(away < 1e-6, "{away:e}");
        // The means themselves are rounded to the grid.
        let quality = pairs.quality(&fit);
        assert!(quality.rms < 0.11 && quality.rank == 3, "{quality:?}");
    }
    let problem = Problem::new(&mut random, 1.0, 1.0, 0.0);
    let far = |of: &Points<f64>| -> Points<f64> { of.iter().map(|p| p.map(|c| c + 1e6)).collect() };
    let (x, y) = (far(&problem.points), far(&problem.moved));
    let [there, here] = [(&x, &y), (&problem.points, &problem.moved)]
        .map(|(x, y)| PointPairs::new(x, y).unwrap().rigid().unwrap());
    assert!((matrix(&there) - matrix(&here)).amax() < 1e-8);
    assert!(PointPairs::new(&x, &y).unwrap().quality(&there).rms < 1e-8);
}

#[test]
fn what_does_not_say_how_points_turned_is_refused_with_its_rank() {
    let line = |t: f64| [0.1 * t + 3.0, 0.3 * t, -0.7 * t];
    let x: Points<f64> = [0.0, 1.0, 2.5, 7.0].map(line).to_vec();
    let point = vec![[0.1, 0.2, 0.3]; 4];
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for (x, y, rank) in
        [(&x, &corners, 1), (&corners, &x, 1), (&point, &corners, 0), (&corners, &point, 0)]
    {
        let pairs = PointPairs::new(x, y).unwrap();
        let error = FitError::Ambiguous { pairs: 4, rank };
        assert_eq!([pairs.rigid(), pairs.similarity()], [Err(error), Err(error)]);
    }
    // Too few pairs with a weight; and an image in a mirror that no axis is the smallest of.
    let few = |count: usize| PointPairs::new(&corners[..count], &corners[..count]).unwrap();
    for count in [1, 2] {
        let error = few(count).rigid().unwrap_err();
        assert_eq!(error, FitError::Ambiguous { pairs: count, rank: count - 1 });
    }
    assert!(few(3).rigid().is_ok());
    let weights = [1.0, 0.0, 1.0, 0.0];
    let error = PointPairs::weighted(&corners, &corners, &weights).unwrap().rigid().unwrap_err();
    assert_eq!(error, FitError::Ambiguous { pairs: 2, rank: 1 });
    let even: Points<f64> = corners[1..].iter().flat_map(|p| [*p, p.map(|c| -c)]).collect();
    let opposite: Points<f64> = even.iter().map(|p| p.map(|c| -c)).collect();
    let pairs = PointPairs::new(&even, &opposite).unwrap();
    assert_eq!(pairs.rigid(), Err(FitError::Ambiguous { pairs: 6, rank: 3 }));
    assert!(pairs.about([0.0, 0.0, 1.0]).is_ok());
    // A column says nothing of the turn about itself, and all of others.
    let column = [[1.0, 2.0, 0.0], [1.0, 2.0, 5.0]];
    let pairs = PointPairs::new(&column, &column).unwrap();
    let up = pairs.about([0.0, 0.0, 2.0]);
    assert_eq!(up, Err(FitError::Ambiguous { pairs: 2, rank: 1 }));
    let fit = pairs.about([1.0, 0.0, 0.0]).unwrap();
    let quality = pairs.quality(&fit);
    assert!(quality.rank == 1 && quality.condition == f64::INFINITY, "{quality:?}");
    // Many points on a line, whose sums are rounded as often.
    let mut random = Random(8);
    let along = |t: f64| [line(t).map(|c| c as f32), [0.6, 0.5 - 0.2 * t, t].map(|c| c as f32)];
    let many: Vec<_> = (0..1_000_000).map(|_| along(random.signed())).collect();
    let [x, y] = [0, 1].map(|side| many.iter().map(|pair| pair[side]).collect::<Points<f32>>());
    let error = PointPairs::new(&x, &y).unwrap().rigid().unwrap_err();
    assert_eq!(error, FitError::Ambiguous { pairs: 1_000_000, rank: 1 });
    // Squares that `f32` has no digits for.
    let tiny: Points<f32> = corners.iter().map(|p| p.map(|c| 1e-20 * c as f32)).collect();
    let error = PointPairs::new(&tiny, &tiny).unwrap().rigid().unwrap_err();
    assert_eq!(error, FitError::Ambiguous { pairs: 4, rank: 0 });
}

#[test]
fn bad_input_is_named() {
    let good = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0_f64]];
    let pairs = |x: &[[f64; 3]], y: &[[f64; 3]]| PointPairs::new(x, y).map(|_| ()).unwrap_err();
    let length = |what, found, expected| FitError::Length { what, found, expected };
    assert_eq!(pairs(&good, &good[..2]), length("moved", 2, 3));
    assert_eq!(pairs(&[], &[]), FitError::Empty);
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut bad = good;
        bad[2][1] = value;
        for (what, error) in [("points", pairs(&bad, &good)), ("moved", pairs(&good, &bad))] {
            let FitError::NotFinite { what: found, index: 2, value: named } = error else {
                panic!("{error}")
            };
            assert!(found == what && named.to_bits() == value.to_bits());
        }
    }
    let weighted =
        |weights: &[f64]| PointPairs::weighted(&good, &good, weights).map(|_| ()).unwrap_err();
    assert_eq!(weighted(&[1.0; 4]), length("weights", 4, 3));
    assert_eq!(weighted(&[0.0; 3]), FitError::Empty);
    let error = weighted(&[1.0, -0.5, f64::NAN]);
    assert_eq!(error, FitError::Weight { index: 1, value: -0.5 });
    assert!(matches!(weighted(&[1.0, 1.0, f64::NAN]), FitError::Weight { index: 2, .. }));
    assert!(matches!(weighted(&[f64::INFINITY; 3]), FitError::Weight { index: 0, .. }));
    let huge = good.map(|p| p.map(|c| 1e160 * c));
    assert_eq!(pairs(&huge, &good), FitError::Overflow);
    assert_eq!(pairs(&good, &huge), FitError::Overflow);
    let pairs = PointPairs::new(&good, &good).unwrap();
    assert_eq!(pairs.about([0.0; 3]), Err(FitError::Axis { length: 0.0 }));
    let error = pairs.about([f64::INFINITY, 0.0, 0.0]);
    assert_eq!(error, Err(FitError::Axis { length: f64::INFINITY }));
    assert!(matches!(pairs.about([f64::NAN; 3]), Err(FitError::Axis { .. })));
}

/// Dual numbers differentiate a fit: where all points shift, so does the motion.
#[test]
fn a_fit_can_be_differentiated() {
    let mut random = Random(7);
    let motion: DualQuat<f64> = random.motion(3.0);
    let x: Points<f64> = (0..8).map(|_| random.vector()).collect();
    let way = [0.3, -2.0, 0.7];
    let still = |c: f64| Dual::new(c, 0.0);
    let points: Points<Dual<f64>> = x.iter().map(|p| p.map(still)).collect();
    let shifting = |p: &[f64; 3]| {
        let there = motion.transform_point(*p);
        std::array::from_fn(|i| Dual::new(there[i], way[i]))
    };
    let moved: Points<Dual<f64>> = x.iter().map(shifting).collect();
    let fit = PointPairs::new(&points, &moved).unwrap().rigid().unwrap();
    for (found, wanted) in fit.motion.translation().into_iter().zip(way) {
        assert!((found.dual - wanted).abs() < 1e-12, "{found}");
    }
}

/// Many sets in the same slices.
struct Sets<R> {
    points: Points<R>,
    moved: Points<R>,
    weights: Vec<R>,
    counts: Vec<usize>,
}

impl<R: Scalar> Sets<R> {
    /// Sets of every kind: most of them good, and all that a fit refuses.
    fn new(count: usize) -> Self {
        let mut random = Random(31);
        let mut sets =
            Self { points: vec![], moved: vec![], weights: vec![], counts: vec![0; count] };
        for (index, count) in sets.counts.iter_mut().enumerate() {
            let thin = [1.0, 0.3, 1e-6, 0.0][index % 4];
            let noise = [0.0, 0.05, 0.5][index % 3];
            let mut problem = Problem::new(&mut random, thin, 1.5, noise);
            let place = random.below(problem.points.len());
            match index % 23 {
                1 => problem.points.iter_mut().for_each(|p| *p = [p[0], 2.0 * p[0], 0.0]),
                2 => problem.moved.fill([1.0, 2.0, 3.0]),
                3 => problem = problem.mirrored(),
                4 => problem.points.truncate(2),
                5 => problem.points.truncate(1),
                6 => problem.points.clear(),
                7 => problem.weights.fill(0.0),
                8 => problem.weights[place] = -1.0,
                9 => problem.weights[place] = f64::NAN,
                10 => problem.points[place][1] = f64::NAN,
                11 => problem.moved[place][2] = f64::INFINITY,
                12 => problem.moved[place][0] = f64::NEG_INFINITY,
                13 => problem.points[place] = if R::SINGLE { [1e25; 3] } else { [1e200; 3] },
                14 => problem.weights[0] = 0.0,
                15 => problem.weights.iter_mut().for_each(|w| *w *= 1e30),
                16 => problem.points.iter_mut().flatten().for_each(|c| *c *= 1e-15),
                17 => problem.moved.iter_mut().flatten().for_each(|c| *c += 1e3),
                18 => problem.weights[place] = f64::INFINITY,
                _ => {}
            }
            *count = problem.points.len();
            sets.points.extend(round::<R>(&problem.points));
            sets.moved.extend(round::<R>(&problem.moved[..*count]));
            let weights = &problem.weights[..*count];
            sets.weights.extend(weights.iter().map(|&w| <R as Real>::from_f64(w)));
        }
        sets
    }

    fn pairs(&self, count: usize, weighted: bool) -> PairSets<'_, R> {
        let counts = &self.counts[..count];
        let all = counts.iter().sum();
        let (points, moved) = (&self.points[..all], &self.moved[..all]);
        if weighted {
            PairSets::weighted(points, moved, &self.weights[..all], counts).unwrap()
        } else {
            PairSets::new(points, moved, counts).unwrap()
        }
    }

    /// The fit of some pairs alone, and its quality.
    fn alone(
        &self,
        pairs: Range<usize>,
        weighted: bool,
        maps: Maps<R>,
    ) -> Result<(Fit<R>, Quality<R>), FitError> {
        let (points, moved) = (&self.points[pairs.clone()], &self.moved[pairs.clone()]);
        let pairs = if weighted {
            PointPairs::weighted(points, moved, &self.weights[pairs])?
        } else {
            PointPairs::new(points, moved)?
        };
        let fit = match maps {
            Maps::Rigid => pairs.rigid(),
            Maps::Similarity => pairs.similarity(),
            Maps::About(axis) => pairs.about(axis),
        }?;
        Ok((fit, pairs.quality(&fit)))
    }
}

/// All numbers of an answer as bits, with one pattern for NaN.
fn bits<R: Real>(fit: &Fit<R>, quality: &Quality<R>) -> Vec<u64> {
    let numbers =
        fit.motion.to_array().into_iter().chain([fit.scale]).chain(fit.from).chain(fit.to);
    let numbers = numbers.chain([quality.rms, quality.condition]).map(Into::<f64>::into);
    let bits = numbers.map(|x| if x.is_nan() { u64::MAX } else { x.to_bits() });
    bits.chain([quality.rank as u64]).collect()
}

/// The answer of one set among many.
fn among_many<R: Real>(alone: Result<(Fit<R>, Quality<R>), FitError>) -> Vec<u64> {
    let mut quality = Quality::NONE;
    match alone {
        Ok((fit, quality)) => return bits(&fit, &quality),
        Err(FitError::Ambiguous { rank, .. }) => {
            (quality.rank, quality.condition) = (rank, R::ONE / R::ZERO);
        }
        Err(_) => {}
    }
    bits(&Fit::NONE, &quality)
}

fn each<R: Scalar>(backend: Backend, sets: PairSets<'_, R>, maps: Maps<R>) -> Vec<Vec<u64>> {
    let mut fits = vec![Fit::NONE; sets.len()];
    let mut qualities = vec![Quality::NONE; sets.len()];
    backend.fit_each(sets, maps, &mut fits, &mut qualities).unwrap();
    fits.iter().zip(&qualities).map(|(fit, quality)| bits(fit, quality)).collect()
}

fn backends() -> impl Iterator<Item = Backend> {
    #[cfg(feature = "reproducible")]
    return Backend::available().flat_map(|backend| [backend, backend.unfused()]);
    #[cfg(not(feature = "reproducible"))]
    Backend::available()
}

fn each_of_many_sets_has_the_bits_of_that_set_alone<R: Scalar>() {
    let sets = Sets::<R>::new(210);
    let axis = [0.2, 0.5, -1.0].map(<R as Real>::from_f64);
    let mut refused = Vec::new();
    for weighted in [false, true] {
        for maps in [Maps::Rigid, Maps::Similarity, Maps::About(axis)] {
            let mut start = 0;
            let wanted = sets.counts.iter().map(|count| {
                let alone = sets.alone(start..start + count, weighted, maps);
                start += count;
                refused.extend(alone.err());
                among_many(alone)
            });
            let wanted: Vec<_> = wanted.collect();
            let good = wanted.iter().filter(|bits| bits[0] != u64::MAX).count();
            assert!(good > 70, "{good}");
            for backend in backends() {
                for count in [0, 1, 3, 15, 16, 17, 33, 210] {
                    let found = each(backend, sets.pairs(count, weighted), maps);
                    assert_eq!(found.len(), count);
                    for (index, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
                        let count = sets.counts[index];
                        assert_eq!(found, wanted, "{backend}, {maps:?}: set {index} of {count}");
                    }
                }
            }
        }
    }
    for error in [
        FitError::NotFinite { what: "points", index: 0, value: 0.0 },
        FitError::Weight { index: 0, value: 0.0 },
        FitError::Empty,
        FitError::Ambiguous { pairs: 0, rank: 0 },
        FitError::Overflow,
    ] {
        let found = refused.iter().filter(|found| discriminant(*found) == discriminant(&error));
        assert!(found.count() >= 6, "{error}");
    }
}

#[test]
fn each_of_many_sets_has_the_bits_of_that_set_alone_f32() {
    each_of_many_sets_has_the_bits_of_that_set_alone::<f32>();
}

#[test]
fn each_of_many_sets_has_the_bits_of_that_set_alone_f64() {
    each_of_many_sets_has_the_bits_of_that_set_alone::<f64>();
}

#[test]
fn a_bad_set_among_a_thousand_changes_no_other() {
    let mut random = Random(32);
    let mut sets = Sets::<f32> {
        points: (0..5000).map(|_| random.vector().map(|c| c as f32)).collect(),
        moved: (0..5000).map(|_| random.vector().map(|c| c as f32)).collect(),
        weights: vec![1.0; 5000],
        counts: vec![5; 1000],
    };
    let good = each(Backend::best(), sets.pairs(1000, true), Maps::Rigid);
    let none = among_many::<f32>(Err(FitError::Empty));
    for (place, bad) in [(0, f32::NAN), (7, f32::INFINITY), (500, f32::MAX), (999, f32::NAN)] {
        for kind in 0..3 {
            let number = match kind {
                0 => &mut sets.points[5 * place + 3][1],
                1 => &mut sets.moved[5 * place][2],
                _ => &mut sets.weights[5 * place + 4],
            };
            let before = *number;
            *number = if kind == 2 { -bad } else { bad };
            let found = each(Backend::best(), sets.pairs(1000, true), Maps::Rigid);
            match kind {
                0 => sets.points[5 * place + 3][1] = before,
                1 => sets.moved[5 * place][2] = before,
                _ => sets.weights[5 * place + 4] = before,
            }
            for (index, (found, good)) in found.iter().zip(&good).enumerate() {
                assert_eq!(found, if index == place { &none } else { good }, "{index}");
            }
        }
    }
}

#[test]
fn sets_of_other_lengths_are_refused_and_nothing_is_written() {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0_f64]];
    let length = |what, found, expected| FitError::Length { what, found, expected };
    let new = |moved: &[[f64; 3]], counts: &[usize]| PairSets::new(&points, moved, counts).err();
    assert_eq!(new(&points, &[2, 0, 1]), None);
    assert_eq!(new(&points, &[2, 2]), Some(length("points", 3, 4)));
    assert_eq!(new(&points, &[]), Some(length("points", 3, 0)));
    assert_eq!(new(&points, &[usize::MAX, 4]), Some(length("points", 3, usize::MAX)));
    assert_eq!(new(&points[..2], &[3]), Some(length("moved", 2, 3)));
    let weighted = PairSets::weighted(&points, &points, &[1.0; 2], &[3]);
    assert_eq!(weighted.err(), Some(length("weights", 2, 3)));

    let pairs = PointPairs::new(&points, &points).unwrap();
    let fit = pairs.rigid().unwrap();
    let (mut fits, mut qualities) = ([fit; 3], [pairs.quality(&fit); 3]);
    let before = (fits, qualities);
    let sets = PairSets::new(&points, &points, &[3, 0]).unwrap();
    assert!(sets.len() == 2 && !sets.is_empty());
    let backend = Backend::best();
    let error = backend.fit_each(sets, Maps::Rigid, &mut fits, &mut qualities[..2]);
    assert_eq!(error, Err(length("fits", 3, 2)));
    let error = backend.fit_each(sets, Maps::Rigid, &mut fits[..2], &mut qualities[..1]);
    assert_eq!(error, Err(length("qualities", 1, 2)));
    for axis in [[0.0; 3], [0.0, f64::INFINITY, 0.0], [f64::NAN; 3]] {
        let maps = Maps::About(axis);
        let error = backend.fit_each(sets, maps, &mut fits[..2], &mut qualities[..2]);
        assert!(matches!(error, Err(FitError::Axis { .. })), "{error:?}");
    }
    assert_eq!((fits, qualities), before);
    assert_eq!(length("fits", 3, 2).to_string(), "fits has the length 3, but needs the length 2");
}

#[cfg(feature = "rayon")]
#[test]
fn all_cores_fit_sets_as_one_does() {
    for count in [1, 100, 3001] {
        let sets = Sets::<f32>::new(count);
        let pairs = sets.pairs(count, true);
        let [one, all] = [1, usize::MAX]
            .map(|threads| each(Backend::best().threads(threads), pairs, Maps::Similarity));
        assert_eq!(one, all);
    }
}
