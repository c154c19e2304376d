//! Long chains, plain and in blocks.

use crate::sample::{COUNT, motions, numbers, same};
use dq8::storage::{Block, pack_chain, unpack_chain};
use dq8::{Backend, DualQuat};
use dq8_capi::{chain, packing};

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        #[test]
        fn $test() {
            use {chain::$of as c, packing::$of as p};
            let links: Vec<DualQuat<$R>> = [motions(0.0), motions(1.0), motions(2.0)].concat();
            const LINKS: usize = 3 * COUNT;
            const BLOCKS: usize = LINKS.div_ceil($lanes);
            let (pl, none, best) = (numbers(&links), [DualQuat::ZERO; LINKS], Backend::best());
            let empty = [Block::<$R, $lanes>::splat([9.0; 8]); BLOCKS];
            let mut packed = empty;
            pack_chain(&links, &mut packed).unwrap();
            // SAFETY: arrays have LINKS elements or BLOCKS.
            unsafe {
                same(
                    "plain",
                    &none,
                    |o| c::chain_products(pl, o, LINKS),
                    |o| best.chain_products(&links, o).unwrap(),
                );
                same(
                    "plain, in place",
                    &links,
                    |o| c::chain_products(o, o, LINKS),
                    |o| best.chain_products_in_place(o),
                );
                same(
                    "pack",
                    &empty,
                    |o| p::pack_chain($lanes, pl, LINKS, o, BLOCKS),
                    |o| pack_chain(&links, o).unwrap(),
                );
                same(
                    "unpack",
                    &none,
                    |o| p::unpack_chain($lanes, numbers(&packed), BLOCKS, o, LINKS),
                    |o| unpack_chain(&packed, o).unwrap(),
                );
                same(
                    "blocks",
                    &empty,
                    |o| c::blocks_chain_products($lanes, numbers(&packed), o, BLOCKS),
                    |o| best.chain_products(&packed, o).unwrap(),
                );
                same(
                    "blocks, in place",
                    &packed,
                    |o| c::blocks_chain_products($lanes, o, o, BLOCKS),
                    |o| best.chain_products_in_place(o),
                );
            }
        }
    };
}
agree!(single_eight, f32, single, 8);
agree!(single_sixteen, f32, single, 16);
agree!(double_four, f64, double, 4);
agree!(double_eight, f64, double, 8);
