//! Containers and views of nothing: what can be made of nothing can also be computed; a clip
//! cannot, and has no place.

use dq8::hierarchy::{Clip, Crowd, Plan, Poses, Sampled};
use dq8::law::Nlerp;
use dq8::skinning::{DualBlend, Linear, Mixed, Skin, Surface, SurfaceMut};
use dq8::{DualQuat, Hierarchy, ShapeError, Skeleton};

type Pose = DualQuat<f32>;
const NONE: [Pose; 0] = [];

#[test]
fn a_hierarchy_of_no_joints_and_a_crowd_of_nobody_run() {
    let hierarchy = Hierarchy::new(&[]).unwrap();
    hierarchy.local_to_model(&NONE, &mut []).unwrap();
    hierarchy.job().palette(Poses(&NONE), &mut [], &[], &mut [[0.0; 12]; 0]).unwrap();
    let plan = Plan::new(&hierarchy, &mut [], &mut []).unwrap();
    hierarchy.job().plan(&plan).local_to_model(&NONE, &mut []).unwrap();
    for skeleton in [Skeleton::new(&[0_i32; 0]).unwrap(), Skeleton::sorted(&[0_u32; 0]).unwrap().0]
    {
        skeleton.local_to_model(&NONE, &mut []).unwrap();
        let mut models = NONE;
        skeleton
            .job()
            .palette_and_models(Poses(&NONE), &mut models, &[], &mut [Pose::IDENTITY; 0])
            .unwrap();
    }
    let parents = [Hierarchy::ROOT, 0];
    for (joints, instances, parents) in [(0, 3, &parents[..0]), (2, 0, &parents)] {
        let mut crowd = Crowd::<f32, 8>::new(joints, instances);
        let hierarchy = Hierarchy::new(parents).unwrap();
        hierarchy.job().local_to_model_in_place(crowd.blocks_mut()).unwrap();
        crowd.copy_to_slice(&mut [Pose::IDENTITY; 0]).unwrap();
        assert_eq!(Crowd::<f32, 8>::from_slice(joints, &NONE).unwrap().instances(), 0);
    }
}

#[test]
fn a_clip_of_nothing_is_refused_so_that_each_has_a_place() {
    for joints in [0, 1, 3] {
        let clip = Clip::new(joints, &NONE).map(|clip| clip.frames());
        assert_eq!(clip, Err(ShapeError::Empty { what: "keys" }));
    }
    assert_eq!(ShapeError::Empty { what: "keys" }.to_string(), "keys holds no element");
    // Nobody plays it: that is no fault of the clip.
    let keys = [Pose::IDENTITY; 4];
    let clip = Clip::new(2, &keys).unwrap();
    let locals = Sampled::new(Nlerp, clip, &[], &[0.0_f32; 0]).unwrap();
    Hierarchy::new(&[Hierarchy::ROOT, 0])
        .unwrap()
        .job()
        .locals_to_model(locals, &mut [Pose::IDENTITY; 0])
        .unwrap();
}

#[test]
fn a_mesh_of_no_vertices_is_posed() {
    let skin = Skin::<u16, f32>::new(0, 4, &[], &[]).unwrap();
    let (dual, linear) = (DualBlend::<f32>::new(&[]), Linear::<f32>::new(&[]));
    let mixed = Mixed::new(linear, dual, &[]).unwrap();
    let mut posed = [[0.0_f32; 3]; 0];
    let (rest, posed) = (Surface::positions(&[[0.0_f32; 3]; 0]), SurfaceMut::positions(&mut posed));
    skin.pose(mixed, rest, posed).unwrap();
}
