use super::surface::{Surface, SurfaceMut};
use crate::backend::Outputs;
#[cfg(feature = "rayon")]
use crate::storage::Layout;
use crate::storage::{self, Element, Number, Register, Tile};
use dq8_simd::Level;

/// A mesh at rest and posed, in memory whose tiles are those of `P`.
pub(super) trait Mesh<P: Element<3>>: Outputs {
    /// The number of elements.
    fn elements(&self) -> usize;
    /// The vectors of a tile at rest; zero in lanes beyond the end. `None` if there are none.
    fn load<V: Level>(&self, level: V, field: Field, tile: Tile) -> Option<Vectors<P, V>>;
    /// Positions at rest and posed, if they are plain, and there is nothing else to pose.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn points(&mut self) -> Option<PlainPoints<'_, Number<P, 3>>> {
        None
    }
    /// The posed vectors of a tile.
    fn store<V: Level>(&mut self, vectors: Vectors<P, V>, field: Field, tile: Tile);
}

/// Points at rest, and posed.
pub(super) type PlainPoints<'m, R> = (&'m [[R; 3]], &'m mut [[R; 3]]);
/// A register for each component of a vector.
pub(super) type Vectors<P, V> = [Register<P, V, 3>; 3];

/// The fields of each vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Field {
    Position,
    Normal,
    Tangent,
}

/// A slice for each field.
pub(super) struct Separate<'s, P> {
    pub(super) rest: Surface<'s, P>,
    pub(super) posed: SurfaceMut<'s, P>,
}

#[cfg(feature = "rayon")]
impl<P: Element<3>> Outputs for Separate<'_, P> {
    fn things(&self) -> usize {
        self.posed.positions.len() * P::Layout::THINGS
    }
    fn split(self, at: usize) -> (Self, Self) {
        let at = (at / P::Layout::THINGS).min(self.posed.positions.len());
        let (rest, others) = self.rest.split(at, <[P]>::split_at);
        let (posed, to_others) = self.posed.split(at, <[P]>::split_at_mut);
        (Self { rest, posed }, Self { rest: others, posed: to_others })
    }
}

impl<P: Element<3>> Mesh<P> for Separate<'_, P> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn elements(&self) -> usize {
        self.posed.positions.len()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(&self, level: V, field: Field, tile: Tile) -> Option<Vectors<P, V>> {
        let from = match field {
            Field::Position => self.rest.positions,
            Field::Normal => self.rest.normals?,
            Field::Tangent => self.rest.tangents?,
        };
        P::load(level, from, tile, &storage::identity())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn points(&mut self) -> Option<PlainPoints<'_, Number<P, 3>>> {
        if self.rest.normals.is_some() || self.rest.tangents.is_some() {
            return None;
        }
        Some((P::plain(self.rest.positions)?, P::plain_mut(self.posed.positions)?))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(&mut self, vectors: Vectors<P, V>, field: Field, tile: Tile) {
        let to = match field {
            Field::Position => Some(&mut *self.posed.positions),
            Field::Normal => self.posed.normals.as_deref_mut(),
            Field::Tangent => self.posed.tangents.as_deref_mut(),
        };
        if let Some(to) = to {
            P::store(vectors, to, tile);
        }
    }
}
