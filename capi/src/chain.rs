//! Products along long chains: for each link, the product of all links from the first link to this
//! link. Blocks hold a segment of the chain in each lane.

use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};

kernel_or_in_place! { chain_products(links: 8) by chain_products, chain_products_in_place }

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// Computes `out[i] = links[0] * links[1] * ... * links[i]`, the model poses of a
            /// chain. `links` and `out` hold `count` motions. This is faster than a loop if the
            /// chain has dozens of links. Blocks hold one chain, with a segment of it in each lane,
            /// as dq8_pack_chain writes them. `out` may be `links`.
            chain_products, blocks_chain_products(links: *const $R, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);
