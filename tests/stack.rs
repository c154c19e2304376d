//! How deep the stack of a debug build gets: without optimisation each value of a kernel, and of
//! what it inlines, has a place of its own. `dq8::guide::firmware` states the bounds that are
//! tested here; an overflow ends the test program.
#![cfg(not(target_family = "wasm"))]

use dq8_contract::stack::{pose, within};

/// The deepest kernels of each room, in plain slices and in the widest blocks.
macro_rules! kernels {
    ($($real:ident, $lanes:literal;)*) => {$(mod $real {
        use super::{pose, within};
        use dq8::hierarchy::{Clip, Layered, Locals, Sampled};
        use dq8::skinning::{DualBlend, Linear, Mixed, Skin, Surface, SurfaceMut};
        use dq8::{Backend, Block, Crowd, DualQuat, Hierarchy, hierarchy::Bones, law::Sclerp};

        const INSTANCES: usize = 37;
        const PARENTS: [u32; 3] = [Hierarchy::ROOT, 0, 1];

        /// Forward to a palette of matrices, and back, in both layouts.
        fn run<L>(backend: Backend, locals: L)
        where
            L: Locals<DualQuat<$real>> + Locals<Block<$real, $lanes>> + Copy,
        {
            let rig = Hierarchy::new(&PARENTS).unwrap();
            let (job, binds) = (rig.job().backend(backend), [pose(); 3]);
            let mut models = vec![pose(); 3 * INSTANCES];
            let mut palette = vec![[[0.0; 4]; 3]; 3 * INSTANCES];
            job.palette_and_models(locals, &mut models, &binds, &mut palette).unwrap();
            job.model_to_local_in_place(&mut models).unwrap();
            let mut models = Crowd::<$real, $lanes>::new(3, INSTANCES);
            let mut palette = Crowd::<$real, $lanes, 12>::new(3, INSTANCES);
            let (job, models) = (rig.job().backend(backend), models.blocks_mut());
            job.palette_and_models(locals, models, &binds, palette.blocks_mut()).unwrap();
            job.model_to_local_in_place(models).unwrap();
        }

        const FRAMES: [u32; INSTANCES] = [1; INSTANCES];
        const T: [$real; INSTANCES] = [0.25; INSTANCES];
        const KEYS: [[$real; 8]; 3 * 4] = [[0.0, 0.0, 0.0, 1.0, 0.5, 0.0, 0.0, 0.0]; 3 * 4];

        #[test]
        fn hierarchies_that_sample_a_clip_need_half_a_mebibyte() {
            within(512, |backend| {
                let clip = Clip::new(3, &KEYS).unwrap();
                run(backend, Sampled::new(Sclerp, clip, &FRAMES, &T).unwrap());
            });
        }

        #[test]
        fn each_layer_along_screws_needs_a_quarter_of_a_mebibyte_more() {
            within(512 + 256, |backend| {
                let clip = Clip::new(3, &KEYS).unwrap();
                let walk = Sampled::new(Sclerp, clip, &FRAMES, &T).unwrap();
                run(backend, Layered::blend(Sclerp, walk, walk, &T));
            });
            within(512 + 2 * 256, |backend| {
                let clip = Clip::new(3, &KEYS).unwrap();
                let walk = Sampled::new(Sclerp, clip, &FRAMES, &T).unwrap();
                run(backend, Layered::add(Sclerp, Layered::blend(Sclerp, walk, walk, &T), walk, &T));
            });
        }

        #[test]
        fn hierarchies_and_chains_need_one_mebibyte() {
            within(1024, |backend| {
                let rig = Hierarchy::new(&PARENTS).unwrap();
                let (turns, offsets) = ([pose::<$real>().rotation(); 3 * INSTANCES], [[0.0; 3]; 3]);
                let turned = Crowd::<$real, $lanes, 4>::from_slice(3, &turns).unwrap();
                let (mut models, mut crowd) = (vec![pose(); 3 * INSTANCES], Crowd::<$real, $lanes>::new(3, INSTANCES));
                let job = rig.job().backend(backend);
                let (mut palette, binds) = (vec![[[0.0; 4]; 3]; 3 * INSTANCES], [pose(); 3]);
                let locals = Bones { rotations: &turns, offsets: &offsets };
                job.palette_and_models(locals, &mut models, &binds, &mut palette).unwrap();
                let locals = Bones { rotations: turned.blocks(), offsets: &offsets };
                let mut palette = Crowd::<$real, $lanes, 12>::new(3, INSTANCES);
                let job = rig.job().backend(backend);
                job.palette_and_models(locals, crowd.blocks_mut(), &binds, palette.blocks_mut()).unwrap();
                job.model_to_local_in_place(crowd.blocks_mut()).unwrap();
                let poses = vec![pose::<$real>(); 3 * INSTANCES];
                let crowd = Crowd::<$real, $lanes>::from_slice(3, &poses).unwrap();
                let mut products = crowd.clone();
                backend.chain_products(crowd.blocks(), products.blocks_mut()).unwrap();
                backend.chain_products_in_place(&mut poses.clone());
            });
        }

        #[test]
        fn meshes_by_a_mix_of_blends_need_one_mebibyte() {
            within(1024, |backend| {
                let skin = Skin::new(2, 4, &[0_u16; 4 * INSTANCES], &[0.25 as $real; 4 * INSTANCES]).unwrap();
                let motions = [pose::<$real>(); 2];
                let matrices = motions.map(DualQuat::to_matrix3x4);
                let mixed = Mixed::new(Linear::new(&matrices), DualBlend::new(&motions), &[0.5; INSTANCES]).unwrap();
                let rest = [[1.0; 3]; INSTANCES];
                let [mut positions, mut normals, mut tangents] = [rest; 3];
                let from = Surface::positions(&rest).normals(&rest).tangents(&rest);
                let to = SurfaceMut::positions(&mut positions).normals(&mut normals).tangents(&mut tangents);
                skin.job().backend(backend).pose(mixed, from, to).unwrap();
            });
        }

        #[test]
        fn blends_of_four_and_windows_need_one_mebibyte() {
            within(1024, |backend| {
                let (poses, t) = (vec![pose::<$real>(); INSTANCES], vec![[0.5]; INSTANCES]);
                let mut out = poses.clone();
                backend.dlb([(&poses[..], &t[..]); 4], &mut out).unwrap();
                backend.dib_windows(&poses, &[1.0; 5], 1e-6, 4, &mut out[..INSTANCES - 4]).unwrap();
            });
        }
    })*};
}
kernels! {
    f32, 16;
    f64, 8;
}
