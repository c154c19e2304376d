//! Bytes that somebody changed: refused with an offset, or played without a panic and unit.
//!
//! `DQ8_PACKED_FILES` says how many files (600 by default); `DQ8_FUZZ_SEED` from where.

use super::{Book, JOINTS, PARENTS, library};
use dq8::hierarchy::{PackedClip, PackedClips, PackedError, Sampled, TrackPlace};
use dq8::law::NlerpLerp;
use dq8::{Backend, DualQuat, Hierarchy};
use dq8_contract::random::Random;

/// Changes a byte or some, to numbers that hurt now and then; gives back where the file ends.
fn change(random: &mut Random, bytes: &mut [u8]) -> usize {
    // Keys are most of a file: what leads to them is changed as often.
    let any = random.below(bytes.len());
    let [after, ..] = Book::new(bytes).sections();
    let after = after.min(bytes.len() - 1);
    let place = match random.below(4) {
        0 => random.below(32),
        1 => any,
        _ => after + random.below(bytes.len() - after),
    };
    match random.below(6) {
        0 => bytes[place] ^= 1 << random.below(8),
        1 => bytes[place] = random.below(256) as u8,
        2 => bytes[place..].iter_mut().take(4).for_each(|byte| *byte = 0xff),
        3 => bytes[place..].iter_mut().take(4).for_each(|byte| *byte = 0),
        4 if random.below(8) == 0 => return place.max(32),
        _ => bytes[place] = bytes[place].wrapping_add(1),
    }
    bytes.len()
}

#[test]
fn changed_bytes_are_refused_with_an_offset_or_played_without_panic_and_unit() {
    const PLACES: usize = 3;
    let packed = library();
    let whole = packed.as_bytes();
    let hierarchy = Hierarchy::new(&PARENTS).unwrap();
    let backends: Vec<_> = Backend::available().collect();
    let files = std::env::var("DQ8_PACKED_FILES").map_or(600, |files| files.parse().unwrap());
    let (mut refused, mut samples, mut most) = (0_u64, 0_u64, 0.0_f64);
    let mut random = Random(std::env::var("DQ8_FUZZ_SEED").map_or(1, |seed| seed.parse().unwrap()));
    let mut bytes = whole.to_vec();
    let (mut places, mut t) = ([TrackPlace::default(); PLACES], [0.0_f32; PLACES]);
    let mut models = [DualQuat::<f32>::IDENTITY; PLACES * JOINTS];
    for file in 0..files {
        bytes.copy_from_slice(whole);
        let mut end = bytes.len();
        for _ in 0..=random.below(3) {
            end = end.min(change(&mut random, &mut bytes));
        }
        let bytes = &bytes[..end];
        let clips = match PackedClips::from_bytes(bytes) {
            Ok(clips) => clips,
            Err(PackedError::Bytes { offset, .. }) => {
                assert!(offset <= bytes.len(), "file {file}: {offset} of {}", bytes.len());
                refused += 1;
                continue;
            }
            Err(error) => panic!("file {file}: {error}"),
        };
        assert!(Book::new(bytes).leads_to_keys(), "file {file}");
        let mut placed = 0;
        for _ in 0..PLACES {
            let clip = random.below(clips.clips().max(1));
            if let Some(at) = clips.place(clip, random.between(-2.0, 50.0) as f32) {
                (places[placed], t[placed]) = at;
                placed += 1;
            }
        }
        let sampled = Sampled::new(NlerpLerp, clips, &places[..placed], &t[..placed]).unwrap();
        let models = &mut models[..placed * JOINTS];
        let job = hierarchy.job().backend(backends[random.below(backends.len())]);
        if job.locals_to_model(sampled, models).is_ok() {
            for model in models.iter() {
                let [x, y, z, w] = model.rotation().to_array().map(f64::from);
                let off = ((x * x + y * y + z * z + w * w).sqrt() - 1.0).abs();
                assert!(off < 2e-6, "file {file}: {off} off unit");
                most = most.max(off);
            }
            samples += models.len() as u64;
        }
    }
    // Both happen, or this tests nothing.
    assert!(refused > files / 5 && samples > files, "{refused} refused, {samples} samples");
    println!("{files} files, {refused} refused; {samples} samples, off unit by at most {most:.1e}");
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
    assert_eq!(wrong(longer), (bytes.len(), "bytes after the end"));
    let mut other = bytes.to_vec();
    other[8] = 1;
    assert_eq!(wrong(other), (8, "unsupported version"));
    let mut other = bytes.to_vec();
    other[32 + 7] = 0x40;
    assert_eq!(wrong(other), (32, "rotations of a joint are not unit, or 60° apart"));
    let rests = 32 + 8 * u32::from_le_bytes(bytes[20..24].try_into().unwrap()) as usize;
    let mut other = bytes.to_vec();
    other[rests + 16 * 2..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_eq!(wrong(other), (rests + 32, "a rest is not finite"));
    // Four billion frames of keys that never change would be checked for minutes.
    let [_, clips, rows] = Book::new(bytes).sections();
    let mut other = bytes.to_vec();
    other[clips + 4..][..8].copy_from_slice(&[0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0]);
    assert_eq!(wrong(other), (rows, "a track has keys that are not there"));
    let mut other = bytes.to_vec();
    other[rows + 2 * 5..][..2].fill(0xff);
    assert_eq!(wrong(other), (rows + 10, "a track has keys that are not there"));
    // Frames a second that are none, and a clip that neither loops nor ends.
    let timings = rows - 12 * Book::new(bytes).clips;
    let wrong_rates = [f32::NAN, 0.0, -30.0, f32::INFINITY].map(|rate| (rate, 0.0_f32, 1 << 16));
    for (rate, rest, loops) in wrong_rates.into_iter().chain([
        (30.0, 0.0, 2),
        (30.0, 1.0, 1 << 16),
        (30.0, 0.0, 3 << 16),
        (30.0, 0.0, 0),
        (30.0, 0.0, 5 << 16),
    ]) {
        let mut other = bytes.to_vec();
        let words = [rate.to_bits(), rest.to_bits(), loops].map(u32::to_le_bytes);
        other[timings + 12..][..12].copy_from_slice(words.as_flattened());
        let (offset, what) = wrong(other);
        assert!(offset == timings + 12 && what.contains("the rate of a clip"), "{what}");
    }
    // Frames that are none, keys beyond the last, rows beyond the last.
    for (word, number) in [(1, 0), (0, 0xff), (3, 3)] {
        let mut other = bytes.to_vec();
        other[clips + 16 + 4 * word..][..4].fill(number);
        let Err(PackedError::Bytes { offset, what }) = PackedClip::from_bytes(other.into()) else {
            panic!("word {word} is taken");
        };
        assert_eq!(
            (offset, what),
            (clips + 16, "a clip has no such frames, keys or row"),
            "word {word}"
        );
    }
}

/// Joints, clips and keys as many as each other, whose clips have all keys in common: every key is
/// a frame of every joint of every clip. Read as they say, 10⁵ bytes would take minutes.
#[test]
fn bytes_whose_clips_share_their_keys_are_refused_before_they_are_read() {
    for n in [2, 100, 1600_u32] {
        let mut bytes = b"dq8clips".to_vec();
        let mut words =
            |numbers: &[u32]| bytes.extend(numbers.iter().flat_map(|n| n.to_le_bytes()));
        words(&[3, n, n, n, 1, 0]);
        for _ in 0..n {
            words(&[0, 32767 << 16]); // the rotation that turns nothing
        }
        for _ in 0..n {
            words(&[0; 4]); // a rest
        }
        for _ in 0..n {
            words(&[0, n, 1, 0]); // all keys, each a frame
        }
        for _ in 0..n {
            words(&[1.0_f32.to_bits(), 0, 1 << 16]); // a frame a second
        }
        words(&vec![0x0001_0001; n as usize]); // both tracks of a joint move
        // It is the table of clips that says so.
        let head = 32 + 24 * n as usize;
        let refused = |what: &str, bytes: &[u8]| match PackedClips::from_bytes(bytes) {
            Err(PackedError::Bytes { what: found, offset }) => {
                assert!(found.contains(what) && offset == head, "{found} at {offset}");
            }
            other => panic!("{n}: {other:?}"),
        };
        refused("than there are keys", &bytes);
        // One clip, whose joints share them: work that grows with the square.
        let timings = head + 16 * n as usize;
        let mut one = bytes[..head + 16].to_vec();
        one.extend(&bytes[timings..timings + 12]);
        one.extend(&bytes[timings + 12 * n as usize..]);
        one[16..20].copy_from_slice(&1_u32.to_le_bytes());
        refused("than there are keys", &one);
    }
}
