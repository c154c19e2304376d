//! Packing of clips: a page needs it when it makes files, and not when it plays them. So it is a
//! module of its own, which the others are not larger for.

use crate::memory::{exports, frees};
use dq8::ShapeError;
use dq8::hierarchy::{Clip, PackedClip, PackedError, Tolerance};
use std::ptr;

type Key = [f32; 7];

/// A clip, as JavaScript writes it: how many of the keys are its own, its frames a second, and 1 if
/// it loops.
type Head = [f64; 3];

/// The number of an error, the clip, the frame and the joint where it is, and the number that is
/// wrong there. JavaScript has the texts: what writes numbers as text is larger than what packs.
type Fault = [f64; 5];

fn pack(
    joints: usize,
    heads: &[Head],
    mut keys: &[Key],
    tolerance: Tolerance,
) -> Result<PackedClip, PackedError> {
    let mut clips = Vec::with_capacity(heads.len());
    for &[count, rate, loops] in heads {
        let (expected, length) = (count as usize, keys.len());
        let (own, rest) = keys.split_at_checked(expected).ok_or(ShapeError::Length {
            what: "keys",
            length,
            expected,
        })?;
        keys = rest;
        let clip = Clip::new(joints, own)?.with_rate(rate);
        clips.push(if loops == 0.0 { clip } else { clip.looping() });
    }
    PackedClip::library(&clips, tolerance)
}

fn fault(error: &PackedError) -> Fault {
    match *error {
        PackedError::NotUnit { clip, frame, joint, length } => {
            [1.0, clip as f64, frame as f64, joint as f64, length]
        }
        PackedError::Beyond { clip, frame, joint, value } => {
            [2.0, clip as f64, frame as f64, joint as f64, value.into()]
        }
        PackedError::Rate { clip, rate } => [3.0, clip as f64, 0.0, 0.0, rate],
        PackedError::TooLarge => [4.0, 0.0, 0.0, 0.0, 0.0],
        // Shapes have been checked, and the bytes are those that have just been made.
        _ => [0.0; 5],
    }
}

frees!(dq8_packed_free: PackedClip);
exports! {
    fn dq8_pack(joints: usize, angle: f32, length: f32; heads[clips]: Head, keys[count]: Key; faults[fault_count]: Fault) -> *mut PackedClip {
        match pack(joints, heads, keys, Tolerance { angle, length }) {
            Ok(packed) => Box::into_raw(Box::new(packed)),
            Err(error) => {
                faults.fill(fault(&error));
                ptr::null_mut()
            }
        }
    }

    fn dq8_packed_bytes(packed: &PackedClip;;) -> *const u8 {
        packed.as_bytes().as_ptr()
    }

    fn dq8_packed_length(packed: &PackedClip;;) -> usize {
        packed.as_bytes().len()
    }
}
