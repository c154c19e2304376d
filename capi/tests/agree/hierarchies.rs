//! Hierarchies, palettes and packing.

use crate::sample::{COUNT, JOINTS, PARENTS, block, motions, numbers, rotation, same, vector};
use dq8::storage::{Block, RotationBlock, pack};
use dq8::{
    DualQuat, Hierarchy,
    hierarchy::{Poses, Rotations, RotationsTranslations},
};
use dq8_capi::{hierarchy, packing};
use std::ptr;
use std::slice::from_ref;

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        mod $test {
            use super::*;

            type Motion = DualQuat<$R>;

            #[test]
            fn hierarchies() {
                use hierarchy::$of as h;
                let parents = PARENTS.map(|parent| parent as u32);
                let skeleton = Hierarchy::new(&parents).unwrap();
                let (locals, binds) = (motions(0.0), &motions(1.0)[..JOINTS]);
                let root = motions(2.0)[0];
                let rotations: Vec<_> = (0..COUNT).map(|i| rotation(i, 3.0)).collect();
                let offsets: Vec<_> = (0..JOINTS).map(|i| vector(i, 4.0)).collect();
                let both: Vec<[$R; 7]> = (0..COUNT)
                    .map(|i| {
                        let ([x, y, z, w], [a, b, c]) = (rotations[i].to_array(), vector(i, 5.0));
                        [x, y, z, w, a, b, c]
                    })
                    .collect();
                let (p, on, free, n) =
                    (PARENTS.as_ptr(), numbers(from_ref(&root)), ptr::null(), COUNT);
                let (pl, pb, po) = (numbers(&locals), numbers(binds), numbers(&offsets));
                let job = || skeleton.job::<Motion>().root(root);
                let none = [Motion::ZERO; COUNT];
                // SAFETY: arrays have COUNT or JOINTS elements, as they should.
                unsafe {
                    same(
                        "free",
                        &none,
                        |o| h::local_to_model(p, JOINTS, free, pl, o, n),
                        |o| skeleton.local_to_model(&locals, o).unwrap(),
                    );
                    same(
                        "on a root",
                        &none,
                        |o| h::local_to_model(p, JOINTS, on, pl, o, n),
                        |o| job().local_to_model(&locals, o).unwrap(),
                    );
                    same(
                        "in place",
                        &locals,
                        |o| h::local_to_model(p, JOINTS, on, o, o, n),
                        |o| job().local_to_model_in_place(o).unwrap(),
                    );
                    same(
                        "back",
                        &none,
                        |o| h::model_to_local(p, JOINTS, on, pl, o, n),
                        |o| job().model_to_local(&locals, o).unwrap(),
                    );
                    same(
                        "back in place",
                        &locals,
                        |o| h::model_to_local(p, JOINTS, on, o, o, n),
                        |o| job().model_to_local_in_place(o).unwrap(),
                    );
                    same(
                        "rotations",
                        &none,
                        |o| h::rotations_to_model(p, JOINTS, on, numbers(&rotations), po, o, n),
                        |o| {
                            job()
                                .locals_to_model(
                                    Rotations { rotations: &rotations, offsets: &offsets },
                                    o,
                                )
                                .unwrap()
                        },
                    );
                    same(
                        "rotations, translations",
                        &none,
                        |o| h::rotations_translations_to_model(p, JOINTS, on, numbers(&both), o, n),
                        |o| job().locals_to_model(RotationsTranslations(&both), o).unwrap(),
                    );
                    let (mut models, mut wanted) = (none, none);
                    same(
                        "palette",
                        &none,
                        |o| h::palette(p, JOINTS, on, pl, pb, models.as_mut_ptr().cast(), o, n),
                        |o| job().locals_to_palette(Poses(&locals), &mut wanted, binds, o).unwrap(),
                    );
                    assert_eq!(models, wanted);
                    same(
                        "matrices",
                        &[[[9.0; 4]; 3]; COUNT],
                        |o| {
                            h::palette_matrices(
                                p,
                                JOINTS,
                                on,
                                pl,
                                pb,
                                models.as_mut_ptr().cast(),
                                o,
                                n,
                            )
                        },
                        |o| job().locals_to_palette(Poses(&locals), &mut wanted, binds, o).unwrap(),
                    );

                    let identity = Block::<$R, $lanes>::splat([9.0; 8]);
                    let mut blocks = [identity; JOINTS];
                    same(
                        "pack",
                        &[identity; JOINTS],
                        |o| packing::$of::pack($lanes, JOINTS, pl, COUNT, o, JOINTS),
                        |o| pack(JOINTS, &locals, o).unwrap(),
                    );
                    pack(JOINTS, &locals, &mut blocks).unwrap();
                    same(
                        "unpack",
                        &none,
                        |o| {
                            packing::$of::unpack($lanes, JOINTS, numbers(&blocks), JOINTS, o, COUNT)
                        },
                        |o| o.copy_from_slice(&locals),
                    );
                    let job = skeleton.job::<Block<$R, $lanes>>().root(root);
                    same(
                        "blocks in place",
                        &blocks,
                        |o| h::blocks_local_to_model($lanes, p, JOINTS, on, o, o, JOINTS),
                        |o| job.local_to_model_in_place(o).unwrap(),
                    );
                    let turns: [RotationBlock<$R, $lanes>; JOINTS] =
                        std::array::from_fn(|j| block(|i| rotation(i + j, 3.0).to_array()));
                    same(
                        "blocks of rotations",
                        &blocks,
                        |o| {
                            h::blocks_rotations_to_model(
                                $lanes,
                                p,
                                JOINTS,
                                on,
                                numbers(&turns),
                                po,
                                o,
                                JOINTS,
                            )
                        },
                        |o| {
                            job.locals_to_model(
                                Rotations { rotations: &turns, offsets: &offsets },
                                o,
                            )
                            .unwrap()
                        },
                    );
                    let (mut models, mut wanted) = (blocks, blocks);
                    same(
                        "blocks of a palette",
                        &blocks,
                        |o| {
                            h::blocks_palette(
                                $lanes,
                                p,
                                JOINTS,
                                on,
                                numbers(&blocks),
                                pb,
                                models.as_mut_ptr().cast(),
                                o,
                                JOINTS,
                            )
                        },
                        |o| job.locals_to_palette(Poses(&blocks), &mut wanted, binds, o).unwrap(),
                    );
                    assert_eq!(models, wanted);
                }
            }
        }
    };
}
agree!(single_eight, f32, single, 8);
agree!(single_sixteen, f32, single, 16);
agree!(double_four, f64, double, 4);
agree!(double_eight, f64, double, 8);
