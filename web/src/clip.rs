//! Clips, and poses sampled from them, one over the other.

use crate::Motion;
use crate::memory::{made, slice};
use dq8::ShapeError;
use dq8::hierarchy::{self, Frames, Layered, Sampled};
use dq8::law::NlerpLerp;

type Key = [f32; 7];

/// Keys `[frame][joint]` of rotation x, y, z, w and translation. Not dq8's own, whose times in seconds nobody asks for here:
/// they are half a kilobyte.
#[derive(Debug)]
pub(crate) struct Clip {
    keys: Box<[Key]>,
    joints: usize,
}

impl Clip {
    fn new(joints: usize, keys: &[Key]) -> Result<Self, ShapeError> {
        hierarchy::Clip::new(joints, keys)?;
        Ok(Self { keys: keys.into(), joints })
    }

    fn view(&self) -> Result<hierarchy::Clip<'_, Key>, ShapeError> {
        hierarchy::Clip::new(self.joints, &self.keys)
    }
}

/// Where in a clip each instance is, kept so that no frame of an animation allocates.
#[derive(Debug, Default)]
pub(crate) struct Places {
    frames: Vec<u32>,
    t: Vec<f32>,
}

impl Places {
    fn sample<'s>(
        &'s mut self,
        clip: &'s Clip,
        at: &[f32],
    ) -> Result<Sampled<'s, NlerpLerp, Frames<'s, Key, f32>, f32, 7>, ShapeError> {
        let view = clip.view()?;
        self.frames.clear();
        self.t.clear();
        for &at in at {
            let (frame, t) = view.place(at);
            self.frames.push(frame);
            self.t.push(t);
        }
        Sampled::new(NlerpLerp, view, &self.frames, &self.t)
    }
}

/// What poses are made of, as JavaScript writes it.
#[derive(Debug)]
#[repr(C)]
pub(crate) struct Source {
    /// Null if these are the poses of `locals`.
    base: *const Clip,
    at: *const f32,
    at_count: usize,
    /// Null if there is none.
    layer: *const Clip,
    layer_at: *const f32,
    layer_at_count: usize,
    weights: *const f32,
    weight_count: usize,
    /// Null if there is none.
    mask: *const f32,
    mask_count: usize,
    adds: u32,
    locals: *const Motion,
    local_count: usize,
}

/// What is done with poses, compiled for each form that they have.
pub(crate) trait Visitor: Sized {
    fn visit<L: hierarchy::Locals<Motion>>(self, locals: L) -> Result<(), ShapeError>;
    /// Of one clip blended into another.
    fn blend<L: hierarchy::Locals<Motion>>(self, locals: L) -> Result<(), ShapeError> {
        self.visit(locals)
    }
}

impl Source {
    /// Where plain locals lie.
    pub(crate) fn locals(&self) -> Option<*const Motion> {
        self.base.is_null().then_some(self.locals)
    }

    /// # Safety
    /// All that it names is there.
    pub(crate) unsafe fn visit(
        &self,
        [base, layer]: &mut [Places; 2],
        visitor: impl Visitor,
    ) -> Result<(), ShapeError> {
        // SAFETY: promised.
        let of = |at, count| unsafe { slice(at, count) };
        // SAFETY: promised.
        let (base_clip, layer_clip) = unsafe { (self.base.as_ref(), self.layer.as_ref()) };
        let Some(base_clip) = base_clip else {
            // SAFETY: promised.
            let locals = unsafe { slice(self.locals, self.local_count) };
            return visitor.visit(hierarchy::Poses(locals));
        };
        let base = base.sample(base_clip, of(self.at, self.at_count))?;
        let Some(layer_clip) = layer_clip else {
            return visitor.visit(base);
        };
        let layer = layer.sample(layer_clip, of(self.layer_at, self.layer_at_count))?;
        let weights = of(self.weights, self.weight_count);
        let mask = (!self.mask.is_null()).then(|| of(self.mask, self.mask_count));
        if self.adds != 0 {
            let both = Layered::add(NlerpLerp, base, layer, weights);
            return visitor.visit(match mask {
                Some(mask) => both.mask(mask),
                None => both,
            });
        }
        let both = Layered::blend(NlerpLerp, base, layer, weights);
        visitor.blend(match mask {
            Some(mask) => both.mask(mask),
            None => both,
        })
    }
}

/// # Safety
/// So many keys are there.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_clip(joints: usize, keys: *const Key, count: usize) -> *mut Clip {
    // SAFETY: promised.
    made(Clip::new(joints, unsafe { slice(keys, count) }))
}

/// # Safety
/// It has been made, and is not used any more.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_clip_free(clip: *mut Clip) {
    // SAFETY: promised.
    drop(unsafe { Box::from_raw(clip) });
}
