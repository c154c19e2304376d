//! Chains: the product of all links up to each one.

use super::locals::motions;
use super::product::packed_product;
use crate::batch;
use crate::dispatch::{Backend, Kernel};
use crate::shape::{ShapeError, same_length};
use crate::storage::{Element, Layout, Number, Register, Source, Tile, identity};
use dq8_simd::{Float, Lanes, Level};

/// The most segments that a chain is cut into: the lanes of the widest block.
const MAX_SEGMENTS: usize = 16;

/// Segments of plain motions.
const PLAIN_SEGMENTS: usize = 8;

impl Backend {
    /// `products[i] = links[0] · links[1] ⋯ links[i]`: the models of a chain from its locals.
    ///
    /// A product cannot begin before the one before it has ended, and single motions leave lanes
    /// empty; but products are associative. So the chain is cut into segments of equal length, one to a
    /// lane. First the products of whole segments are computed, on all lanes at once; then what comes
    /// before each segment; then, on all lanes again, every product. That is two multiplications for each
    /// link, and still twice as fast as one after the other. Results differ from those in the last
    /// bits, as the order of multiplication does.
    ///
    /// Links are `[DualQuat<R>]` in order, or `[Block<R, N>]` with a segment in each lane, see
    /// [`pack_chain`](crate::storage::pack_chain): the fastest way.
    ///
    /// # Errors
    /// If the slices differ in length; `products` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let step = DualQuat::from_translation([0.0_f32, 0.5, 0.0]);
    /// let mut rope = [DualQuat::IDENTITY; 100];
    /// Backend::best().chain_products(&[step; 100], &mut rope)?;
    /// assert_eq!(rope[99].translation(), [0.0, 50.0, 0.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn chain_products<E: Element<8>>(
        self,
        links: &[E],
        products: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("products", products.len(), links.len())?;
        self.scan(Source::Slice(links), products);
        Ok(())
    }

    /// [`chain_products`](Self::chain_products) over the links themselves.
    #[inline]
    pub fn chain_products_in_place<E: Element<8>>(self, links: &mut [E]) {
        self.scan(Source::Output, links);
    }

    /// Lengths have been checked.
    #[inline]
    pub(super) fn scan<E: Element<8>>(self, links: Source<'_, E>, products: &mut [E]) {
        self.run(Scan { links, products });
    }
}

/// A scan in three passes: totals of the segments, a scan over those totals, and the products.
///
/// Lanes are segments, so the links of one tile lie a segment's length apart: in blocks by the way they
/// were packed, in plain slices by a stride. What plain links are left over at the end (a chain need not
/// fill eight segments) is multiplied one by one.
struct Scan<'s, E> {
    links: Source<'s, E>,
    products: &'s mut [E],
}

impl<E: Element<8>> Kernel for Scan<'_, E> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { links, products } = self;
        let lanes = Register::<E, V, 8>::LANES;
        let is_plain = E::Layout::THINGS == 1;
        let parts = if is_plain { PLAIN_SEGMENTS / lanes } else { E::Layout::registers::<V>() };
        let steps = if is_plain { products.len() / PLAIN_SEGMENTS } else { products.len() };
        let at = |part: usize, step: usize| {
            if is_plain {
                Tile { element: part * lanes * steps + step, register: 0, stride: Some(steps) }
            } else {
                Tile::at(step, part)
            }
        };
        // The totals of segments; lanes or parts that there are not stay at the identity.
        let mut segments = [identity(); MAX_SEGMENTS];
        for (part, totals) in segments.chunks_exact_mut(lanes).take(parts).enumerate() {
            let mut total = batch::DualQuat::identity(level);
            let from = links.or(products);
            for step in (1..steps).step_by(2) {
                // Two links first: that product waits for nothing.
                let Some(first) = motions(level, from, at(part, step - 1)) else { return };
                let Some(second) = motions(level, from, at(part, step)) else { return };
                total = total * (first * second);
            }
            if steps % 2 == 1 {
                let Some(last) = motions(level, from, at(part, steps - 1)) else { return };
                total = total * last;
            }
            total.store_records(totals);
        }
        // What comes before each of them.
        let mut before = <Number<E, 8> as Float>::Octet::<V>::load(level, &identity());
        for segment in segments.iter_mut().take(parts * lanes) {
            let after = packed_product(before, segment);
            before.store(segment);
            before = after;
        }
        for (part, starts) in segments.chunks_exact(lanes).take(parts).enumerate() {
            let mut model = batch::DualQuat::load_records(level, starts);
            for step in 0..steps {
                let Some(link) = motions(level, links.or(products), at(part, step)) else { return };
                model = model * link;
                E::store(model.to_array(), products, at(part, step));
            }
        }
        for index in PLAIN_SEGMENTS * steps..products.len() {
            let Some(link) = E::plain(links.or(products)).and_then(|links| links.get(index)) else {
                return;
            };
            before = packed_product(before, link);
            let Some(product) = E::plain_mut(products).and_then(|all| all.get_mut(index)) else {
                return;
            };
            before.store(product);
        }
    }
}
