//! The motion between two arrays of points.

use crate::argument::{count, names, one_of, reads, writes};
use crate::element::Element;
use crate::function::Function;
use crate::shape::Shape;
use dq8::fit::PointPairs;
use dq8::{DualQuat, Real};
use dq8_capi::Status;
use dq8_capi::fit::{FitQuality, double, single};

/// Points at some corners of a box and inside of it.
fn point<R: Real>(at: usize) -> [R; 3] {
    let side = |axis: usize| R::from_f64(((at >> axis & 1) * (axis + 1)) as f64 + 0.01 * at as f64);
    [side(0), side(1), side(2)]
}

macro_rules! add {
    ($shape:ident $to:ident $R:ident $of:ident) => {{
        // Fewer points are on a line.
        let n = $shape.count.max(5);
        let motion = <DualQuat<$R> as Element>::sample(1, 4);
        let moved = move |at: usize| {
            let [x, y, z] = motion.transform_point(point::<$R>(at));
            [1.5 * x, 1.5 * y, 1.5 * z + 0.1 * (at % 3) as $R]
        };
        functions! { $to:
            concat!("dq8_fit_", stringify!($R)), $of::fit = (
                points: reads::<[$R; 3]>(n).only(point)
                    .fault(Status::NotFinite, Some(3), |points| points[3][1] = <$R>::NAN)
                    .fault(Status::Ambiguous, None, |points| points.fill([1.0, 2.0, 3.0])),
                moved: reads::<[$R; 3]>(n).only(moved)
                    .fault(Status::NotFinite, Some(4), |points| points[4][2] = <$R>::INFINITY)
                    .fault(Status::NotFinite, None, |points| points[4][2] = <$R>::MAX),
                weights: reads::<$R>(n).only(|at| 0.5 + (at % 2) as $R).unless_null(0)
                    .fault(Status::Weight, Some(2), |weights| weights[2] = -1.0)
                    .fault(Status::NoInfluences, None, |weights| weights.fill(0.0)),
                count: count(n).wrong(0, Status::NoInfluences),
                scaled: one_of([0, 1]).wrong(2, Status::UnknownValue).wrong(-1, Status::UnknownValue),
                motion: writes::<DualQuat<$R>>(1), quality: writes::<FitQuality<$R>>(1).unless_null(1),
                bad_pair: names(),
            ) => {
                let pairs = if weights.is_empty() {
                    PointPairs::new(points, moved)
                } else {
                    PointPairs::weighted(points, moved, weights)
                };
                // Random arrays are as long as these, and their contents are the same.
                let pairs = pairs.expect("pairs");
                let fit = if scaled == 1 { pairs.similarity() } else { pairs.rigid() };
                let fit = fit.expect("a fit");
                motion[0] = fit.motion;
                let told = pairs.quality(&fit);
                quality.fill(FitQuality {
                    scale: fit.scale,
                    rms: told.rms,
                    condition: told.condition,
                    rank: told.rank,
                    mirrored: told.mirrored.into(),
                });
            };
        }
    }};
}

pub(super) fn add(shape: &Shape, to: &mut Vec<Function>) {
    add!(shape to f32 single);
    add!(shape to f64 double);
}
