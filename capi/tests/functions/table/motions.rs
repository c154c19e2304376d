//! Functions on one motion.

use crate::argument::{Of, Read, Written, count, one_of, passes, reads, writes};
use crate::element::{Element, SCALED, record, wave};
use crate::function::Function;
use crate::shape::Shape;
use dq8::geometry::{DualVector, Screw};
use dq8::representation::{EulerAngles, EulerAxes, EulerFrame, EulerOrder};
use dq8::{DualQuat, Line, Plane, Quat, Real, Twist, internal};
use dq8_capi::{Status, euler, geometry, mean, motion, screw};

/// It may lie anywhere.
fn to<T: Element>() -> Of<T, Written> {
    writes(1).free()
}

/// The order of Euler angles in all calls.
const TURNS: EulerOrder = EulerOrder { axes: EulerAxes::ZXY, frame: EulerFrame::Intrinsic };

/// A string: the order [`TURNS`].
fn order() -> Of<u8, Read> {
    let wrong = [*b"ZXy\0", *b"XXY\0", *b"XYY\0", *b"WXY\0", *b"ZXYZ", *b"ZX\0Y", *b"\0XYZ"];
    wrong.into_iter().fold(reads(4).only(|at| b"ZXY\0"[at]), |order, wrong| {
        order.fault(Status::UnknownValue, None, move |letters| letters.copy_from_slice(&wrong))
    })
}

fn finite<R: Real>(motion: DualQuat<R>) -> Result<DualQuat<R>, Status> {
    let finite = motion.to_array().into_iter().all(Real::is_finite);
    if finite { Ok(motion) } else { Err(Status::NotNormalizable) }
}

fn numbers<R: Copy>(Screw { axis, angle, slide }: Screw<R>) -> [R; 8] {
    let ([x, y, z], [u, v, w]) = (axis.direction, axis.moment);
    [x, y, z, u, v, w, angle, slide]
}

macro_rules! add {
    ($shape:ident $list:ident $R:ident $of:ident) => {{
        type Motion = DualQuat<$R>;
        let one = || reads::<Motion>(1);
        let scaled = || one().of(|_| Element::sample(1, SCALED));
        let three = || reads::<[$R; 3]>(1);
        let matrix = || DualQuat::from_array(record(1, 3)).to_matrix4();
        let n = $shape.count;
        of_numbers! { $list $R $of:
            "motion_" motion identity (out: to::<Motion>()) => out[0] = Motion::IDENTITY;
            "motion_" motion from_rotation_translation
                (rotation: reads::<Quat<$R>>(1), translation: three(), out: to::<Motion>())
                => out[0] = Motion::from_rotation_translation(rotation[0], translation[0]);
            "motion_" motion to_rotation_translation
                (motion: one(), rotation: to::<Quat<$R>>(), translation: to::<[$R; 3]>())
                => (rotation[0], translation[0]) = (motion[0].rotation(), motion[0].translation());
            "motion_" motion from_matrix_3x4 (
                matrix: reads::<[[$R; 4]; 3]>(1).only(move |_| { let [x, y, z, _] = matrix(); [x, y, z] })
                    .fault(Status::NotOrthonormal, None, |all| all[0][1] = all[0][1].map(|number| 2.0 * number))
                    .fault(Status::Mirrors, None, |all| (0..3).for_each(|c| all[0][1][c] = -all[0][1][c]))
                    .fault(Status::NotFinite, None, |all| all[0][0][3] = <$R>::INFINITY),
                tolerance: passes(1e-5), out: to::<Motion>(),
            ) => out[0] = Motion::try_from_matrix3x4(matrix[0], tolerance)?;
            "motion_" motion from_matrix_4x4 (
                matrix: reads::<[[$R; 4]; 4]>(1).only(move |_| matrix())
                    .fault(Status::NotOrthonormal, None, |all| all[0][1] = all[0][1].map(|number| 2.0 * number))
                    .fault(Status::Mirrors, None, |all| (0..3).for_each(|c| all[0][1][c] = -all[0][1][c]))
                    .fault(Status::NotFinite, None, |all| all[0][0][3] = <$R>::INFINITY)
                    .fault(Status::NotAffine, None, |all| all[0][3][0] = 0.5),
                tolerance: passes(1e-5), out: to::<Motion>(),
            ) => out[0] = Motion::try_from_matrix4(matrix[0], tolerance)?;
            "motion_" motion to_matrix_3x4 (motion: one(), matrix: to::<[[$R; 4]; 3]>())
                => matrix[0] = motion[0].to_matrix3x4();
            "motion_" motion to_matrix_4x4 (motion: one(), matrix: to::<[[$R; 4]; 4]>())
                => matrix[0] = motion[0].to_matrix4();
            "motion_" euler from_euler (
                order: order(), angles: reads::<[$R; 3]>(1), out: to::<Motion>(),
            ) => out[0] = Motion::from_rotation(EulerAngles { angles: angles[0], order: TURNS }.to_quat());
            "motion_" euler to_euler (
                motion: one(), order: order(), angles: to::<[$R; 3]>(), gimbal_lock: to::<i32>().unless_null(0),
            ) => {
                let found = motion[0].rotation().to_euler(TURNS);
                angles[0] = found.angles.angles;
                gimbal_lock.fill(found.gimbal_lock.into());
            };
            "motion_" motion mul (a: one(), b: one(), out: to::<Motion>()) => out[0] = a[0] * b[0];
            "motion_" motion conjugate (motion: one(), out: to::<Motion>()) => out[0] = motion[0].conjugate();
            "motion_" motion inverse (
                motion: scaled()
                    .fault(Status::NoInverse, None, |all| all[0] = Motion::ZERO)
                    .fault(Status::NoInverse, None, |all| all[0] = Motion::from_array([<$R>::NAN; 8])),
                out: to::<Motion>(),
            ) => out[0] = motion[0].try_inverse()?;
            "motion_" motion normalize (
                motion: scaled().fault(Status::NotNormalizable, None, |all| all[0] = Motion::ZERO),
                out: to::<Motion>(),
            ) => out[0] = motion[0].try_normalize()?;
            "motion_" motion check_unit (
                motion: one().fault(Status::NotUnit, None, |all| all[0] = Motion::ZERO),
                tolerance: passes(1e-5),
            ) => if motion[0].is_unit(tolerance) { Ok(()) } else { Err(Status::NotUnit) };
            "motion_" motion point (motion: one(), point: three(), out: to::<[$R; 3]>())
                => out[0] = motion[0].transform_point(point[0]);
            "motion_" motion vector (motion: one(), vector: three(), out: to::<[$R; 3]>())
                => out[0] = motion[0].transform_vector(vector[0]);

            "motion_" geometry line (motion: one(), line: reads::<[[$R; 3]; 2]>(1), out: to::<[[$R; 3]; 2]>()) => {
                let [direction, moment] = line[0];
                let moved = motion[0].transform_line(Line { direction, moment });
                out[0] = [moved.direction, moved.moment];
            };
            "motion_" geometry plane (motion: one(), plane: reads::<[$R; 4]>(1), out: to::<[$R; 4]>()) => {
                let [x, y, z, offset] = plane[0];
                let moved = motion[0].transform_plane(Plane { normal: [x, y, z], offset });
                let [x, y, z] = moved.normal;
                out[0] = [x, y, z, moved.offset];
            };
            "motion_" geometry twist (motion: one(), twist: reads::<Twist<$R>>(1), out: to::<Twist<$R>>())
                => out[0] = motion[0].adjoint(twist[0]);
            "motion_" geometry to_twist (motion: one(), twist: to::<Twist<$R>>()) => twist[0] = motion[0].to_twist();
            "motion_" geometry integrate_body
                (motion: one(), twist: reads::<Twist<$R>>(1), dt: passes(0.3), out: to::<Motion>())
                => out[0] = motion[0].integrate_body(twist[0], dt);
            "motion_" geometry angle_to (a: one(), b: one(), angle: to::<$R>()) => angle[0] = a[0].angle_to(b[0]);
            "motion_" geometry distance_to (a: one(), b: one(), distance: to::<$R>())
                => distance[0] = a[0].distance_to(b[0]);

            "motion_" screw nlerp (
                a: one(),
                b: one().fault(Status::NotNormalizable, None, |all| all[0] = Motion::from_array([<$R>::NAN; 8])),
                t: passes(0.3), out: to::<Motion>(),
            ) => out[0] = finite(a[0].nlerp(b[0], t))?;
            "motion_" screw sclerp (a: one(), b: one(), t: passes(0.3), out: to::<Motion>())
                => out[0] = a[0].sclerp(b[0], t);
            "motion_" screw log (motion: one(), log: to::<[[$R; 3]; 2]>()) => {
                let log_of = motion[0].log();
                log[0] = [log_of.real, log_of.dual];
            };
            "motion_" screw exp (log: reads::<[[$R; 3]; 2]>(1), out: to::<Motion>())
                => out[0] = Motion::exp(DualVector { real: log[0][0], dual: log[0][1] });
            "motion_" screw pow (motion: one(), t: passes(0.3), out: to::<Motion>()) => out[0] = motion[0].pow(t);
            "motion_" screw to_screw (motion: one(), screw: to::<[$R; 8]>())
                => screw[0] = numbers(motion[0].to_screw());
            "motion_" screw from_screw (
                screw: reads::<[$R; 8]>(1).of(|_| numbers(Motion::sample(3, 4).to_screw())),
                out: to::<Motion>(),
            ) => {
                let [x, y, z, u, v, w, angle, slide] = screw[0];
                let axis = Line { direction: [x, y, z], moment: [u, v, w] };
                out[0] = Motion::from_screw(Screw { axis, angle, slide });
            };
            "motion_" screw blend (
                motions: reads::<Motion>(n),
                weights: reads::<$R>(n).of(|at| 0.5 + wave::<$R>(at, 8).abs())
                    .fault(Status::NotNormalizable, None, |weights| weights.fill(0.0)),
                count: count(n).wrong(0, Status::NoInfluences), out: to::<Motion>(),
            ) => {
                let pairs: Vec<_> = motions.iter().copied().zip(weights.iter().copied()).collect();
                out[0] = finite(Motion::dlb(&pairs).ok_or(Status::NoInfluences)?)?;
            };
            "motion_" mean mean (
                motions: reads::<Motion>(n),
                weights: reads::<$R>(n).of(|at| 0.5 + wave::<$R>(at, 8).abs()).unless_null(0)
                    .fault(Status::NotNormalizable, None, |weights| weights.fill(0.0)),
                count: count(n).wrong(0, Status::NoInfluences), tolerance: passes(1e-5), most: one_of([64_u32, 1]),
                out: to::<Motion>(), converged: to::<i32>().unless_null(1),
            ) => {
                let equal = vec![1.0; n];
                let weights = if weights.is_empty() { &equal } else { weights };
                let pairs = motions.iter().copied().zip(weights.iter().copied());
                let mean = internal::dib(pairs, tolerance, most).ok_or(Status::NoInfluences)?;
                out[0] = finite(mean.motion)?;
                converged.fill(mean.converged.into());
            };
        }
    }};
}

pub(super) fn add(shape: &Shape, to: &mut Vec<Function>) {
    add!(shape to f32 single);
    add!(shape to f64 double);
}
