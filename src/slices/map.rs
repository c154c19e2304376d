//! Kernels that are one operation of the lanes: [`OfEach`] record of a slice, [`OfPairs`] of two.

use super::sweep::{SliceKernel, Things, part};
use crate::storage::{self, Element, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

/// What `C` numbers give.
pub(super) trait Unary<const C: usize, const D: usize>: Copy + Sync {
    fn of<L: Lanes>(self, a: [L; C]) -> [L; D];
}

/// What `A` numbers and `B` give.
pub(super) trait Binary<const A: usize, const B: usize, const D: usize>:
    Copy + Sync
{
    fn of<L: Lanes>(self, a: [L; A], b: [L; B]) -> [L; D];
}

/// Operations with a name, one a line.
macro_rules! operations {
    ($($Name:ident($a:ident: $A:literal) -> $D:literal = $of:expr;)*) => {$(
        #[derive(Clone, Copy)]
        struct $Name;
        impl super::map::Unary<$A, $D> for $Name {
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn of<L: dq8_simd::Lanes>(self, $a: [L; $A]) -> [L; $D] {
                $of
            }
        }
    )*};
    ($($Name:ident($a:ident: $A:literal, $b:ident: $B:literal) -> $D:literal = $of:expr;)*) => {$(
        #[derive(Clone, Copy)]
        struct $Name;
        impl super::map::Binary<$A, $B, $D> for $Name {
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn of<L: dq8_simd::Lanes>(self, $a: [L; $A], $b: [L; $B]) -> [L; $D] {
                $of
            }
        }
    )*};
}
pub(super) use operations;

pub(super) struct OfEach<'s, E, F, const C: usize> {
    pub(super) a: &'s [E],
    pub(super) operation: F,
}

impl<E, Q, F, const C: usize, const D: usize> SliceKernel<Q, D> for OfEach<'_, E, F, C>
where
    E: Element<C>,
    Q: Element<D, Layout = E::Layout>,
    F: Unary<C, D>,
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[Q], tile: Tile) -> Things<Q, V, D> {
        Some(self.operation.of(E::load(level, self.a, tile, &storage::identity())?))
    }
    fn part(&self, elements: Range<usize>) -> Self {
        Self { a: part(self.a, elements), operation: self.operation }
    }
}

pub(super) struct OfPairs<'s, E, T, F, const A: usize, const B: usize> {
    pub(super) a: &'s [E],
    pub(super) b: &'s [T],
    pub(super) operation: F,
}

impl<E, T, Q, F, const A: usize, const B: usize, const D: usize> SliceKernel<Q, D>
    for OfPairs<'_, E, T, F, A, B>
where
    E: Element<A>,
    T: Element<B, Layout = E::Layout>,
    Q: Element<D, Layout = E::Layout>,
    F: Binary<A, B, D>,
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[Q], tile: Tile) -> Things<Q, V, D> {
        let b = T::load(level, self.b, tile, &storage::identity())?;
        Some(self.operation.of(E::load(level, self.a, tile, &storage::identity())?, b))
    }
    fn part(&self, elements: Range<usize>) -> Self {
        let (a, b) = (part(self.a, elements.clone()), part(self.b, elements));
        Self { a, b, operation: self.operation }
    }
}
