//! Bytes that somebody changed: refused with an offset, or played without a panic and unit.
//!
//! `DQ8_PACKED_FILES` says how many files (600 by default).

use super::{JOINTS, PARENTS, library};
use dq8::hierarchy::{PackedClip, PackedClips, PackedError, Sampled};
use dq8::law::NlerpLerp;
use dq8::{DualQuat, Hierarchy};
use dq8_contract::random::Random;

/// Changes a byte or some, to numbers that hurt now and then.
fn change(random: &mut Random, bytes: &mut Vec<u8>) {
    // Keys are most of a file: what leads to them is changed as often.
    let any = random.below(bytes.len());
    let keys = u32::from_le_bytes(bytes[20..24].try_into().unwrap()) as usize;
    let after = (24 + 8 * keys.min(1 << 20)).min(bytes.len() - 1);
    let place = match random.below(4) {
        0 => random.below(24),
        1 => any,
        _ => after + random.below(bytes.len() - after),
    };
    match random.below(6) {
        0 => bytes[place] ^= 1 << random.below(8),
        1 => bytes[place] = random.below(256) as u8,
        2 => bytes[place..].iter_mut().take(4).for_each(|byte| *byte = 0xff),
        3 => bytes[place..].iter_mut().take(4).for_each(|byte| *byte = 0),
        4 if random.below(8) == 0 => bytes.truncate(place.max(24)),
        _ => bytes[place] = bytes[place].wrapping_add(1),
    }
}

#[test]
fn changed_bytes_are_refused_with_an_offset_or_played_without_panic_and_unit() {
    let packed = library();
    let hierarchy = Hierarchy::new(&PARENTS).unwrap();
    let files = std::env::var("DQ8_PACKED_FILES").map_or(600, |files| files.parse().unwrap());
    let (mut refused, mut samples, mut off) = (0_u64, 0_u64, 0.0_f64);
    let mut random = Random(std::env::var("DQ8_FUZZ_SEED").map_or(1, |seed| seed.parse().unwrap()));
    for file in 0..files {
        let mut bytes = packed.as_bytes().to_vec();
        for _ in 0..=random.below(3) {
            change(&mut random, &mut bytes);
        }
        let clips = match PackedClips::from_bytes(&bytes) {
            Ok(clips) => clips,
            Err(PackedError::Bytes { offset, .. }) => {
                assert!(offset <= bytes.len(), "{offset} of {}", bytes.len());
                refused += 1;
                continue;
            }
            Err(error) => panic!("{error}"),
        };
        let (places, t): (Vec<_>, Vec<_>) = (0..3)
            .filter_map(|_| {
                clips.place(random.below(clips.clips().max(1)), random.between(-2.0, 50.0) as f32)
            })
            .unzip();
        let sampled = Sampled::new(NlerpLerp, clips, &places, &t).unwrap();
        let mut models = vec![DualQuat::<f32>::IDENTITY; places.len() * JOINTS];
        if hierarchy.job().locals_to_model(sampled, &mut models).is_ok() {
            for model in &models {
                let [x, y, z, w] = model.rotation().to_array().map(f64::from);
                off = off.max(((x * x + y * y + z * z + w * w).sqrt() - 1.0).abs());
            }
            samples += models.len() as u64;
        }
        assert!(off < 2e-6, "file {file}: {off} off unit");
    }
    // Both happen, or this tests nothing.
    assert!(refused > files / 5 && samples > files, "{refused} refused, {samples} samples, {off}");
    println!("{files} files, {refused} refused; {samples} samples, off unit by at most {off:.1e}");
}

#[test]
fn bytes_cut_anywhere_or_longer_are_refused_where_they_end() {
    let packed = library();
    let bytes = packed.as_bytes();
    for end in 0..bytes.len() {
        let Err(PackedError::Bytes { offset, .. }) = PackedClips::from_bytes(&bytes[..end]) else {
            panic!("{end} bytes are taken");
        };
        assert!(offset == if end < 8 { 0 } else { end }, "{offset} of {end}");
    }
    let longer = [bytes, &[0]].concat();
    let wrong = |bytes: Vec<u8>| match PackedClip::from_bytes(bytes.into()) {
        Err(PackedError::Bytes { offset, what }) => (offset, what),
        other => panic!("{other:?}"),
    };
    assert_eq!(wrong(longer), (bytes.len(), "something follows them"));
    let mut other = bytes.to_vec();
    other[8] = 2;
    assert_eq!(wrong(other), (8, "their version is another"));
    let mut other = bytes.to_vec();
    other[24 + 7] = 0x40;
    assert_eq!(wrong(other).1, "rotations of a joint are not unit, or 60° apart");
    let rests = 24 + 8 * u32::from_le_bytes(bytes[20..24].try_into().unwrap()) as usize;
    let mut other = bytes.to_vec();
    other[rests + 16 * 2..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_eq!(wrong(other), (rests + 32, "a rest is not finite"));
}
