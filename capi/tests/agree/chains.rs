//! Long chains, plain and in blocks.

use crate::sample::{COUNT, for_all_lanes, motions, numbers, same};
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
                same! { |o|
                    &none, c::chain_products(pl, o, LINKS)
                        => best.chain_products(&links, o).unwrap();
                    &links, c::chain_products(o, o, LINKS) => best.chain_products_in_place(o);
                    &empty, p::pack_chain($lanes, pl, LINKS, o, BLOCKS)
                        => pack_chain(&links, o).unwrap();
                    &none, p::unpack_chain($lanes, numbers(&packed), BLOCKS, o, LINKS)
                        => unpack_chain(&packed, o).unwrap();
                    &empty, c::blocks_chain_products($lanes, numbers(&packed), o, BLOCKS)
                        => best.chain_products(&packed, o).unwrap();
                    &packed, c::blocks_chain_products($lanes, o, o, BLOCKS)
                        => best.chain_products_in_place(o);
                }
            }
        }
    };
}
for_all_lanes!(agree);
