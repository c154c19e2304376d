//! Clips, and poses sampled from them, one over the other.

use crate::Motion;
use crate::error::made;
use crate::memory::{exports, frees, slice};
use dq8::ShapeError;
use dq8::hierarchy::{
    Either, Frames, Layered, OwnedClip, PackedClip, Playback, RotationsTranslations, Sampled,
    TrackPlace,
};
use dq8::law::{NlerpLerp, SlerpLerp};

type Key = [f32; 7];

/// Keys of one clip, or packed ones of many.
#[derive(Debug)]
pub(crate) enum Clip {
    /// `[frame][joint]` of rotation x, y, z, w and translation.
    Plain(OwnedClip<Key>),
    Packed(PackedClip),
}

impl Clip {
    fn new(joints: usize, rate: f64, loops: bool, keys: &[Key]) -> Result<Self, ShapeError> {
        let clip = OwnedClip::new(joints, keys)?.with_rate(rate);
        Ok(Self::Plain(if loops { clip.looping() } else { clip }))
    }

    /// From the first frame to the last, of packed clips of that `number`; 0 if there is no such
    /// clip.
    fn duration(&self, number: usize) -> f64 {
        match self {
            Self::Plain(clip) => clip.view().duration(),
            Self::Packed(packed) => packed.clips().duration(number).unwrap_or(0.0),
        }
    }
}

type Plain<'s> = Sampled<'s, NlerpLerp, Frames<'s, Key, f32>, f32, 7>;
/// Poses of a clip.
type Played<'s> = Either<Plain<'s>, Sampled<'s, NlerpLerp, Playback<'s>, f32, 7>>;
/// Poses of a clip, or poses that lie in memory, as those of layers below do.
type Sample<'s> = Either<Played<'s>, RotationsTranslations<'s, Key>>;
type Layers<'s, W, const ADDS: bool> = Layered<'s, W, Sample<'s>, Sample<'s>, f32, 7, ADDS>;
type Blended<'s> = Either<Layers<'s, NlerpLerp, false>, Layers<'s, SlerpLerp, false>>;
/// Poses of one sample, or of one over another: one kernel for all of them, and not ten.
pub(crate) type Poses<'s> = Either<Sample<'s>, Either<Blended<'s>, Layers<'s, NlerpLerp, true>>>;

/// Where in a clip each instance is, kept so that no frame of an animation allocates.
#[derive(Debug, Default)]
pub(crate) struct Places {
    frames: Vec<u32>,
    places: Vec<TrackPlace>,
    t: Vec<f32>,
}

/// A clip, and where in it instances are, as JavaScript writes it; or poses that lie in memory.
#[derive(Debug)]
#[repr(C)]
struct Playing {
    /// Null if there is none.
    clip: *const Clip,
    /// Times in the clip; without a clip they are poses of seven numbers, and null if there are
    /// none of those either.
    at: *const f32,
    at_count: usize,
    /// Which of packed clips each instance plays; null if all play the same.
    clips: *const f32,
    clip_count: usize,
    number: u32,
}

impl Playing {
    fn is_missing(&self) -> bool {
        self.clip.is_null() && self.at.is_null()
    }

    /// `None` if there is neither a clip nor a pose.
    ///
    /// # Safety
    /// All that it names is there.
    unsafe fn sample<'s>(
        &'s self,
        places: &'s mut Places,
    ) -> Result<Option<Sample<'s>>, ShapeError> {
        // SAFETY: promised.
        let Some(clip) = (unsafe { self.clip.as_ref() }) else {
            // SAFETY: promised.
            let poses = || unsafe { slice(self.at.cast::<Key>(), self.at_count) };
            return Ok((!self.is_missing()).then(|| Either::Other(RotationsTranslations(poses()))));
        };
        // SAFETY: promised.
        let at = unsafe { slice(self.at, self.at_count) };
        let Places { frames, places, t } = places;
        t.clear();
        let sample = match clip {
            Clip::Plain(clip) => {
                let clip = clip.view();
                frames.clear();
                for &at in at {
                    let (frame, part) = clip.place(at);
                    frames.push(frame);
                    t.push(part);
                }
                Either::One(Sampled::new(NlerpLerp, clip, frames, t)?)
            }
            Clip::Packed(packed) => {
                let packed = packed.clips();
                // SAFETY: promised.
                let each = unsafe { slice(self.clips, self.clip_count) };
                if !self.clips.is_null() && each.len() != at.len() {
                    let (what, length) = ("clips", each.len());
                    return Err(ShapeError::Length { what, length, expected: at.len() });
                }
                places.clear();
                for (instance, &at) in at.iter().enumerate() {
                    let clip = match each.get(instance) {
                        Some(&clip) if clip as u32 as f32 == clip => clip as usize,
                        Some(_) => usize::MAX,
                        None => self.number as usize,
                    };
                    let place = packed.place(clip, at).ok_or(ShapeError::NoPlace { instance });
                    let (place, part) = place?;
                    places.push(place);
                    t.push(part);
                }
                Either::Other(Sampled::new(NlerpLerp, packed, places, t)?)
            }
        };
        Ok(Some(Either::One(sample)))
    }
}

/// What poses are made of, as JavaScript writes it.
#[derive(Debug)]
#[repr(C)]
pub(crate) struct Source {
    base: Playing,
    layer: Playing,
    weights: *const f32,
    weight_count: usize,
    /// Null if there is none.
    mask: *const f32,
    mask_count: usize,
    /// 0 blends by [`NlerpLerp`], 1 by [`SlerpLerp`]; 2 adds.
    kind: u32,
    locals: *const Motion,
    local_count: usize,
}

impl Source {
    /// Whether it is locals that lie there.
    pub(crate) fn is_at(&self, models: *const Motion) -> bool {
        self.base.is_missing() && self.locals == models
    }

    /// Locals that lie in memory, if there is no clip.
    ///
    /// # Safety
    /// They are there.
    pub(crate) unsafe fn locals(&self) -> Option<&[Motion]> {
        // SAFETY: promised.
        self.base.is_missing().then(|| unsafe { slice(self.locals, self.local_count) })
    }

    /// Poses of clips.
    ///
    /// # Safety
    /// All that it names is there.
    pub(crate) unsafe fn poses<'s>(
        &'s self,
        [base, layer]: &'s mut [Places; 2],
    ) -> Result<Poses<'s>, ShapeError> {
        // SAFETY: promised.
        let (base, layer) = unsafe { (self.base.sample(base)?, self.layer.sample(layer)?) };
        let Some(base) = base else { return Err(ShapeError::Empty { what: "locals" }) };
        let Some(layer) = layer else { return Ok(Either::One(base)) };
        // SAFETY: promised.
        let of = |at, count| unsafe { slice(at, count) };
        let weights = of(self.weights, self.weight_count);
        let mask = (!self.mask.is_null()).then(|| of(self.mask, self.mask_count));
        let blended = |both| Either::Other(Either::One(both));
        Ok(match self.kind {
            0 => {
                blended(Either::One(masked(Layered::blend(NlerpLerp, base, layer, weights), mask)))
            }
            1 => blended(Either::Other(masked(
                Layered::blend(SlerpLerp, base, layer, weights),
                mask,
            ))),
            _ => {
                let both = masked(Layered::add(NlerpLerp, base, layer, weights), mask);
                Either::Other(Either::Other(both))
            }
        })
    }
}

/// Layers with a mask, if there is one.
fn masked<'s, W, const ADDS: bool>(
    layers: Layers<'s, W, ADDS>,
    mask: Option<&'s [f32]>,
) -> Layers<'s, W, ADDS> {
    match mask {
        Some(mask) => layers.mask(mask),
        None => layers,
    }
}

frees!(dq8_clip_free: Clip);
exports! {
    fn dq8_clip(joints: usize, rate: f64, loops: u32; keys[count]: Key;) -> *mut Clip {
        made(Clip::new(joints, rate, loops != 0, keys))
    }

    fn dq8_clip_duration(clip: &Clip, number: usize;;) -> f64 {
        clip.duration(number)
    }

    fn dq8_packed_clip(; bytes[count]: u8;) -> *mut Clip {
        made(PackedClip::from_bytes(bytes.into()).map(Clip::Packed))
    }

    /// How many packed clips there are.
    fn dq8_packed_clip_clips(clip: &Clip;;) -> usize {
        if let Clip::Packed(packed) = clip { packed.clips().clips() } else { 0 }
    }

    /// How many frames one of them has; 0 if there is no such clip.
    fn dq8_packed_clip_frames(clip: &Clip, number: usize;;) -> usize {
        let Clip::Packed(packed) = clip else { return 0 };
        packed.clips().frames(number).unwrap_or(0)
    }
}
