//! Skins and meshes in vertices of several fields: what the C functions give is what those on arrays give, and
//! nothing else is written. Buffers are on the heap, with just the length that is said (`skins.rs` says why).

#[path = "support/pose.rs"]
mod pose;

use dq8::DualQuat;
use dq8_capi::Status;
use dq8_capi::mesh::VertexFields;
use dq8_capi::skin::{InfluenceField, Skin};
use dq8_capi::skinning::single as c;
use pose::{How, Pointers, pose};
use std::mem::MaybeUninit;
use std::ptr;

const JOINTS: usize = 3;
const INFLUENCES: usize = 4;
const VERTICES: usize = 19;

/// As an engine might have it: 16 numbers of 4 bytes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
struct Vertex {
    color: u32,
    position: [f32; 3],
    normal: [f32; 3],
    tangent: [f32; 3],
    joints: [u16; INFLUENCES],
    weights: [f32; INFLUENCES],
}

const STRIDE: usize = size_of::<Vertex>() / size_of::<f32>();
const ALL: VertexFields = VertexFields { stride: STRIDE, position: 1, normal: 4, tangent: 7 };
const JOINTS_AT: InfluenceField = InfluenceField { stride: 2 * STRIDE, first: 2 * 10 };
const WEIGHTS_AT: InfluenceField = InfluenceField { stride: STRIDE, first: 12 };

fn unit(seed: usize) -> [f32; 3] {
    let angle = seed as f32;
    [angle.cos(), 0.6 * angle.sin(), 0.8 * angle.sin()]
}

struct Scene {
    vertices: Box<[Vertex]>,
    motions: Box<[DualQuat<f32>]>,
    matrices: Box<[[[f32; 4]; 3]]>,
}

impl Scene {
    fn new() -> Self {
        let vertex = |i: usize| Vertex {
            color: 0xff00_0000 + i as u32,
            position: unit(i).map(|c| 3.0 * c),
            normal: unit(i + 100),
            tangent: unit(i + 200),
            joints: [0, 1, 2, 3].map(|influence| ((i + influence) % JOINTS) as u16),
            weights: [0.5, 0.25, 0.125, 0.125],
        };
        let motions: Box<[_]> = (0..JOINTS)
            .map(|i| {
                let [x, y, z] = unit(i + 50);
                DualQuat::from_array([x, y, z, 1.0, i as f32, 0.5, 2.0, -1.0]).normalize()
            })
            .collect();
        let matrices = motions.iter().map(|motion| motion.to_matrix3x4()).collect();
        Self { vertices: (0..VERTICES).map(vertex).collect(), motions, matrices }
    }

    fn numbers(&self) -> *const f32 {
        self.vertices.as_ptr().cast()
    }

    fn make(&self, at: InfluenceField, of: InfluenceField) -> (Status, Skin<f32>, usize) {
        let (mut made, mut bad) = (MaybeUninit::<Skin<f32>>::zeroed(), usize::MAX);
        let (start, room) = (self.numbers(), made.as_mut_ptr());
        // SAFETY: the buffer has the length that is said; a skin is numbers and pointers.
        unsafe {
            let status = c::make_interleaved(
                JOINTS,
                INFLUENCES,
                start.cast(),
                at,
                start,
                of,
                VERTICES,
                room,
                &raw mut bad,
            );
            (status, made.assume_init(), bad)
        }
    }

    /// What the functions on arrays give.
    fn wanted(&self, how: How) -> [Vec<[f32; 3]>; 3] {
        let joints: Vec<_> = self.vertices.iter().flat_map(|vertex| vertex.joints).collect();
        let weights: Vec<_> = self.vertices.iter().flat_map(|vertex| vertex.weights).collect();
        let fields: [fn(&Vertex) -> [f32; 3]; 3] = [|v| v.position, |v| v.normal, |v| v.tangent];
        let rest = fields.map(|field| self.vertices.iter().map(field).collect::<Vec<_>>());
        let mut posed = [(); 3].map(|()| vec![[9.0_f32; 3]; VERTICES]);
        let rest = rest.each_ref().map(|field| field.as_ptr().cast());
        let to = posed.each_mut().map(|field| field.as_mut_ptr().cast());
        let mut made = MaybeUninit::<Skin<f32>>::zeroed();
        let (skin, matrices) = (made.as_mut_ptr(), self.matrices.as_ptr().cast());
        let of = Pointers {
            skin,
            matrices,
            motions: self.motions.as_ptr().cast(),
            stretches: matrices,
            shares: SHARES.as_ptr(),
            rest,
        };
        // SAFETY: arrays have the length that is said.
        let status = unsafe {
            let (of_vertices, by, nowhere) = (joints.as_ptr(), weights.as_ptr(), ptr::null_mut());
            let status = c::make(JOINTS, INFLUENCES, of_vertices, by, VERTICES, skin, nowhere);
            assert_eq!(status, Status::Ok);
            pose(how, JOINTS, of, to, VERTICES)
        };
        assert_eq!(status, Status::Ok);
        posed
    }

    /// # Safety
    /// `rest` and `posed` are so many vertices, or wrong in ways that are seen.
    unsafe fn pose(
        &self,
        how: How,
        skin: *const Skin<f32>,
        (rest, from): (*const f32, VertexFields),
        (posed, to): (*mut f32, VertexFields),
        vertices: usize,
    ) -> Status {
        let (motions, matrices) = (self.motions.as_ptr().cast(), self.matrices.as_ptr().cast());
        // SAFETY: promised.
        unsafe {
            match how {
                How::Linear => {
                    c::linear_interleaved(skin, matrices, JOINTS, rest, from, posed, to, vertices)
                }
                How::Dual => {
                    c::dual_interleaved(skin, motions, JOINTS, rest, from, posed, to, vertices)
                }
                How::Stretched => c::stretched_interleaved(
                    skin, motions, matrices, JOINTS, rest, from, posed, to, vertices,
                ),
                How::Mixed => {
                    let shares = SHARES.as_ptr();
                    c::mixed_interleaved(
                        skin, matrices, motions, shares, JOINTS, rest, from, posed, to, vertices,
                    )
                }
            }
        }
    }
}

const SHARES: [f32; VERTICES] = [0.25; VERTICES];

#[test]
fn vertices_of_several_fields_are_posed_as_arrays_are_and_nothing_else_is_written() {
    let scene = Scene::new();
    let (status, skin, bad) = scene.make(JOINTS_AT, WEIGHTS_AT);
    assert_eq!((status, bad), (Status::Ok, usize::MAX));
    assert_eq!((skin.vertices, skin.influences, skin.joints), (VERTICES, INFLUENCES, JOINTS));
    for how in How::ALL {
        let [positions, normals, tangents] = scene.wanted(how);
        let blank = Vertex {
            color: 7,
            position: [9.0; 3],
            normal: [9.0; 3],
            tangent: [9.0; 3],
            joints: [8; INFLUENCES],
            weights: [5.0; INFLUENCES],
        };
        for all in [true, false] {
            let mut posed = vec![blank; VERTICES].into_boxed_slice();
            let fields = if all { ALL } else { VertexFields { normal: -1, tangent: -1, ..ALL } };
            let (from, to) =
                ((scene.numbers(), fields), (posed.as_mut_ptr().cast::<f32>(), fields));
            // SAFETY: buffers have the length that is said.
            let status = unsafe { scene.pose(how, &raw const skin, from, to, VERTICES) };
            assert_eq!(status, Status::Ok);
            for (i, vertex) in posed.iter().enumerate() {
                let mut wanted = Vertex { position: positions[i], ..blank };
                if all {
                    (wanted.normal, wanted.tangent) = (normals[i], tangents[i]);
                }
                assert_eq!(*vertex, wanted, "{how:?}, vertex {i}");
            }
        }
    }
}

#[test]
fn what_is_posed_may_lie_in_other_places_than_what_is_at_rest() {
    let scene = Scene::new();
    let (_, skin, _) = scene.make(JOINTS_AT, WEIGHTS_AT);
    let [positions, normals, _] = scene.wanted(How::Dual);
    let mut posed = vec![[9.0_f32; 7]; VERTICES].into_boxed_slice();
    let from = VertexFields { tangent: -1, ..ALL };
    let to = VertexFields { stride: 7, position: 4, normal: 0, tangent: -1 };
    let (from, to) = ((scene.numbers(), from), (posed.as_mut_ptr().cast(), to));
    // SAFETY: buffers have the length that is said.
    let status = unsafe { scene.pose(How::Dual, &raw const skin, from, to, VERTICES) };
    assert_eq!(status, Status::Ok);
    for (i, [x, y, z, between, rest @ ..]) in posed.iter().enumerate() {
        assert_eq!(([*x, *y, *z], *between, *rest), (normals[i], 9.0, positions[i]), "vertex {i}");
    }
}

#[test]
fn fields_that_do_not_lie_in_a_vertex_are_refused() {
    let mut scene = Scene::new();
    let beyond = [
        InfluenceField { first: 2 * STRIDE - INFLUENCES + 1, ..JOINTS_AT },
        InfluenceField { stride: INFLUENCES - 1, first: 0 },
        InfluenceField { stride: INFLUENCES, first: usize::MAX },
    ];
    for at in beyond {
        assert_eq!(scene.make(at, WEIGHTS_AT).0, Status::Field, "{at:?}");
    }
    let last = InfluenceField { stride: STRIDE, first: STRIDE - INFLUENCES + 1 };
    assert_eq!(scene.make(JOINTS_AT, last).0, Status::Field);
    let huge = InfluenceField { stride: usize::MAX, first: 0 };
    assert_eq!(scene.make(huge, WEIGHTS_AT).0, Status::TooLarge);
    let (_, skin, _) = scene.make(JOINTS_AT, WEIGHTS_AT);
    let mut posed = scene.vertices.clone();
    let untouched = posed.clone();
    let to: *mut f32 = posed.as_mut_ptr().cast();
    for (fields, wanted) in [
        (VertexFields { position: STRIDE as i32 - 2, ..ALL }, Status::Field),
        (VertexFields { position: -1, ..ALL }, Status::Field),
        (VertexFields { normal: -2, ..ALL }, Status::Field),
        (VertexFields { tangent: 6, ..ALL }, Status::Field),
        (VertexFields { stride: 2, ..ALL }, Status::Field),
        (VertexFields { stride: usize::MAX, ..ALL }, Status::TooLarge),
        (VertexFields { normal: -1, ..ALL }, Status::Length),
    ] {
        // SAFETY: fields are wrong in ways that are seen.
        unsafe {
            let good = (scene.numbers(), ALL);
            let status = scene.pose(How::Linear, &raw const skin, good, (to, fields), VERTICES);
            assert_eq!(status, wanted, "to {fields:?}");
            let from = (scene.numbers(), fields);
            let status = scene.pose(How::Dual, &raw const skin, from, (to, ALL), VERTICES);
            assert_eq!(status, wanted, "from {fields:?}");
        }
    }
    assert_eq!(posed, untouched);
    scene.vertices[5].joints[2] = 3;
    let (status, _, bad) = scene.make(JOINTS_AT, WEIGHTS_AT);
    assert_eq!((status, bad), (Status::JointOutOfRange, 5));
}

#[test]
fn buffers_that_are_wrong_are_refused_and_nothing_is_written() {
    let scene = Scene::new();
    let (_, skin, _) = scene.make(JOINTS_AT, WEIGHTS_AT);
    // SAFETY: a skin is numbers and pointers.
    let unmade: Skin<f32> = unsafe { MaybeUninit::zeroed().assume_init() };
    let mut posed = scene.vertices.clone();
    let to: *mut f32 = posed.as_mut_ptr().cast();
    let (from, made) = (scene.numbers(), &raw const skin);
    for how in How::ALL {
        let refused = |skin, from, to, vertices, wanted| {
            // SAFETY: buffers have the length that is said, or pointers are wrong in ways that are seen.
            let status = unsafe { scene.pose(how, skin, (from, ALL), (to, ALL), vertices) };
            assert_eq!(status, wanted, "{how:?}");
        };
        refused(&raw const unmade, from, to, VERTICES, Status::NoSkin);
        refused(ptr::null(), from, to, VERTICES, Status::NullPointer);
        refused(made, ptr::null(), to, VERTICES, Status::NullPointer);
        refused(made, from, ptr::null_mut(), VERTICES, Status::NullPointer);
        refused(made, from.wrapping_byte_add(2), to, VERTICES, Status::Misaligned);
        refused(made, from, to.wrapping_byte_add(2), VERTICES, Status::Misaligned);
        refused(made, from, to, VERTICES - 1, Status::Length);
        refused(made, from, to, usize::MAX, Status::TooLarge);
        // The joints and weights of the skin lie there too.
        refused(made, to, from.cast_mut(), VERTICES, Status::Overlap);
        refused(made, to, to, VERTICES, Status::Overlap);
        refused(made, from, made.cast_mut().cast(), VERTICES, Status::Overlap);
    }
    assert_eq!(posed, scene.vertices);
}
