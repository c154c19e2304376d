//! Hierarchy concatenation: nanoseconds a joint of a crowd, this crate beside its peers.
//!
//! One skeleton of 64 joints ([`skeleton`]), crowds of 1 to 8192 instances, out of place and in
//! place. Lanes run with every set of instructions that the CPU has; a crowd of 1 has nothing for
//! them. Every contender gets the same poses in its own representation and is compared with `f64`
//! matrices before it is timed. Throughput counts joints × instances. The groups [`one_instance`]
//! compare the strategies for a crowd of 1.
//!
//! ```text
//! cargo bench --bench hierarchy -- crowd/1024/in-place
//! cargo bench --bench hierarchy -- lanes-f32x8-AVX2
//! cargo bench --bench hierarchy -- one-instance
//! ```

mod contender;
mod crowd;
#[path = "../measurement/mod.rs"]
mod measurement;
mod one_instance;
mod race;
#[path = "../representation/mod.rs"]
mod representation;
#[path = "../rows/mod.rs"]
mod rows;
mod scalar;
mod skeleton;
mod square;
#[path = "../walk/mod.rs"]
mod walk;

use contender::{Own, Peer};
use criterion::{Criterion, criterion_group, criterion_main};
use crowd::Place;
use dq8::{Block, DualQuat};
use glam::{Affine3A, Mat4};
use nalgebra::{Isometry3, UnitDualQuaternion};
use race::Race;
use rows::Rows3x4;
use square::Rows4x4;

fn crowds(criterion: &mut Criterion) {
    for instances in [1, 8, 64, 1024, 8192] {
        for place in [Place::Out, Place::In] {
            let mut race = Race::new(criterion, instances, place);
            race.run::<Peer<DualQuat<f32>>>("scalar-f32");
            race.run_on_every_backend::<Own<DualQuat<f32>>>("plain-f32");
            if instances > 1 {
                race.run_on_every_backend::<Own<Block<f32, 4>>>("lanes-f32x4");
                race.run_on_every_backend::<Own<Block<f32, 8>>>("lanes-f32x8");
                race.run_on_every_backend::<Own<Block<f32, 16>>>("lanes-f32x16");
            }
            race.run::<Peer<Rows3x4<f32>>>("rows-3x4");
            race.run::<Peer<Rows4x4<f32>>>("rows-4x4");
            race.run::<Peer<Affine3A>>("glam-Affine3A");
            race.run::<Peer<Mat4>>("glam-Mat4");
            race.run::<Peer<UnitDualQuaternion<f32>>>("nalgebra-UnitDualQuaternion");
            race.run::<Peer<Isometry3<f32>>>("nalgebra-Isometry3");
        }
    }
}

criterion_group! { name = hierarchy; config = measurement::brief(); targets = crowds, one_instance::skeletons, one_instance::chains }
criterion_main!(hierarchy);
