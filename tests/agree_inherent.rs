//! What the lane types have beside the contract: records and blocks in memory.

use dq8::{Lanes, Real, Scalar, batch, scalar, simd::Portable};
use dq8_contract::inputs;
use dq8_contract::on_every_lane_type;
use dq8_contract::sample::Proof;
use dq8_simd::{Block, Row};

fn round<R: Scalar>(numbers: [f64; 8]) -> [R; 8] {
    numbers.map(<R as Real>::from_f64)
}

#[test]
fn records_fill_the_first_lanes_and_the_others_hold_the_identity() {
    fn check<L: Lanes<Level: Proof, Real: Scalar>>() {
        let name = std::any::type_name::<L>();
        let motions: Vec<_> = inputs::edge_motions().into_iter().map(round::<L::Real>).collect();
        let identity = scalar::DualQuat::<L::Real>::IDENTITY.to_array();
        for length in 0..=2 * L::LANES + 1 {
            let records = &motions[40..40 + length];
            let loaded = batch::DualQuat::<L>::load_records(L::Level::proof(), records).to_array();
            let rows = loaded.map(Lanes::to_array);
            for lane in 0..L::LANES {
                let held: [L::Real; 8] = std::array::from_fn(|c| rows[c].as_ref()[lane]);
                let wanted = *records.get(lane).unwrap_or(&identity);
                assert_eq!(held, wanted, "{name}: lane {lane} of {length} records");
            }
        }
    }
    on_every_lane_type!(check());
}

#[test]
fn records_beyond_the_lanes_are_left_alone() {
    fn check<L: Lanes<Level: Proof, Real: Scalar>>() {
        let name = std::any::type_name::<L>();
        let motions: Vec<_> = inputs::edge_motions().into_iter().map(round::<L::Real>).collect();
        let untouched = round::<L::Real>([9.0; 8]);
        for length in 0..=2 * L::LANES + 1 {
            let mut records = vec![untouched; length];
            batch::DualQuat::<L>::load_records(L::Level::proof(), &motions[40..])
                .store_records(&mut records);
            for (i, record) in records.iter().enumerate() {
                let wanted = if i < L::LANES { motions[40 + i] } else { untouched };
                assert_eq!(*record, wanted, "{name}: record {i} of {length}");
            }
        }
    }
    on_every_lane_type!(check());
}

/// A slice of any length, a chunk of lanes at a time, the last one partial.
#[test]
fn a_slice_gives_the_same_bits_whatever_its_length() {
    fn step<L: Lanes<Level: Proof>>(motion: batch::DualQuat<L>, t: L) -> batch::DualQuat<L> {
        (motion.normalize() * motion).pow(t)
    }
    fn check<L: Lanes<Level: Proof, Real: Scalar>>() {
        let name = std::any::type_name::<L>();
        let motions: Vec<_> = inputs::edge_motions().into_iter().map(round::<L::Real>).collect();
        let t = <L as Lanes>::splat(L::Level::proof(), <L::Real as From<f32>>::from(0.75));
        for length in 0..=2 * L::LANES + 1 {
            let mut records = motions[60..60 + length].to_vec();
            for chunk in records.chunks_mut(L::LANES) {
                step(batch::DualQuat::<L>::load_records(L::Level::proof(), chunk), t)
                    .store_records(chunk);
            }
            for (i, record) in records.iter().enumerate() {
                let mut alone = [round::<L::Real>([9.0; 8])];
                let splat = batch::DualQuat::<L>::splat(L::Level::proof(), motions[60 + i]);
                step(splat, t).store_records(&mut alone);
                assert_eq!(*record, alone[0], "{name}: record {i} of {length}");
            }
        }
    }
    on_every_lane_type!(check());
}

#[test]
fn a_block_gives_back_what_was_stored() {
    fn check<A: Row<Real: Scalar>, V: Proof>() {
        let motions = inputs::edge_motions();
        let mut block = Block::<A, 8>::splat(round([9.0; 8]));
        for lane in 0..A::LANES {
            assert!(block.set(lane, round(motions[40 + lane])).is_ok());
        }
        let level = V::proof();
        let loaded = batch::DualQuat::<A::Lanes<V>>::load(level, &block);
        let mut copy = Block::<A, 8>::splat(round([0.0; 8]));
        (-loaded).store(&mut copy);
        for lane in 0..A::LANES {
            let negated = motions[40 + lane].map(|c| -c);
            assert_eq!(copy.get(lane), Some(round(negated)), "lane {lane} of {}", A::LANES);
        }
    }
    fn every_length<V: Proof>() {
        if V::is_there() {
            check::<[f32; 4], V>();
            check::<[f32; 8], V>();
            check::<[f32; 16], V>();
            check::<[f64; 2], V>();
            check::<[f64; 4], V>();
            check::<[f64; 8], V>();
        }
    }
    every_length::<Portable>();
    #[cfg(target_arch = "x86_64")]
    {
        every_length::<dq8_contract::sample::Avx2>();
        every_length::<dq8_contract::sample::Avx512>();
    }
}
