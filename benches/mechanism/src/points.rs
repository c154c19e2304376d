//! Points on links as a user has them without dq8's own job: a kernel over poses in blocks.

use dq8::batch::{self, vector};
use dq8::storage::{self, Element, Layout, Number, Tile};
use dq8::{Kernel, Level};

/// How many spheres a collision model of an arm has.
pub const COUNT: usize = 59;

/// Centres of spheres on all links, as many on each; a third of the coordinates is zero.
pub fn spheres(links: usize) -> [(usize, [f64; 3]); COUNT] {
    core::array::from_fn(|index| {
        let at = |which: usize| 0.01 * ((index + which) % 3) as f64;
        (index * links / COUNT, [at(0), at(1), at(2)])
    })
}

/// Centres from poses: both in blocks.
pub struct Points<'s, E, P: Element<3>> {
    pub poses: &'s [E],
    pub points: &'s [(usize, [Number<P, 3>; 3])],
    pub places: &'s mut [P],
    pub links: usize,
}

impl<E, P> Kernel for Points<'_, E, P>
where
    P: Element<3>,
    E: Element<8, Layout = P::Layout>,
{
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        for block in 0..self.poses.len() / self.links {
            for register in 0..<P::Layout as Layout>::registers::<V>() {
                let (mut last, mut rows) = (usize::MAX, None);
                for (index, &(link, point)) in self.points.iter().enumerate() {
                    if link != last {
                        let tile = Tile::at(block * self.links + link, register);
                        let pose = E::load(level, self.poses, tile, &storage::identity());
                        rows = pose.map(
                            #[inline(always)]
                            |pose| batch::DualQuat::from_array(pose).to_matrix3x4(),
                        );
                        last = link;
                    }
                    let Some([[a, b, c, x], [d, e, f, y], [g, h, i, z]]) = rows else { return };
                    let [px, py, pz] = vector::splat(level, point);
                    let place = vector::scale_onto([c, f, i], pz, [x, y, z]);
                    let place = vector::scale_onto([b, e, h], py, place);
                    let place = vector::scale_onto([a, d, g], px, place);
                    let tile = Tile::at(block * self.points.len() + index, register);
                    P::store(place, self.places, tile);
                }
            }
        }
    }
}
