//! Skins, meshes that follow them in arrays and in vertices of several fields, and palettes.

use super::memory;
use crate::argument::{Of, Read, count, names, passes, reads, writes};
use crate::element::{Element, record, wave, zeroed};
use crate::function::Function;
use crate::shape::Shape;
use dq8::hierarchy::MatrixOrder;
use dq8::skinning::{
    self, Blender, DualBlend, Linear, Mixed, SkinningError, StretchedDualBlend, Surface,
    SurfaceMut, matrix_palette, split_palette,
};
use dq8::{DualQuat, Real, Scalar};
use dq8_capi::mesh::VertexFields;
use dq8_capi::skin::{InfluenceField, Skin};
use dq8_capi::{Status, palette, skinning as c};
use std::rc::Rc;

/// Joints of a palette.
const JOINTS: usize = 5;

/// A skin in C, and what it is made of.
struct Scene<R> {
    indices: Vec<u16>,
    weights: Vec<R>,
    made: Skin<R>,
    influences: usize,
}

macro_rules! scenes {
    ($($R:ident $of:ident)*) => {$(
        impl Scene<$R> {
            fn $of(shape: &Shape) -> Rc<Self> {
                let (vertices, influences) = (shape.vertices, shape.influences);
                let n = vertices * influences;
                let indices: Vec<_> = (0..n).map(|at| (at * 7 % JOINTS) as u16).collect();
                let weight = |at| (1.0 + wave::<$R>(at, 1)) / influences as $R;
                let (weights, mut made): (Vec<_>, _) = ((0..n).map(weight).collect(), zeroed());
                // SAFETY: arrays are as long as is said.
                let status = unsafe {
                    let (of, by) = (indices.as_ptr(), weights.as_ptr());
                    c::$of::make(JOINTS, influences, of, by, vertices, &raw mut made, std::ptr::null_mut())
                };
                assert_eq!(status, Status::Ok);
                // C sees them, and may write them: they do not decide what is read.
                (made.vertices, made.joints) = (usize::MAX, 0);
                Rc::new(Self { indices, weights, made, influences })
            }
        }
    )*};
}
scenes! { f32 single f64 double }

impl<R: Scalar + skinning::Weight> Scene<R>
where
    Skin<R>: Element,
{
    fn argument(self: &Rc<Self>) -> Of<Skin<R>, Read> {
        let scene = Rc::clone(self);
        let kept = [memory(&self.indices), memory(&self.weights)];
        reads(1)
            .keeps(kept.into_iter().filter(|(_, bytes)| *bytes > 0).collect())
            .only(move |_| scene.made)
            .fault(Status::NoSkin, None, |made| made[0] = zeroed())
    }
    fn pose<B: Blender<R>>(
        &self,
        blend: Result<B, SkinningError>,
        [positions, normals, tangents]: [&[[R; 3]]; 3],
        [to, to_normals, to_tangents]: [&mut [[R; 3]]; 3],
    ) -> Result<(), SkinningError> {
        let skin = skinning::Skin::new(JOINTS, self.influences, &self.indices, &self.weights)?;
        let (mut rest, mut posed) = (Surface::positions(positions), SurfaceMut::positions(to));
        if !normals.is_empty() {
            (rest, posed) = (rest.normals(normals), posed.normals(to_normals));
        }
        if !tangents.is_empty() {
            (rest, posed) = (rest.tangents(tangents), posed.tangents(to_tangents));
        }
        skin.pose(blend?, rest, posed)
    }
    /// The same by way of arrays.
    fn pose_records<B: Blender<R>>(
        &self,
        blend: Result<B, SkinningError>,
        (rest, from): (&[R], VertexFields),
        (posed, to): (&mut [R], VertexFields),
    ) -> Result<(), SkinningError> {
        let fields = |of: VertexFields| {
            [of.position, of.normal, of.tangent].map(|at| usize::try_from(at).ok())
        };
        let gathered = fields(from).map(|at| {
            let three = |vertex: &[R]| at.map(|at| std::array::from_fn(|c| vertex[at + c]));
            rest.chunks_exact(from.stride).filter_map(three).collect::<Vec<[R; 3]>>()
        });
        let mut to_arrays = gathered.clone();
        self.pose(
            blend,
            gathered.each_ref().map(|all| &all[..]),
            to_arrays.each_mut().map(|all| &mut all[..]),
        )?;
        for (at, all) in fields(to).into_iter().zip(&to_arrays) {
            for (vertex, moved) in posed.chunks_exact_mut(to.stride).zip(all) {
                at.into_iter().for_each(|at| vertex[at..at + 3].copy_from_slice(moved));
            }
        }
        Ok(())
    }
}

/// Vertices of positions, normals and tangents, and something more.
fn vertices(shape: &Shape, stride: usize, position: i32) -> VertexFields {
    let other = |first, is_there| if is_there { (position + first) % 9 } else { -1 };
    VertexFields {
        stride,
        position,
        normal: other(3, shape.normals),
        tangent: other(6, shape.tangents),
    }
}

/// Fields that are refused: beyond the vertex, in another field, or not in the other buffer too.
fn fields(fields: VertexFields, count: usize) -> crate::argument::Passed<VertexFields> {
    let (one, end) = (fields.position, fields.stride as i32);
    let toggled = if fields.normal < 0 { (one + 3) % 9 } else { -1 };
    passes(fields)
        .wrong(VertexFields { position: end - 2, ..fields }, Status::Field)
        .wrong(VertexFields { position: -1, ..fields }, Status::Field)
        .wrong(VertexFields { normal: -2, ..fields }, Status::Field)
        .wrong(VertexFields { tangent: one + 1, ..fields }, Status::Field)
        .wrong(VertexFields { stride: 2, ..fields }, Status::Field)
        .wrong_if(count > 1, VertexFields { stride: usize::MAX, ..fields }, Status::TooLarge)
        .wrong_if(count > 0, VertexFields { normal: toggled, ..fields }, Status::Fields)
}

/// One that scales, in the order of the shape.
fn matrix<R: Real>(at: usize, order: i32) -> [[R; 4]; 4] {
    let mut rows = DualQuat::from_array(record::<R, 8>(at, 2)).to_matrix4();
    rows[0][0] *= R::from_f64(1.5);
    if order == 0 { rows } else { std::array::from_fn(|row| std::array::from_fn(|c| rows[c][row])) }
}

fn influences(
    field: InfluenceField,
    count: usize,
    vertices: usize,
) -> crate::argument::Passed<InfluenceField> {
    let InfluenceField { stride, first } = field;
    passes(field)
        .wrong(InfluenceField { stride, first: stride - count + 1 }, Status::Field)
        .wrong(InfluenceField { stride: count - 1, first: 0 }, Status::Field)
        .wrong(InfluenceField { stride, first: usize::MAX }, Status::Field)
        .wrong_if(vertices > 1, InfluenceField { stride: usize::MAX, first }, Status::TooLarge)
}

macro_rules! add {
    ($shape:ident $list:ident $R:ident $of:ident) => {{
        type Matrix = [[$R; 4]; 3];
        let scene = Scene::<$R>::$of($shape);
        let (n, order) = ($shape.vertices, $shape.order);
        let each = $shape.influences;
        let [first, second] = [(); 2].map(|()| scene.clone());
        let [third, fourth] = [(); 2].map(|()| scene.clone());
        let (normal, tangent) = (if $shape.normals { n } else { 0 }, if $shape.tangents { n } else { 0 });
        let (from, to) = (vertices($shape, 10, 0), vertices($shape, 11, 3));
        let vector = |of: usize| reads::<[$R; 3]>(of);
        let moved = |of: usize| writes::<[$R; 3]>(of);
        let joints = || count(JOINTS).wrong(JOINTS - 1, Status::LengthJoints);
        let all = || count(n).wrong_if(n > 0, n.saturating_sub(1), Status::LengthVertices);
        let matrices = || reads::<Matrix>(JOINTS);
        let motions = || reads::<DualQuat<$R>>(JOINTS);
        let shares = || {
            let any = $shape.any % n.max(1);
            [-0.1, 1.1, <$R>::NAN, <$R>::INFINITY].into_iter().fold(
                reads::<$R>(n).only(|at| wave::<$R>(at, 2).abs()),
                |shares, none| shares.fault(Status::Share, None, move |shares| shares[any] = none),
            )
        };
        let packed = InfluenceField { stride: each, first: 0 };
        let joint_field = InfluenceField { stride: each + 3, first: 2 };
        let weight_field = InfluenceField { stride: each + 1, first: 1 };
        let any = $shape.any % n.max(1);
        // Between others, which are none.
        let (index, weight) = (
            move |at: usize| match (at % (each + 3), at / (each + 3) * each) {
                (of, vertex) if (2..2 + each).contains(&of) => first.indices[vertex + of - 2],
                _ => 99,
            },
            move |at: usize| match (at % (each + 1), at / (each + 1) * each) {
                (0, _) => <$R>::NAN,
                (of, vertex) => second.weights[vertex + of - 1],
            },
        );
        let indices = |field: InfluenceField, indices: Of<u16, Read>| {
            let at = any * field.stride + field.first;
            indices.fault(Status::JointOutOfRange, Some(any), move |all| all[at] = JOINTS as u16)
        };
        let weights = |field: InfluenceField, weights: Of<$R, Read>| {
            let at = any * field.stride + field.first;
            weights
                .fault(Status::Weight, Some(any), move |all| all[at] = -0.1)
                .fault(Status::Weight, Some(any), move |all| all[at] = <$R>::NAN)
                .fault(Status::WeightSum, Some(any), move |all| all[at..at + each].fill(0.0))
        };
        let made = move |made: &mut Skin<$R>| {
            *made = zeroed();
            (made.vertices, made.influences, made.joints) = (n, each, JOINTS);
        };
        of_numbers! { $list $R $of:
            "skin_" c make (
                joints: passes(JOINTS), influences: passes(each).wrong(0, Status::NoInfluences),
                indices: indices(packed, reads::<u16>(n * each).only(move |at| third.indices[at])),
                weights: weights(packed, reads::<$R>(n * each).only(move |at| fourth.weights[at])),
                vertices: count(n), skin: writes::<Skin<$R>>(1), bad_vertex: names(),
            ) => made(&mut skin[0]);
            "skin_" c make_interleaved (
                joints: passes(JOINTS), influences: passes(each),
                indices: indices(joint_field, reads::<u16>(n * (each + 3)).only(index)),
                joint_field: influences(joint_field, each, n),
                weights: weights(weight_field, reads::<$R>(n * (each + 1)).only(weight)),
                weight_field: influences(weight_field, each, n),
                vertices: count(n), skin: writes::<Skin<$R>>(1), bad_vertex: names(),
            ) => made(&mut skin[0]);
            "skin_" palette products (
                models: reads::<[[$R; 4]; 4]>(JOINTS).only(move |at| matrix(at, order))
                    .fault(Status::NotFinite, None, |all| all[1][0][0] = <$R>::NAN)
                    .fault(Status::NotAffine, None, move |all| if order == 0 { all[2][3][0] = 1.0 } else { all[2][0][3] = 1.0 }),
                binds: reads::<[[$R; 4]; 4]>(JOINTS).only(move |at| matrix(at + 9, order)),
                order: passes(order).wrong(2, Status::UnknownValue).wrong(1 - order, Status::NotAffine),
                matrices: writes::<Matrix>(JOINTS), joints: count(JOINTS),
            ) => {
                let order = if order == 0 { MatrixOrder::Rows } else { MatrixOrder::Columns };
                matrix_palette(models, binds, order, matrices)
            };
            "skin_" palette split (
                matrices: matrices().only(|at| { let [x, y, z, _] = matrix(at, 0); [x, y, z] })
                    .fault(Status::NotFinite, None, |all| all[1][0][0] = <$R>::NAN),
                motions: writes::<DualQuat<$R>>(JOINTS), stretches: writes::<Matrix>(JOINTS), joints: count(JOINTS),
            ) => split_palette(matrices, motions, stretches);
        }
        add! { @poses $list $R $of scene n from to (vector moved joints all normal tangent):
            linear linear_interleaved (matrices: matrices()) Ok(Linear::new(matrices));
            dual dual_interleaved (motions: motions()) Ok(DualBlend::new(motions));
            stretched stretched_interleaved (motions: motions(), stretches: matrices())
                Ok(StretchedDualBlend::new(motions, stretches));
            mixed mixed_interleaved (matrices: matrices(), motions: motions(), shares: shares())
                Mixed::new(Linear::new(matrices), DualBlend::new(motions), shares);
        }
    }};
    (@poses $list:ident $R:ident $of:ident $scene:ident $n:ident $from:ident $to:ident
        ($vector:ident $moved:ident $joints:ident $all:ident $normal:ident $tangent:ident):
        $($name:ident $interleaved:ident ($($palette:ident: $role:expr),*) $blend:expr;)*) => {$(
        let [one, other] = [(); 2].map(|()| $scene.clone());
        of_numbers! { $list $R $of:
            "skin_" c $name (
                skin: $scene.argument(), $($palette: $role,)* joints: $joints(),
                positions: $vector($n), normals: $vector($normal).unless_null(1), tangents: $vector($tangent).unless_null(2),
                posed: $moved($n), posed_normals: $moved($normal).unless_null(1), posed_tangents: $moved($tangent).unless_null(2),
                vertices: $all(),
            ) => one.pose($blend, [positions, normals, tangents], [posed, posed_normals, posed_tangents]);
            "skin_" c $interleaved (
                skin: $scene.argument(), $($palette: $role,)* joints: $joints(),
                rest: reads::<$R>($n * $from.stride), from: fields($from, $n),
                posed: writes::<$R>($n * $to.stride), to: fields($to, $n), vertices: $all(),
            ) => other.pose_records($blend, (rest, from), (posed, to));
        }
    )*};
}

pub(super) fn add(shape: &Shape, to: &mut Vec<Function>) {
    add!(shape to f32 single);
    add!(shape to f64 double);
}
