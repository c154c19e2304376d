//! People from SMPL-X: turns of joints, and the arrays of a body model that the caller has.

use crate::{Person, RetargetError};
use dq8::scalar::vector::{add, norm, over_norm, sub};
use dq8::{DualQuat, Quat};

type Vector = [f64; 3];

/// The joints of the body in the order of SMPL, SMPL-H and SMPL-X, with their parents. Those that
/// follow there are jaw, eyes and fingers. The joints that SMPL calls feet are toes.
const JOINTS: [(&str, Option<usize>); 22] = [
    ("pelvis", None),
    ("left_hip", Some(0)),
    ("right_hip", Some(0)),
    ("spine1", Some(0)),
    ("left_knee", Some(1)),
    ("right_knee", Some(2)),
    ("spine2", Some(3)),
    ("left_ankle", Some(4)),
    ("right_ankle", Some(5)),
    ("spine3", Some(6)),
    ("left_toe", Some(7)),
    ("right_toe", Some(8)),
    ("neck", Some(9)),
    ("left_collar", Some(9)),
    ("right_collar", Some(9)),
    ("head", Some(12)),
    ("left_shoulder", Some(13)),
    ("right_shoulder", Some(14)),
    ("left_elbow", Some(16)),
    ("right_elbow", Some(17)),
    ("left_wrist", Some(18)),
    ("right_wrist", Some(19)),
];

/// The arrays of a body model, as its file has them. No model comes with this crate, because their
/// licences forbid it.
#[derive(Clone, Copy, Debug)]
pub struct BodyModel<'m> {
    /// `v_template`: the vertices of the mean shape.
    pub template: &'m [Vector],
    /// `shapedirs`: how each coordinate of a vertex moves with each number of the shape,
    /// `[vertex][axis][shape]`.
    pub shapes: &'m [f64],
    /// `J_regressor`: the weights of vertices whose sum is a joint, `[joint][vertex]`.
    pub regressor: &'m [f64],
}

impl BodyModel<'_> {
    /// Returns the places of the joints of the body for a shape: regressor · (template + shapes ·
    /// betas). Numbers of the shape that are not given are zero.
    ///
    /// # Errors
    /// If the arrays do not fit each other, or there are more betas than shapes.
    pub fn joints(&self, betas: &[f64]) -> Result<Vec<Vector>, RetargetError> {
        let vertices = self.template.len();
        let expect = |array, length, expected, fits: bool| {
            fits.then_some(()).ok_or(RetargetError::Lengths { array, length, expected })
        };
        expect("template", vertices, 1, vertices > 0)?;
        let (coordinates, length) = (3 * vertices, self.shapes.len());
        expect("shapes", length, coordinates, length.is_multiple_of(coordinates))?;
        let shapes = length / coordinates;
        expect("betas", betas.len(), shapes, betas.len() <= shapes)?;
        let (length, least) = (self.regressor.len(), JOINTS.len() * vertices);
        expect("regressor", length, least, length >= least && length.is_multiple_of(vertices))?;
        let moved = |(vertex, &place): (usize, &Vector)| -> Vector {
            core::array::from_fn(|axis| {
                let row = &self.shapes[(3 * vertex + axis) * shapes..][..betas.len()];
                place[axis] + row.iter().zip(betas).map(|(a, b)| a * b).sum::<f64>()
            })
        };
        let body: Vec<_> = self.template.iter().enumerate().map(moved).collect();
        let joint = |weights: &[f64]| {
            weights.iter().zip(&body).fold([0.0; 3], |sum, (&weight, place)| {
                if weight == 0.0 { sum } else { add(sum, place.map(|x| weight * x)) }
            })
        };
        Ok(self.regressor.chunks_exact(vertices).take(JOINTS.len()).map(joint).collect())
    }
}

impl Person {
    /// Takes a person from the turns of the joints of SMPL, SMPL-H or SMPL-X, as rotation vectors,
    /// `[frame][joint]`, with the root first. `places` has the way of the root in each frame, which
    /// tells how many frames there are. Of each frame the 22 joints of the body are read.
    ///
    /// # Errors
    /// If the arrays do not fit each other, or a number is not finite.
    pub fn from_body_model(
        title: impl Into<String>,
        model: BodyModel<'_>,
        betas: &[f64],
        turns: &[Vector],
        places: &[Vector],
        frame_time: f64,
    ) -> Result<Self, RetargetError> {
        let at = model.joints(betas)?;
        let (array, length, count) = ("turns", turns.len(), JOINTS.len());
        let each = length.checked_div(places.len()).unwrap_or(0);
        if each < count || each * places.len() != length {
            return Err(RetargetError::Lengths { array, length, expected: count * places.len() });
        }
        let mut locals = Vec::with_capacity(count * places.len());
        for (turns, &place) in turns.chunks_exact(each).zip(places) {
            for (joint, (_, parent)) in JOINTS.into_iter().enumerate() {
                let way = parent.map_or(add(at[0], place), |parent| sub(at[joint], at[parent]));
                let turn = rotation(turns[joint]);
                locals.push(DualQuat::from_rotation_translation(turn, way));
            }
        }
        let (names, parents) =
            JOINTS.into_iter().map(|(name, parent)| (name.to_owned(), parent)).unzip();
        Self::from_locals(title.into(), names, parents, locals, frame_time)
    }
}

/// Returns the rotation by a rotation vector.
fn rotation(vector: Vector) -> Quat<f64> {
    let angle = norm(vector);
    if angle == 0.0 {
        return Quat::IDENTITY;
    }
    Quat::from_axis_angle(over_norm(vector, angle), angle)
}
