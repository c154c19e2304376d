//! Hierarchies, palettes and packing.

use crate::sample::{
    COUNT, JOINTS, PARENTS, block, for_all_lanes, motions, numbers, rotation, same, vector,
};
use dq8::storage::{Block, pack};
use dq8::{
    DualQuat, Hierarchy, Real,
    hierarchy::{Bones, Poses, RotationsTranslations},
};
use dq8_capi::{hierarchy, packing};
use std::ptr;
use std::slice::from_ref;

/// What both layouts share: offsets of joints, inverse bind poses, and what roots stand on.
fn rest<R: Real>() -> (Vec<[R; 3]>, Vec<DualQuat<R>>, DualQuat<R>) {
    let binds = motions(1.0)[..JOINTS].to_vec();
    ((0..JOINTS).map(|i| vector(i, 4.0)).collect(), binds, motions(2.0)[0])
}

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        mod $test {
            use super::*;
            use hierarchy::$of as h;

            type Motion = DualQuat<$R>;

            #[test]
            fn plain() {
                let parents = PARENTS.map(|parent| parent as u32);
                let skeleton = Hierarchy::new(&parents).unwrap();
                let (offsets, binds, root) = rest();
                let locals = motions(0.0);
                let rotations: Vec<_> = (0..COUNT).map(|i| rotation(i, 3.0)).collect();
                let both: Vec<[$R; 7]> = (0..COUNT)
                    .map(|i| {
                        let ([x, y, z, w], [a, b, c]) = (rotations[i].to_array(), vector(i, 5.0));
                        [x, y, z, w, a, b, c]
                    })
                    .collect();
                let turns = Bones { rotations: &rotations[..], offsets: &offsets[..] };
                let (p, on, free, n) =
                    (PARENTS.as_ptr(), numbers(from_ref(&root)), ptr::null(), COUNT);
                let (pl, pb, po) = (numbers(&locals), numbers(&binds), numbers(&offsets));
                let (pr, prt) = (numbers(&rotations), numbers(&both));
                let job = || skeleton.job().root(root);
                let none = [Motion::ZERO; COUNT];
                let (mut models, mut wanted) = (none, none);
                let pm = models.as_mut_ptr().cast();
                // SAFETY: arrays have COUNT or JOINTS elements, as they should.
                unsafe {
                    same! { |o|
                        &none, h::local_to_model(p, JOINTS, free, pl, o, n)
                            => skeleton.local_to_model(&locals, o).unwrap();
                        &none, h::local_to_model(p, JOINTS, on, pl, o, n)
                            => job().local_to_model(&locals, o).unwrap();
                        &locals, h::local_to_model(p, JOINTS, on, o, o, n)
                            => job().local_to_model_in_place(o).unwrap();
                        &none, h::model_to_local(p, JOINTS, on, pl, o, n)
                            => job().model_to_local(&locals, o).unwrap();
                        &locals, h::model_to_local(p, JOINTS, on, o, o, n)
                            => job().model_to_local_in_place(o).unwrap();
                        &none, h::rotations_to_model(p, JOINTS, on, pr, po, o, n)
                            => job().locals_to_model(turns, o).unwrap();
                        &none, h::rotations_translations_to_model(p, JOINTS, on, prt, o, n)
                            => job().locals_to_model(RotationsTranslations(&both), o).unwrap();
                        &none, h::palette(p, JOINTS, on, pl, pb, pm, o, n)
                            => job().palette_and_models(Poses(&locals), &mut wanted, &binds, o).unwrap();
                    }
                    assert_eq!(models, wanted);
                    let pm = models.as_mut_ptr().cast();
                    same! { |o|
                        &[[[9.0; 4]; 3]; COUNT],
                            h::palette_matrices(p, JOINTS, on, pl, pb, pm, o, n)
                            => job().palette_and_models(Poses(&locals), &mut wanted, &binds, o).unwrap();
                    }
                }
            }

            #[test]
            fn in_blocks() {
                let parents = PARENTS.map(|parent| parent as u32);
                let skeleton = Hierarchy::new(&parents).unwrap();
                let (offsets, binds, root) = rest();
                let locals = motions(0.0);
                let none = [Motion::ZERO; COUNT];
                let empty = [Block::<$R, $lanes>::splat([9.0; 8]); JOINTS];
                let mut blocks = empty;
                pack(JOINTS, &locals, &mut blocks).unwrap();
                let rotations: [Block<$R, $lanes, 4>; JOINTS] =
                    std::array::from_fn(|j| block(|i| rotation(i + j, 3.0).to_array()));
                let turns = Bones { rotations: &rotations[..], offsets: &offsets[..] };
                let (p, on) = (PARENTS.as_ptr(), numbers(from_ref(&root)));
                let (pl, pb, po) = (numbers(&locals), numbers(&binds), numbers(&offsets));
                let (pk, pr) = (numbers(&blocks), numbers(&rotations));
                let job = skeleton.job().root(root);
                let (mut models, mut wanted) = (blocks, blocks);
                let pm = models.as_mut_ptr().cast();
                // SAFETY: arrays have COUNT or JOINTS elements, as they should.
                unsafe {
                    same! { |o|
                        &empty, packing::$of::pack($lanes, JOINTS, pl, COUNT, o, JOINTS)
                            => pack(JOINTS, &locals, o).unwrap();
                        &none, packing::$of::unpack($lanes, JOINTS, pk, JOINTS, o, COUNT)
                            => o.copy_from_slice(&locals);
                        &blocks, h::blocks_local_to_model($lanes, p, JOINTS, on, o, o, JOINTS)
                            => job.local_to_model_in_place(o).unwrap();
                        &blocks,
                            h::blocks_rotations_to_model($lanes, p, JOINTS, on, pr, po, o, JOINTS)
                            => job.locals_to_model(turns, o).unwrap();
                        &blocks, h::blocks_palette($lanes, p, JOINTS, on, pk, pb, pm, o, JOINTS)
                            => job.palette_and_models(Poses(&blocks), &mut wanted, &binds, o).unwrap();
                    }
                }
                assert_eq!(models, wanted);
            }
        }
    };
}
for_all_lanes!(agree);
