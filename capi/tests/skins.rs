//! Skins: what the C functions make is what the Rust ones make, number for number; what is wrong has an error of its
//! own, and nothing is written. Arrays have just the length that is said, so that the address sanitizer sees
//! a number read or written beyond (how to run it: `fuzz.rs`).

#[path = "support/pose.rs"]
mod pose;

use dq8::skinning::{
    self, DualBlend, Linear, Mixed, StretchedDualBlend, Surface, SurfaceMut, matrix_palette,
    split_palette,
};
use dq8::{DualQuat, Quat, hierarchy::MatrixOrder};
use dq8_capi::Status;
use dq8_capi::palette::single as p;
use dq8_capi::skin::Skin;
use dq8_capi::skinning::single as c;
use pose::{How, Pointers, pose};
use std::mem::MaybeUninit;
use std::ptr;

const JOINTS: usize = 5;

/// A mesh of `vertices`, all of it on the heap.
struct Mesh {
    influences: usize,
    joints: Box<[u16]>,
    weights: Box<[f32]>,
    /// Positions, normals, tangents.
    rest: [Box<[[f32; 3]]>; 3],
    models: Box<[[[f32; 4]; 4]]>,
    matrices: Box<[[[f32; 4]; 3]]>,
    motions: Box<[DualQuat<f32>]>,
    stretches: Box<[[[f32; 4]; 3]]>,
    shares: Box<[f32]>,
}

fn wave(i: usize, seed: f32) -> f32 {
    (i as f32 * 1.7 + seed).sin()
}

impl Mesh {
    fn new(vertices: usize, influences: usize) -> Self {
        let count = vertices * influences;
        let vectors = |seed: f32| {
            (0..vertices).map(|i| [0.0, 1.0, 2.0].map(|more| wave(i, seed + more))).collect()
        };
        let model = |i: usize| {
            let turn = Quat::from_array([0.1, 0.9, 2.0, 3.3].map(|more| wave(i, more)));
            let at = [wave(i, 7.0), wave(i, 8.0), 2.0];
            let [mut x, y, z] =
                DualQuat::from_rotation_translation(turn.normalize(), at).to_matrix3x4();
            x[0] *= 1.5;
            [x, y, z, [0.0, 0.0, 0.0, 1.0]]
        };
        let models: Box<[_]> = (0..JOINTS).map(model).collect();
        let mut matrices = vec![[[0.0; 4]; 3]; JOINTS].into_boxed_slice();
        let mut motions = vec![DualQuat::IDENTITY; JOINTS].into_boxed_slice();
        let mut stretches = matrices.clone();
        matrix_palette(&models, &models, MatrixOrder::Rows, &mut matrices).unwrap();
        split_palette(&matrices, &mut motions, &mut stretches).unwrap();
        Self {
            influences,
            joints: (0..count).map(|i| (i * 7 % JOINTS) as u16).collect(),
            weights: (0..count).map(|i| (1.0 + wave(i, 0.5)) / influences as f32).collect(),
            rest: [vectors(1.0), vectors(2.0), vectors(3.0)],
            models,
            matrices,
            motions,
            stretches,
            shares: (0..vertices).map(|i| wave(i, 0.2).abs()).collect(),
        }
    }

    fn vertices(&self) -> usize {
        self.rest[0].len()
    }

    fn make(&self, bad: &mut usize) -> (Status, Skin<f32>) {
        let mut made = MaybeUninit::<Skin<f32>>::zeroed();
        let (of, by) = (self.joints.as_ptr(), self.weights.as_ptr());
        // SAFETY: arrays have the length that is said; a skin is numbers and pointers.
        unsafe {
            let room = made.as_mut_ptr();
            let status = c::make(JOINTS, self.influences, of, by, self.vertices(), room, bad);
            (status, made.assume_init())
        }
    }

    /// What Rust makes of positions, normals and tangents.
    fn wanted(&self, how: How, all: bool) -> [Vec<[f32; 3]>; 3] {
        let skin =
            skinning::Skin::new(JOINTS, self.influences, &self.joints, &self.weights).unwrap();
        let [positions, normals, tangents] = &self.rest;
        let mut posed = [(); 3].map(|()| vec![[9.0; 3]; self.vertices()]);
        let [p, n, t] = &mut posed;
        let (mut from, mut to) = (Surface::positions(positions), SurfaceMut::positions(p));
        if all {
            from = from.normals(normals).tangents(tangents);
            to = to.normals(n).tangents(t);
        }
        let (linear, dual) = (Linear::new(&self.matrices), DualBlend::new(&self.motions));
        let stretched = StretchedDualBlend::new(&self.motions, &self.stretches);
        let mixed = Mixed::new(linear, dual, &self.shares).unwrap();
        match how {
            How::Linear => skin.pose(linear, from, to),
            How::Dual => skin.pose(dual, from, to),
            How::Stretched => skin.pose(stretched, from, to),
            How::Mixed => skin.pose(mixed, from, to),
        }
        .unwrap();
        posed
    }

    /// The pointers of a call: skin, matrices, motions, three of the mesh at rest.
    fn pointers(&self, skin: &Skin<f32>) -> Pointers {
        let [positions, normals, tangents] = self.rest.each_ref().map(|one| one.as_ptr().cast());
        Pointers {
            skin: ptr::from_ref(skin),
            matrices: self.matrices.as_ptr().cast(),
            motions: self.motions.as_ptr().cast(),
            stretches: self.stretches.as_ptr().cast(),
            shares: self.shares.as_ptr(),
            rest: [positions, normals, tangents],
        }
    }
}

/// What it poses by.
fn palettes(how: How) -> &'static [fn(&mut Pointers) -> &mut *const f32] {
    match how {
        How::Linear => &[|of| &mut of.matrices],
        How::Dual => &[|of| &mut of.motions],
        How::Stretched => &[|of| &mut of.motions, |of| &mut of.stretches],
        How::Mixed => &[|of| &mut of.matrices, |of| &mut of.motions, |of| &mut of.shares],
    }
}

#[test]
fn every_function_gives_what_the_rust_one_gives() {
    for (vertices, influences) in [(1, 4), (17, 4), (40, 1), (33, 3), (16, 8), (21, 9)] {
        let mesh = Mesh::new(vertices, influences);
        let (status, skin) = mesh.make(&mut 0);
        assert_eq!(status, Status::Ok);
        assert_eq!((skin.vertices, skin.influences, skin.joints), (vertices, influences, JOINTS));
        // It may be moved.
        let moved = Box::new(skin);
        for how in How::ALL {
            for all in [false, true] {
                let mut got = [(); 3].map(|()| vec![[9.0; 3]; vertices].into_boxed_slice());
                let mut to = got.each_mut().map(|one| one.as_mut_ptr().cast());
                let mut of = mesh.pointers(&moved);
                if !all {
                    (of.rest[1], of.rest[2], to[1], to[2]) =
                        (ptr::null(), ptr::null(), ptr::null_mut(), ptr::null_mut());
                }
                // SAFETY: arrays have the length that is said.
                assert_eq!(unsafe { pose(how, JOINTS, of, to, vertices) }, Status::Ok);
                let wanted = mesh.wanted(how, all);
                assert_eq!(got.map(Vec::from), wanted, "{vertices} {influences} {how:?}");
            }
        }
    }
}

#[test]
fn palettes_are_those_of_rust() {
    let mesh = Mesh::new(1, 1);
    let (models, mut binds) = (mesh.models.as_ptr().cast(), mesh.models.clone());
    binds.reverse();
    let binds_start = binds.as_ptr().cast();
    let mut matrices = vec![[[9.0; 4]; 3]; JOINTS].into_boxed_slice();
    let mut motions = vec![DualQuat::ZERO; JOINTS].into_boxed_slice();
    let mut stretches = matrices.clone();
    let mut wanted = matrices.clone();
    matrix_palette(&mesh.models, &binds, MatrixOrder::Rows, &mut wanted).unwrap();
    let [a, b, d] = [
        matrices.as_mut_ptr().cast::<f32>(),
        motions.as_mut_ptr().cast(),
        stretches.as_mut_ptr().cast(),
    ];
    let (null, nowhere) = (ptr::null(), ptr::null_mut());
    // SAFETY: arrays have the length that is said.
    unsafe {
        let products = |of, by, order, to| p::products(of, by, order, to, JOINTS);
        assert_eq!(products(models, binds_start, 2, a), Status::UnknownValue);
        // Rows given as columns have the translation in the last row.
        assert_eq!(products(models, binds_start, 1, a), Status::NotAffine);
        for input in [models, binds_start] {
            assert_eq!(products(models, binds_start, 0, input.cast_mut()), Status::Overlap);
        }
        assert_eq!(products(null, binds_start, 0, a), Status::NullPointer);
        assert_eq!(products(models, null, 0, a), Status::NullPointer);
        assert_eq!(products(models, binds_start, 0, nowhere), Status::NullPointer);
        assert!(matrices.as_flattened().iter().all(|row| *row == [9.0; 4]));
        assert_eq!(products(models, binds_start, 0, a), Status::Ok);
        assert_eq!(matrices, wanted);
        assert_eq!(products(models, models, 0, a), Status::Ok);
        let split = |of, motions, stretches| p::split(of, motions, stretches, JOINTS);
        for (of, motions, stretches) in [(a, b, b), (a, a, d), (a, b, a)] {
            assert_eq!(split(of, motions, stretches), Status::Overlap);
        }
        for (of, motions, stretches) in [(nowhere, b, d), (a, nowhere, d), (a, b, nowhere)] {
            assert_eq!(split(of, motions, stretches), Status::NullPointer);
        }
        assert!(motions.iter().all(|&motion| motion == DualQuat::ZERO));
        assert!(stretches.as_flattened().iter().all(|row| *row == [9.0; 4]));
        assert_eq!(split(a, b, d), Status::Ok);
        assert_eq!((&motions, &stretches), (&mesh.motions, &mesh.stretches));
        a.write(f32::NAN);
        assert_eq!(split(a, b, d), Status::NotFinite);
    }
}

#[test]
fn a_skin_that_is_wrong_names_its_vertex() {
    let wrong = |change: fn(&mut Mesh)| {
        let mut mesh = Mesh::new(6, 4);
        change(&mut mesh);
        let mut bad = usize::MAX;
        let (status, made) = mesh.make(&mut bad);
        assert_eq!(made.influences, if status == Status::Ok { 4 } else { 0 }, "{status:?}");
        (status, (bad != usize::MAX).then_some(bad))
    };
    assert_eq!(wrong(|_| ()), (Status::Ok, None));
    assert_eq!(wrong(|m| m.joints[9] = 5), (Status::JointOutOfRange, Some(2)));
    assert_eq!(wrong(|m| m.weights[13] = -0.1), (Status::Weight, Some(3)));
    assert_eq!(wrong(|m| m.weights[13] = f32::NAN), (Status::Weight, Some(3)));
    assert_eq!(wrong(|m| m.weights[20..].fill(0.0)), (Status::WeightSum, Some(5)));
    assert_eq!(wrong(|m| m.influences = 0), (Status::NoInfluences, None));
}

#[test]
fn a_skin_is_made_apart_from_what_it_is_made_of() {
    // Joints that are all the first one, in memory that an index or a skin may lie in.
    // Two weights of a quarter in each number.
    let (mut joints, mut weights) = ([0_usize; 16], [f64::from_bits(0x3e80_0000_3e80_0000); 16]);
    let mut made = MaybeUninit::<Skin<f32>>::zeroed();
    let (of, by) = (joints.as_mut_ptr(), weights.as_mut_ptr());
    let (skin, mut bad) = (made.as_mut_ptr(), 7_usize);
    let make = |of: *mut usize, by: *mut f64, skin, bad| {
        // SAFETY: arrays have the length that is said, or pointers are wrong in ways that are seen.
        unsafe { c::make(JOINTS, 4, of.cast(), by.cast(), 6, skin, bad) }
    };
    let index = &raw mut bad;
    for (skin, bad) in [
        (of.cast(), index),
        (by.cast(), index),
        (skin, of),
        (skin, by.cast()),
        (skin, skin.cast::<usize>()),
    ] {
        assert_eq!(make(of, by, skin, bad), Status::Overlap);
    }
    assert_eq!(make(ptr::null_mut(), by, skin, index), Status::NullPointer);
    assert_eq!(make(of, ptr::null_mut(), skin, index), Status::NullPointer);
    assert_eq!(make(of, by, ptr::null_mut(), index), Status::NullPointer);
    // SAFETY: a skin is numbers and pointers.
    assert_eq!(unsafe { made.assume_init() }.influences, 0);
    assert_eq!(make(of, by, skin, ptr::null_mut()), Status::Ok);
    assert_eq!((joints, bad), ([0; 16], 7));
}

#[test]
fn pointers_that_are_wrong_are_refused_and_nothing_is_written() {
    let mesh = Mesh::new(19, 4);
    let (_, skin) = mesh.make(&mut 0);
    let good = mesh.pointers(&skin);
    let mut posed = [(); 3].map(|()| vec![[9.0_f32; 3]; 19].into_boxed_slice());
    let to: [*mut f32; 3] = posed.each_mut().map(|one| one.as_mut_ptr().cast());
    // SAFETY: a skin is numbers and pointers.
    let unmade: Skin<f32> = unsafe { MaybeUninit::zeroed().assume_init() };
    let null = ptr::null::<f32>();
    for how in How::ALL {
        let refused = |of: Pointers, to, joints, vertices, wanted| {
            // SAFETY: arrays have the length that is said, or pointers are wrong in ways that are seen.
            assert_eq!(unsafe { pose(how, joints, of, to, vertices) }, wanted, "{how:?}");
        };
        refused(Pointers { skin: null.cast(), ..good }, to, JOINTS, 19, Status::NullPointer);
        refused(Pointers { skin: &raw const unmade, ..good }, to, JOINTS, 19, Status::NoSkin);
        refused(good, to, JOINTS - 1, 19, Status::Length);
        refused(good, to, JOINTS, 18, Status::Length);
        let odd = |start: *const f32| start.wrapping_byte_add(2);
        for palette in palettes(how) {
            let mut of = good;
            *palette(&mut of) = null;
            refused(of, to, JOINTS, 19, Status::NullPointer);
            *palette(&mut of) = odd(*palette(&mut { good }));
            refused(of, to, JOINTS, 19, Status::Misaligned);
            for kind in 0..3 {
                let mut over = to;
                over[kind] = palette(&mut { good }).cast_mut();
                refused(good, over, JOINTS, 19, Status::Overlap);
            }
        }
        for kind in 0..3 {
            let mut of = good;
            of.rest[kind] = null;
            refused(of, to, JOINTS, 19, Status::NullPointer);
            of.rest[kind] = odd(good.rest[kind]);
            refused(of, to, JOINTS, 19, Status::Misaligned);
            let mut nowhere = to;
            nowhere[kind] = ptr::null_mut();
            refused(good, nowhere, JOINTS, 19, Status::NullPointer);
            let inputs = [
                good.skin.cast::<f32>(),
                mesh.joints.as_ptr().cast(),
                mesh.weights.as_ptr(),
                good.rest[0],
                good.rest[1],
                good.rest[2],
                to[(kind + 1) % 3],
            ];
            for input in inputs {
                let mut over = to;
                over[kind] = input.cast_mut();
                refused(good, over, JOINTS, 19, Status::Overlap);
            }
        }
    }
    assert!(posed.iter().flatten().flatten().all(|&number| number == 9.0));
}

/// C sees them, and may write them.
#[test]
fn the_numbers_that_a_skin_shows_do_not_decide_what_it_reads() {
    let mut mesh = Mesh::new(19, 4);
    let (_, mut skin) = mesh.make(&mut 0);
    let (joints, weights) = (mesh.joints.as_mut_ptr().cast(), mesh.weights.as_mut_ptr());
    for vertices in [0, 1, 18, usize::MAX] {
        (skin.vertices, skin.joints) = (vertices, vertices);
        let good = mesh.pointers(&skin);
        for how in How::ALL {
            let mut posed = [(); 3].map(|()| vec![[9.0_f32; 3]; 19].into_boxed_slice());
            let to = posed.each_mut().map(|one| one.as_mut_ptr().cast());
            for kind in 0..3 {
                for over in [joints, weights] {
                    let mut over_it = to;
                    over_it[kind] = over;
                    // SAFETY: what lies over an input is refused.
                    let status = unsafe { pose(how, JOINTS, good, over_it, 19) };
                    assert_eq!(status, Status::Overlap, "{vertices} {how:?}");
                }
            }
            // SAFETY: arrays have the length that is said.
            assert_eq!(unsafe { pose(how, JOINTS, good, to, 19) }, Status::Ok);
            assert_eq!(posed.map(Vec::from), mesh.wanted(how, true), "{vertices} {how:?}");
        }
    }
}

#[test]
fn shares_that_are_none_or_too_few_are_refused_and_nothing_is_written() {
    let mut mesh = Mesh::new(19, 4);
    let (_, skin) = mesh.make(&mut 0);
    let none = [-0.1, 1.1, f32::NAN, f32::INFINITY].map(|share| (share, 19, Status::Share));
    for (share, shares, wanted) in none.into_iter().chain([(0.5, 18, Status::Length)]) {
        mesh.shares = vec![share; shares].into();
        let mut posed = [[[9.0_f32; 3]; 19]; 3];
        let to = posed.each_mut().map(|one| one.as_mut_ptr().cast());
        // SAFETY: arrays have the length that is said.
        let status = unsafe { pose(How::Mixed, JOINTS, mesh.pointers(&skin), to, shares) };
        assert_eq!((status, posed), (wanted, [[[9.0; 3]; 19]; 3]), "{share} {shares}");
    }
}

#[test]
fn in_double_precision_too() {
    use dq8_capi::skinning::double as d;
    let (joints, weights) = ([0_u16, 1, 0, 1], [1.0_f64, 0.0, 0.25, 0.75]);
    let motions = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f64, 0.0, 4.0])];
    let (rest, mut posed) = ([[1.0_f64, 2.0, 3.0]; 2], [[0.0_f64; 3]; 2]);
    let mut made = MaybeUninit::<Skin<f64>>::zeroed();
    let (none, nowhere) = (ptr::null(), ptr::null_mut());
    // SAFETY: arrays have the length that is said.
    unsafe {
        let (of, by, room) = (joints.as_ptr(), weights.as_ptr(), made.as_mut_ptr());
        assert_eq!(d::make(2, 2, of, by, 2, room, ptr::null_mut()), Status::Ok);
        let (by, from, to) =
            (motions.as_ptr().cast(), rest.as_ptr().cast(), posed.as_mut_ptr().cast());
        let status = d::dual(room, by, 2, from, none, none, to, nowhere, nowhere, 2);
        assert_eq!(status, Status::Ok);
    }
    assert_eq!(posed, [[1.0, 2.0, 3.0], [1.0, 2.0, 6.0]]);
}
