//! Products of chains: for each link, the product of all links up to it. The module also has the
//! product of two motions that all loops over a hierarchy use, with one motion in a register
//! ([`packed_product`]) or one motion in each lane ([`product_in_lanes`]).

use crate::backend::{Backend, Kernel};
use crate::batch;
use crate::number::Scalar;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Layout, Number, Register, Source, Tile, aos, identity, motions};
use core::marker::PhantomData;
use dq8_simd::{Float, Lanes, Level, PackedDualQuat};

/// The greatest number of segments of a chain, which is the number of lanes of the widest block.
const MAX_SEGMENTS: usize = 16;

impl Backend {
    /// Computes the models of a chain from its locals:
    /// `products[i] = links[0] · links[1] ⋯ links[i]`.
    ///
    /// Each product needs the product before it, so a loop over the links has one motion at a time
    /// and no work for other lanes. But products are associative, so the chain is divided into
    /// segments of equal length, one in each lane. The first pass computes the products of whole
    /// segments, on all lanes at once. The second pass multiplies these totals, so that each
    /// segment knows the product of all links before it. The third pass computes every product, on
    /// all lanes again. This takes two multiplications for each link, and is still twice as fast as
    /// a loop over the links. Its results differ from those of the loop in the last bits, because
    /// the multiplications are in another order.
    ///
    /// Links are `[DualQuat<R>]` in order, or `[Block<R, N>]` with a segment in each lane, which is
    /// the fastest way; see [`pack_chain`](crate::storage::pack_chain).
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

    /// Computes the products of a chain in place as [`chain_products`](Self::chain_products) does.
    #[inline]
    pub fn chain_products_in_place<E: Element<8>>(self, links: &mut [E]) {
        self.scan(Source::Output, links);
    }

    /// Computes the products of a chain whose lengths have been checked.
    #[inline]
    pub(super) fn scan<E: Element<8>>(self, links: Source<'_, E>, products: &mut [E]) {
        self.run(Scan { links, products });
    }
}

/// A scan in three passes: the total of each segment, a scan over these totals, and the product of
/// each link.
struct Scan<'s, E> {
    links: Source<'s, E>,
    products: &'s mut [E],
}

impl<E: Element<8>> Kernel for Scan<'_, E> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { links, products } = self;
        // A chain in blocks was divided into segments when it was packed, and the last segment was
        // filled up with identities.
        if const { E::Layout::THINGS > 1 } {
            scan(InBlocks { level, links, products });
            return;
        }
        let links = match links {
            Source::Slice(links) => E::plain(links).map(Source::Slice),
            Source::Output => Some(Source::Output),
        };
        // The loop may work in place: the third pass overwrites a link with its product just after
        // it has read the link, and the first pass, which reads all links, has then ended.
        if let (Some(links), Some(products)) = (links, E::plain_mut(products)) {
            let steps = products.len() / PLAIN_SEGMENTS;
            // On targets without SIMD, where a register holds a single value, segments are computed
            // one after the other, because the values of eight segments would not fit the
            // registers.
            let mut before = if const {
                <<Number<E, 8> as Float>::Packed<V> as Lanes>::Native::LANES == 1
            } {
                scan(Strided::<_, _, <<Number<E, 8> as Float>::Packed<V> as Lanes>::Native>::new(
                    level, steps, links, products,
                ))
            } else {
                scan(Strided::<_, _, <Number<E, 8> as Float>::Packed<V>>::new(
                    level, steps, links, products,
                ))
            };
            // The links that remain after the eight segments of equal length are multiplied one by
            // one.
            for index in PLAIN_SEGMENTS * steps..products.len() {
                let Some(link) = links.or(products).get(index) else { return };
                before = packed_product(before, link);
                let Some(product) = products.get_mut(index) else { return };
                before.store(product);
            }
        }
    }
}

/// A chain in segments, with a segment in each lane. If the segments need several registers, a
/// *part* consists of the segments in the lanes of one register.
trait Segments {
    type Lanes: Lanes<Real: Scalar>;
    fn level(&self) -> <Self::Lanes as Lanes>::Level;
    fn parts(&self) -> usize;
    /// Returns the number of links of a segment.
    fn steps(&self) -> usize;
    /// Loads link `step` of every segment in a part.
    fn load(&self, part: usize, step: usize) -> Option<batch::DualQuat<Self::Lanes>>;
    /// Stores product `step` of every segment in a part.
    fn store(&mut self, product: batch::DualQuat<Self::Lanes>, part: usize, step: usize);
}

/// Writes every product, and returns the product of all links.
#[cfg_attr(not(opt_level_0), inline(always))]
fn scan<S: Segments>(mut segments: S) -> Packed<S> {
    let (level, steps) = (segments.level(), segments.steps());
    let (parts, lanes) = (segments.parts(), S::Lanes::LANES);
    // First pass, on all lanes: the product of each segment.
    //
    // An element of `totals` to which no segment belongs stays at the identity, which changes no
    // product.
    let mut totals = [identity(); MAX_SEGMENTS];
    for (part, totals) in totals.chunks_exact_mut(lanes).take(parts).enumerate() {
        let mut total = batch::DualQuat::identity(level);
        for step in (1..steps).step_by(2) {
            // Two links are multiplied with each other first, because their product need not wait
            // for `total`.
            let Some(first) = segments.load(part, step - 1) else { break };
            let Some(second) = segments.load(part, step) else { break };
            total = total * (first * second);
        }
        if steps % 2 == 1
            && let Some(last) = segments.load(part, steps - 1)
        {
            total = total * last;
        }
        total.store_records(totals);
    }
    // Second pass, an exclusive scan of at most sixteen totals, with one motion in a register:
    // `totals[i]` becomes the product of all segments before segment i, and `before` ends as the
    // product of all segments.
    let mut before = Packed::<S>::load(level, &identity());
    for total in totals.iter_mut().take(parts * lanes) {
        let after = packed_product(before, total);
        before.store(total);
        before = after;
    }
    // Third pass, on all lanes: each segment is multiplied again, beginning with the product of all
    // segments before it. The links are read a second time. Keeping the partial products of the
    // first pass instead would take a store and a load for each product.
    for (part, starts) in totals.chunks_exact(lanes).take(parts).enumerate() {
        let mut model = batch::DualQuat::load_records(level, starts);
        for step in 0..steps {
            let Some(link) = segments.load(part, step) else { break };
            model = model * link;
            segments.store(model, part, step);
        }
    }
    before
}

/// A register that holds one motion.
type Packed<S> = <<<S as Segments>::Lanes as Lanes>::Real as Float>::Packed<
    <<S as Segments>::Lanes as Lanes>::Level,
>;

/// A chain in blocks, in which every lane holds a segment.
struct InBlocks<'s, V, E> {
    level: V,
    links: Source<'s, E>,
    products: &'s mut [E],
}

impl<E: Element<8>, V: Level> Segments for InBlocks<'_, V, E> {
    type Lanes = Register<E, V, 8>;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn level(&self) -> V {
        self.level
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn parts(&self) -> usize {
        E::Layout::registers::<V>()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn steps(&self) -> usize {
        self.products.len()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load(&self, part: usize, step: usize) -> Option<batch::DualQuat<Self::Lanes>> {
        motions(self.level, self.links.or(self.products), Tile::at(step, part))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store(&mut self, product: batch::DualQuat<Self::Lanes>, part: usize, step: usize) {
        E::store(product.to_array(), self.products, Tile::at(step, part));
    }
}

/// The number of segments of a chain in a plain slice.
const PLAIN_SEGMENTS: usize = 8;

/// A chain in a plain slice. Its eight segments lie one after the other in memory, so links are
/// loaded at a stride and transposed in registers.
struct Strided<'s, V, R, L> {
    level: V,
    steps: usize,
    links: Source<'s, [R; 8]>,
    products: &'s mut [[R; 8]],
    lanes: PhantomData<L>,
}

impl<'s, V, R, L> Strided<'s, V, R, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn new(level: V, steps: usize, links: Source<'s, [R; 8]>, products: &'s mut [[R; 8]]) -> Self {
        Self { level, steps, links, products, lanes: PhantomData }
    }

    /// Returns the tile that holds link `step` of every segment in a part. Its stride is the length
    /// of a segment.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tile(&self, part: usize, step: usize) -> Tile
    where
        L: Lanes,
    {
        let element = part * L::LANES * self.steps + step;
        Tile { element, register: 0, stride: Some(self.steps) }
    }
}

impl<V: Level, R: Scalar, L: Lanes<Real = R, Level = V>> Segments for Strided<'_, V, R, L> {
    type Lanes = L;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn level(&self) -> V {
        self.level
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn parts(&self) -> usize {
        PLAIN_SEGMENTS / L::LANES
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn steps(&self) -> usize {
        self.steps
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load(&self, part: usize, step: usize) -> Option<batch::DualQuat<L>> {
        let tile = self.tile(part, step);
        let links = aos::load(self.level, self.links.or(self.products), tile, &identity())?;
        Some(batch::DualQuat::from_array(links))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store(&mut self, product: batch::DualQuat<L>, part: usize, step: usize) {
        let tile = self.tile(part, step);
        aos::store(product.to_array(), self.products, tile);
    }
}

/// Computes left · right. One register holds the left factor, and each component of the right
/// factor is broadcast to all lanes of a register of its own.
///
/// With right = p + εq, the result is left · p + ε(left · q), where terms with ε² are
/// dropped. This takes eight multiplications of vectors. The last sum adds −0 to the real part,
/// so the bits of the real part do not change. Adding +0 would turn −0 into +0, and the result
/// would differ from that of [`product_in_lanes`].
///
/// Three other ways were measured on a skeleton of 64 joints and are slower. Alternating
/// multiply-adds and subtractions, in place of a change of signs, take a sixth longer, although
/// they save three instructions. Broadcasting the components of the left factor takes a sixth
/// longer. Computing joints of equal depth in the lanes, with gathers and scatters, takes a
/// twentieth longer.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn packed_product<L: PackedDualQuat>(left: L, right: &[L::Real; 8]) -> L {
    let level = left.level();
    let [x, y, z, w] = left.columns();
    let [px, py, pz, pw, qx, qy, qz, qw] = L::splat_each(level, right);
    let dual = z.mul_add(qz, y.mul_add(qy, x.mul_add(qx, w * qw)));
    let both = z.mul_add(pz, y.mul_add(py, x.mul_add(px, w * pw)));
    both + dual.times_epsilon()
}

/// Returns the [`packed_product`] of the model of a parent and the local of its child, both in
/// memory.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn product<R: Scalar, V: Level>(level: V, parent: &[R; 8], local: &[R; 8]) -> [R; 8] {
    let mut model = [R::ZERO; 8];
    packed_product(R::Packed::<V>::load(level, parent), local).store(&mut model);
    model
}

/// Computes the product of two motions in each lane. It adds in the same order as
/// [`packed_product`], with the same signs of zeros. So the result of an instance depends neither
/// on the number of instances that are computed together nor on the lane count. (The product of
/// [`batch::DualQuat`](crate::batch::DualQuat) adds both terms of the dual part in one chain of
/// multiply-adds, which saves four additions but has other bits.)
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn product_in_lanes<L: Lanes>(left: [L; 8], right: [L; 8]) -> [L; 8] {
    let [px, py, pz, pw, qx, qy, qz, qw] = left;
    let [rx, ry, rz, rw, sx, sy, sz, sw] = right;
    let (p, q) = ([px, py, pz, pw], [qx, qy, qz, qw]);
    let (r, s) = ([rx, ry, rz, rw], [sx, sy, sz, sw]);
    let [dx, dy, dz, dw] = hamilton(p, s);
    let [ex, ey, ez, ew] = hamilton(q, r);
    let [x, y, z, w] = hamilton(p, r);
    [x, y, z, w, ex + dx, ey + dy, ez + dz, ew + dw]
}

/// Returns the quaternion product pq, where `[px, py, pz, pw]` is p and `[x, y, z, w]` is q. The
/// terms with the components w, x, y and z of q are added in this order.
#[cfg_attr(not(opt_level_0), inline(always))]
fn hamilton<L: Lanes>([px, py, pz, pw]: [L; 4], [x, y, z, w]: [L; 4]) -> [L; 4] {
    [
        py.mul_add(z, pz.neg_mul_add(y, pw.mul_add(x, px * w))),
        px.neg_mul_add(z, pw.mul_add(y, pz.mul_add(x, py * w))),
        pw.mul_add(z, px.mul_add(y, py.neg_mul_add(x, pz * w))),
        pz.neg_mul_add(z, py.neg_mul_add(y, px.neg_mul_add(x, pw * w))),
    ]
}
