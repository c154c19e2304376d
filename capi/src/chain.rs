//! Long chains: the product of all links up to each, plain, or in blocks with a segment in each lane.

use crate::memory::from_to;
use crate::status::{Done, Status};
use dq8::Backend;
use dq8::storage::{AoSoA, Aos, Layout};

/// # Safety
/// As for [`from_to`].
unsafe fn chain_products<L: Layout>(
    links: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let best = Backend::best();
    let in_place = |all: &mut [L::Record<8>]| {
        best.chain_products_in_place(all);
        Ok(())
    };
    // SAFETY: promised.
    unsafe { from_to(links, out, count, |from, to| best.chain_products(from, to), in_place) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// `out[i] = links[0] * links[1] * ... * links[i]`: the model poses of a chain, fast where it has
            /// dozens of links. Blocks hold one chain, a segment in each lane, as dq8_pack_chain writes
            /// them. `out` may be `links`.
            chain_products, blocks_chain_products(links: *const $R, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);
