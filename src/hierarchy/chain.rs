//! Chains: the product of all links up to each one.

use super::Block;
use super::octet::product;
use crate::batch;
use crate::dispatch::{Backend, Kernel};
use crate::error::ShapeError;
use crate::real::Real;
use crate::scalar::DualQuat;
use dq8_simd::{Float, Lanes, Level, Native, Row};

/// The most segments that a chain is cut into: the lanes of the widest block.
const MAX_SEGMENTS: usize = 16;

impl Backend {
    /// `products[i] = links[0] · links[1] ⋯ links[i]`: the models of a chain from its locals.
    ///
    /// A product cannot begin before the one before it has ended, and single motions leave lanes
    /// empty; but products are associative. So the chain is cut into segments of equal length, one a
    /// lane. First the products of whole segments are computed, on all lanes at once; then what comes
    /// before each segment; then, on all lanes again, every product. That is two multiplications a
    /// link, and still twice as fast as one after the other. Results differ from those in the last
    /// bits, as the order of multiplication does.
    ///
    /// Links are `[DualQuat<R>]` in order, or `[Block<R, N>]` with a segment in each lane, see
    /// [`pack_chain`]: the fastest way.
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
    pub fn chain_products<P: Link>(
        self,
        links: &[P],
        products: &mut [P],
    ) -> Result<(), ShapeError> {
        let (length, expected) = (products.len(), links.len());
        if length != expected {
            return Err(ShapeError::Length { what: "products", length, expected });
        }
        self.scan(Some(links), products);
        Ok(())
    }

    /// [`chain_products`](Self::chain_products) over the links themselves.
    #[inline]
    pub fn chain_products_in_place<P: Link>(self, links: &mut [P]) {
        self.scan(None, links);
    }

    /// Without `links`, they lie where the products go. Lengths have been checked.
    #[inline]
    pub(super) fn scan<P: Link>(self, links: Option<&[P]>, products: &mut [P]) {
        self.run(Scan { links, products });
    }
}

/// Writes a chain into blocks, a segment of `blocks.len()` links in each lane: link `i` is at lane
/// `i / blocks.len()` of block `i % blocks.len()`. Lanes beyond the last link hold the identity.
///
/// # Errors
/// If there are not just as many blocks as the links fill; `blocks` is untouched.
///
/// ```
/// use dq8::{Backend, Block, DualQuat, pack_chain, unpack_chain};
/// let rope = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 10];
/// let mut blocks = [Block::<f32, 8>::splat([0.0; 8]); 2]; // ⌈10 / 8⌉
/// pack_chain(&rope, &mut blocks)?;
/// Backend::best().chain_products_in_place(&mut blocks);
/// let mut models = [DualQuat::IDENTITY; 10];
/// unpack_chain(&blocks, &mut models)?;
/// assert_eq!(models[9].translation(), [10.0, 0.0, 0.0]);
/// # Ok::<(), dq8::ShapeError>(())
/// ```
pub fn pack_chain<R: Real, const N: usize>(
    links: &[DualQuat<R>],
    blocks: &mut [Block<R, N>],
) -> Result<(), ShapeError>
where
    [R; N]: Row<Real = R>,
{
    check::<N>(links.len(), blocks.len())?;
    blocks.fill(Block::splat(DualQuat::IDENTITY.to_array()));
    for (lane, segment) in links.chunks(blocks.len().max(1)).enumerate() {
        for (block, link) in blocks.iter_mut().zip(segment) {
            let _ = block.set(lane, link.to_array());
        }
    }
    Ok(())
}

/// Reads a chain from blocks, see [`pack_chain`].
///
/// # Errors
/// If there are not just as many blocks as the links fill; `links` is untouched.
pub fn unpack_chain<R: Real, const N: usize>(
    blocks: &[Block<R, N>],
    links: &mut [DualQuat<R>],
) -> Result<(), ShapeError>
where
    [R; N]: Row<Real = R>,
{
    check::<N>(links.len(), blocks.len())?;
    for (lane, segment) in links.chunks_mut(blocks.len().max(1)).enumerate() {
        for (link, record) in segment.iter_mut().zip(blocks.iter().map(|block| block.get(lane))) {
            *link = record.map_or(*link, DualQuat::from_array);
        }
    }
    Ok(())
}

fn check<const N: usize>(links: usize, length: usize) -> Result<(), ShapeError> {
    let expected = links.div_ceil(N);
    if length == expected {
        Ok(())
    } else {
        Err(ShapeError::Length { what: "blocks", length, expected })
    }
}

/// A place in memory that holds one link of a chain, or one of each segment. Implemented for
/// [`DualQuat`] and [`Block`]; sealed.
pub trait Link: Copy + super::pose::sealed::Sealed {
    /// The number.
    type Real: Real + Float;
    /// As many segments as are computed together.
    type Lanes<V: Level>: Lanes<Real = Self::Real, Level = V>;

    /// How many times as many segments there are.
    #[must_use]
    fn parts<V: Level>() -> usize;
    /// How many links a segment has; what is left over is for [`finish`](Self::finish).
    #[must_use]
    fn steps(length: usize) -> usize;
    /// A link of each segment of a part.
    fn load<V: Level>(level: V, from: &[Self], part: usize, step: usize) -> Motions<Self, V>;
    /// To a link of each segment of a part.
    fn store<V: Level>(motions: Motions<Self, V>, to: &mut [Self], part: usize, step: usize);
    /// The links behind the last segment, whose last product is `before`.
    fn finish<V: Level>(
        before: <Self::Real as Float>::Octet<V>,
        links: Option<&[Self]>,
        products: &mut [Self],
    );
}

/// One link of each segment of a part.
type Motions<P, V> = batch::DualQuat<<P as Link>::Lanes<V>>;

struct Scan<'s, P> {
    links: Option<&'s [P]>,
    products: &'s mut [P],
}

impl<P: Link> Kernel for Scan<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { links, products } = self;
        let (parts, steps) = (P::parts::<V>(), P::steps(products.len()));
        let lanes = P::Lanes::<V>::LANES;
        // What the segments come to; lanes or parts that there are not stay at the identity.
        let mut segments = [DualQuat::IDENTITY.to_array(); MAX_SEGMENTS];
        for (part, totals) in segments.chunks_exact_mut(lanes).take(parts).enumerate() {
            let mut total = batch::DualQuat::identity(level);
            let from = links.unwrap_or(products);
            for step in (1..steps).step_by(2) {
                // Two links first: that product waits for nothing.
                let two = P::load(level, from, part, step - 1) * P::load(level, from, part, step);
                total = total * two;
            }
            if steps % 2 == 1 {
                total = total * P::load(level, from, part, steps - 1);
            }
            total.store_records(totals);
        }
        // What comes before each of them.
        let identity = DualQuat::IDENTITY.to_array();
        let mut before = <P::Real as Float>::Octet::<V>::load(level, &identity);
        for segment in segments.iter_mut().take(parts * lanes) {
            let after = product(before, segment);
            before.store(segment);
            before = after;
        }
        for (part, starts) in segments.chunks_exact(lanes).take(parts).enumerate() {
            let mut model = batch::DualQuat::load_records(level, starts);
            for step in 0..steps {
                model = model * P::load(level, links.unwrap_or(products), part, step);
                P::store(model, products, part, step);
            }
        }
        P::finish(before, links, products);
    }
}

/// Segments of plain motions.
const PLAIN_SEGMENTS: usize = 8;

/// Plain motions: eight segments lie one after the other, and are transposed in registers.
impl<R: Real + Float> Link for DualQuat<R> {
    type Real = R;
    type Lanes<V: Level> = R::Octet<V>;

    #[inline(always)]
    fn parts<V: Level>() -> usize {
        1
    }
    #[inline(always)]
    fn steps(length: usize) -> usize {
        length / PLAIN_SEGMENTS
    }
    #[inline(always)]
    fn load<V: Level>(level: V, from: &[Self], _: usize, step: usize) -> Motions<Self, V> {
        let stride = 8 * Self::steps(from.len());
        let records: &[[R; 8]] = bytemuck::must_cast_slice(from);
        let real = records.get(step..).unwrap_or_default().as_flattened();
        let dual = real.get(4..).unwrap_or_default();
        let [px, py, pz, pw] = R::Octet::load_quads(level, real, stride);
        let [qx, qy, qz, qw] = R::Octet::load_quads(level, dual, stride);
        batch::DualQuat::from_array([px, py, pz, pw, qx, qy, qz, qw])
    }
    #[inline(always)]
    fn store<V: Level>(motions: Motions<Self, V>, to: &mut [Self], _: usize, step: usize) {
        let stride = 8 * Self::steps(to.len());
        let records: &mut [[R; 8]] = bytemuck::must_cast_slice_mut(to);
        let real = records.get_mut(step..).unwrap_or_default().as_flattened_mut();
        let [px, py, pz, pw, qx, qy, qz, qw] = motions.to_array();
        R::Octet::store_quads([px, py, pz, pw], real, stride);
        let dual = real.get_mut(4..).unwrap_or_default();
        R::Octet::store_quads([qx, qy, qz, qw], dual, stride);
    }
    #[inline(always)]
    fn finish<V: Level>(mut before: R::Octet<V>, links: Option<&[Self]>, products: &mut [Self]) {
        for index in PLAIN_SEGMENTS * Self::steps(products.len())..products.len() {
            let Some(link) = links.unwrap_or(products).get(index) else { break };
            before = product(before, &link.to_array());
            let Some(slot) = products.get_mut(index) else { break };
            *slot = Self::from_array(before.to_array());
        }
    }
}

/// Blocks: every lane is a segment already.
impl<R: Real + Float, const N: usize> Link for Block<R, N>
where
    [R; N]: Row<Real = R>,
{
    type Real = R;
    type Lanes<V: Level> = Native<[R; N], V>;

    #[inline(always)]
    fn parts<V: Level>() -> usize {
        Self::parts::<V>()
    }
    #[inline(always)]
    fn steps(length: usize) -> usize {
        length
    }
    #[inline(always)]
    fn load<V: Level>(level: V, from: &[Self], part: usize, step: usize) -> Motions<Self, V> {
        match from.get(step) {
            Some(block) => batch::DualQuat::from_array(block.load_part(level, part)),
            None => batch::DualQuat::identity(level),
        }
    }
    #[inline(always)]
    fn store<V: Level>(motions: Motions<Self, V>, to: &mut [Self], part: usize, step: usize) {
        if let Some(block) = to.get_mut(step) {
            block.store_part::<V>(motions.to_array(), part);
        }
    }
    #[inline(always)]
    fn finish<V: Level>(_: R::Octet<V>, _: Option<&[Self]>, _: &mut [Self]) {}
}
