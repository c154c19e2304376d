use crate::accessor::read;
use crate::args::Method;
use crate::bones::Bones;
use dq8::skinning::{
    Linear, Mixed, Skin, SkinningError, StretchedDualBlend, Surface, SurfaceMut, matrix_palette,
    split_palette,
};
use dq8::{DualQuat, hierarchy::MatrixOrder, representation::Affine};
use gltf::Semantic;
use gltf::accessor::{DataType, Dimensions};
use gltf::mesh::Mode;

/// Four weights that are rounded to `f32` sum to one by less than 10⁻⁶; the smallest step of
/// integers of 16 bits is 1.5·10⁻⁵.
const ROUNDING: f64 = 1e-5;

/// A primitive with its skin, or with its node as the only joint.
#[derive(Debug)]
pub(crate) struct Mesh {
    place: String,
    bones: Bones,
    influences: usize,
    influence_joints: Vec<u16>,
    weights: Vec<f64>,
    positions: Vec<[f64; 3]>,
    pub(crate) triangles: Vec<[usize; 3]>,
}

impl Mesh {
    pub(crate) fn read(
        place: &str,
        buffers: &[Vec<u8>],
        primitive: &gltf::Primitive<'_>,
        bones: &Bones,
        skinned: bool,
    ) -> Result<Self, String> {
        let positions = read(buffers, &get(primitive, &Semantic::Positions)?, Dimensions::Vec3)?;
        let (influences, influence_joints, weights) = if skinned {
            influences(buffers, primitive, positions.len())?
        } else {
            (1, vec![0; positions.len()], vec![1.0; positions.len()])
        };
        let indices = match primitive.indices() {
            Some(accessor) => read::<1>(buffers, &accessor, Dimensions::Scalar)?
                .into_iter()
                .map(|[index]| index as usize)
                .collect(),
            None => (0..positions.len()).collect::<Vec<_>>(),
        };
        if let Some(&index) = indices.iter().find(|&&index| index >= positions.len()) {
            return Err(format!("index {index} of {} vertices", positions.len()));
        }
        let mesh = Self {
            place: place.to_owned(),
            bones: bones.clone(),
            influences,
            influence_joints,
            weights,
            positions,
            triangles: triangles(primitive.mode(), &indices),
        };
        mesh.skin().map_err(|error| error.to_string())?;
        Ok(mesh)
    }

    /// A warning if weights do not sum to one, as glTF 2.0 demands (§3.7.3.3): how many vertices
    /// have such weights, and which one is farthest off.
    pub(crate) fn unbalanced(&self) -> Option<String> {
        let sums = self.weights.chunks(self.influences).map(|weights| weights.iter().sum::<f64>());
        let off: Vec<_> =
            sums.enumerate().filter(|(_, sum)| (sum - 1.0).abs() > ROUNDING).collect();
        let (vertex, sum) =
            off.iter().max_by(|(_, a), (_, b)| (a - 1.0).abs().total_cmp(&(b - 1.0).abs()))?;
        let vertices = match off.len() {
            1 => "1 vertex".into(),
            many => format!("{many} vertices"),
        };
        Some(format!(
            "{}: the weights of {vertices} do not sum to 1; those of vertex {vertex} sum to {}, which is farthest off \
             (--normalize divides by the sum)",
            self.place, *sum as f32
        ))
    }

    /// Divides the weights of each vertex by their sum.
    pub(crate) fn normalize(&mut self) {
        for weights in self.weights.chunks_mut(self.influences) {
            let sum: f64 = weights.iter().sum();
            weights.iter_mut().for_each(|weight| *weight /= sum);
        }
    }

    fn skin(&self) -> Result<Skin<'_, u16, f64>, SkinningError> {
        Skin::new(self.bones.nodes.len(), self.influences, &self.influence_joints, &self.weights)
    }

    /// The vertices in the world.
    pub(crate) fn pose(
        &self,
        worlds: &[Affine<f64>],
        method: Method,
    ) -> Result<Vec<[f64; 3]>, String> {
        self.try_pose(worlds, method).map_err(|error| format!("{}: {error}", self.place))
    }

    fn try_pose(
        &self,
        worlds: &[Affine<f64>],
        method: Method,
    ) -> Result<Vec<[f64; 3]>, SkinningError> {
        let model = |&joint: &usize| {
            let rows = worlds[joint].to_matrix3x4();
            core::array::from_fn(|column| {
                let last = if column == 3 { 1.0 } else { 0.0 };
                [rows[0][column], rows[1][column], rows[2][column], last]
            })
        };
        let models: Vec<[[f64; 4]; 4]> = self.bones.nodes.iter().map(model).collect();
        let mut palette = vec![[[0.0; 4]; 3]; models.len()];
        matrix_palette(&models, &self.bones.inverse_binds, MatrixOrder::Columns, &mut palette)?;
        let mut motions = vec![DualQuat::IDENTITY; models.len()];
        let mut stretches = palette.clone();
        split_palette(&palette, &mut motions, &mut stretches)?;
        let mut posed = vec![[0.0; 3]; self.positions.len()];
        let (from, to) = (Surface::positions(&self.positions), SurfaceMut::positions(&mut posed));
        let (linear, dual) = (Linear::new(&palette), StretchedDualBlend::new(&motions, &stretches));
        let skin = self.skin()?;
        match method {
            Method::Linear => skin.pose(linear, from, to),
            Method::Dual => skin.pose(dual, from, to),
            Method::Mix(share) => {
                let shares = vec![share; self.positions.len()];
                skin.pose(Mixed::new(linear, dual, &shares)?, from, to)
            }
        }?;
        Ok(posed)
    }
}

fn get<'a>(
    primitive: &gltf::Primitive<'a>,
    semantic: &Semantic,
) -> Result<gltf::Accessor<'a>, String> {
    primitive.get(semantic).ok_or_else(|| format!("no {semantic:?}"))
}

/// How many influences a vertex has, of all their sets, the joints and the weights.
fn influences(
    buffers: &[Vec<u8>],
    primitive: &gltf::Primitive<'_>,
    vertices: usize,
) -> Result<(usize, Vec<u16>, Vec<f64>), String> {
    let sets = (0..).take_while(|&set| primitive.get(&Semantic::Joints(set)).is_some()).count();
    let sets = u32::try_from(sets.max(1)).unwrap_or(1);
    let influences = 4 * sets as usize;
    let mut joints = vec![0; influences * vertices];
    let mut weights = vec![0.0; influences * vertices];
    for set in 0..sets {
        let joint = get(primitive, &Semantic::Joints(set))?;
        if !matches!(joint.data_type(), DataType::U8 | DataType::U16) {
            return Err(format!("JOINTS_{set} of type {:?}", joint.data_type()));
        }
        let of = read::<4>(buffers, &joint, Dimensions::Vec4)?;
        let by = read::<4>(buffers, &get(primitive, &Semantic::Weights(set))?, Dimensions::Vec4)?;
        for (what, length) in [("JOINTS", of.len()), ("WEIGHTS", by.len())] {
            if length != vertices {
                return Err(format!("{length} {what}_{set} for {vertices} vertices"));
            }
        }
        for (vertex, (of, by)) in of.into_iter().zip(by).enumerate() {
            let at = vertex * influences + 4 * set as usize;
            joints[at..at + 4].copy_from_slice(&of.map(|joint| joint as u16));
            weights[at..at + 4].copy_from_slice(&by);
        }
    }
    Ok((influences, joints, weights))
}

fn triangles(mode: Mode, indices: &[usize]) -> Vec<[usize; 3]> {
    match mode {
        Mode::Triangles => indices.as_chunks::<3>().0.to_vec(),
        Mode::TriangleStrip => {
            let strip = indices.windows(3).enumerate();
            strip
                .map(|(i, w)| if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] })
                .collect()
        }
        Mode::TriangleFan => match indices.split_first() {
            Some((&hub, rim)) => rim.windows(2).map(|w| [hub, w[0], w[1]]).collect(),
            None => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// The bounding box.
pub(crate) fn corners<'p>(points: impl Iterator<Item = &'p [f64; 3]>) -> [[f64; 3]; 2] {
    points.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], point| {
        [[0, 1, 2].map(|c| low[c].min(point[c])), [0, 1, 2].map(|c| high[c].max(point[c]))]
    })
}
