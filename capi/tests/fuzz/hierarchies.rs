//! Joint hierarchies, plans and chains, over plain arrays and blocks.

use crate::random::{Fuzz, blocks_of};
use dq8_capi::Status;
use dq8_capi::hierarchy::{self, single as h};
use dq8_capi::packing::single as p;
use dq8_capi::{chain, plan};

/// Hierarchies whose parents may be wrong, over plain arrays and blocks, and packing between the two.
pub(crate) fn hierarchies(fuzz: &mut Fuzz) {
    let joints = 1 + fuzz.below(12);
    let instances = 1 + fuzz.below(20);
    let parents: Box<[i32]> = (0..joints)
        .map(|joint| {
            if fuzz.below(60) == 0 { fuzz.bits() as i32 } else { fuzz.below(joint + 1) as i32 - 1 }
        })
        .collect();
    let count = joints * instances;
    let (locals, root, seven) = (fuzz.numbers(8 * count), fuzz.numbers(8), fuzz.numbers(7 * count));
    let (rotations, offsets, binds) =
        (fuzz.numbers(4 * count), fuzz.numbers(3 * joints), fuzz.numbers(8 * joints));
    let mut models = fuzz.numbers(8 * count);
    let mut palette = fuzz.numbers(12 * count);
    let (out, palette) = (models.as_mut_ptr(), palette.as_mut_ptr());
    let root = if fuzz.below(2) == 0 { std::ptr::null() } else { root.as_ptr() };
    let (of, locals) = (parents.as_ptr(), locals.as_ptr());
    let blocks = instances.div_ceil(8) * joints;
    let mut packed = fuzz.blocks::<8, 8>(blocks);
    let mut wide = fuzz.blocks::<16, 8>(instances.div_ceil(16) * joints);
    let (packed, wide) = (packed.as_mut_ptr().cast(), wide.as_mut_ptr().cast());
    let lanes = fuzz.bits() as usize;
    // SAFETY: every array has the length that its function says.
    unsafe {
        let mut bad = 0;
        let good = hierarchy::dq8_check_parents(of, joints, &mut bad);
        for status in [
            h::local_to_model(of, joints, root, locals, out, count),
            h::local_to_model(of, joints, root, out, out, count),
            h::model_to_local(of, joints, root, locals, out, count),
            h::rotations_to_model(
                of,
                joints,
                root,
                rotations.as_ptr(),
                offsets.as_ptr(),
                out,
                count,
            ),
            h::rotations_translations_to_model(of, joints, root, seven.as_ptr(), out, count),
            h::palette(of, joints, root, locals, binds.as_ptr(), out, palette, count),
            h::palette_matrices(of, joints, root, locals, binds.as_ptr(), out, palette, count),
            h::blocks_local_to_model(8, of, joints, root, packed, packed, blocks),
        ] {
            assert_eq!(status, good, "{parents:?}");
        }
        let (mut order, mut scratch) = (vec![0; 2 * joints], vec![0; 6 * joints]);
        let (order, scratch) = (order.as_mut_ptr(), scratch.as_mut_ptr());
        assert_eq!(plan::dq8_plan_make(of, joints, order, scratch, &raw mut bad), good);
        if good == Status::Ok {
            assert_eq!(plan::single::local_to_model(of, order, joints, locals, out, count), good);
            // Any numbers: refused, or an order of joints that there are.
            let at = fuzz.below(2 * joints);
            order.add(at).write(fuzz.below(2 * joints) as u32);
            let status = plan::single::local_to_model(of, order, joints, locals, out, count);
            assert!(matches!(status, Status::Ok | Status::NoPlan), "{status:?}");
        }
        let links = blocks_of(8, count);
        let (mut chain, mut longer) = (fuzz.blocks::<8, 8>(links), fuzz.blocks::<8, 8>(links + 1));
        let (chain, longer) = (chain.as_mut_ptr().cast(), longer.as_mut_ptr().cast());
        assert_eq!(p::pack_chain(8, locals, count, chain, links), Status::Ok);
        assert_eq!(p::pack_chain(8, locals, count, longer, links + 1), Status::Length);
        assert_eq!(chain::single::blocks_chain_products(8, chain, chain, links), Status::Ok);
        assert_eq!(p::unpack_chain(8, chain, links, out, count), Status::Ok);
        let pack = |lanes, blocks, count| {
            p::pack(lanes, joints, locals, count, blocks, blocks_of(lanes, instances) * joints)
        };
        assert_eq!(pack(8, packed, count), Status::Ok);
        assert_eq!(pack(16, wide, count), Status::Ok);
        assert!(joints == 1 || pack(8, packed, count - 1) != Status::Ok);
        assert!(
            [4, 8, 16].contains(&lanes)
                || p::pack(lanes, joints, locals, count, packed, blocks) != Status::Ok
        );
        let whole = instances.div_ceil(16) * joints;
        assert_eq!(p::unpack(16, joints, wide, whole, out, count), Status::Ok);
        let same = models.iter().zip(std::slice::from_raw_parts(locals, 8 * count));
        assert!(same.into_iter().all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}
