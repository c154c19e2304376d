//! Calls the hot kernels, so that their machine code is in this program.

use dq8::hierarchy::{Clip, Layered, PackedClip, Sampled, Tolerance};
use dq8::law::NlerpLerp;
use dq8::simd::Row;
use dq8::{Backend, Block, DualQuat, Hierarchy, Skeleton};
use std::hint::black_box;

fn main() {
    one_instance();
    clips();
    kernels::<8>([Block::splat([0.0; 8]); 2], [Block::splat([0.0; 3]); 2]);
    kernels::<16>([Block::splat([0.0; 8]); 2], [Block::splat([0.0; 3]); 2]);
}

fn one_instance() {
    let skeleton = Skeleton::new(&[-1, 0]).expect("a hierarchy");
    let (locals, mut models) = (black_box([DualQuat::<f32>::IDENTITY; 2]), [DualQuat::ZERO; 2]);
    skeleton.local_to_model(&locals, &mut models).expect("they are of one length");
    black_box(models);
}

/// Two clips, blended, to a palette: packed ones, and plain ones.
fn clips() {
    let parents = [Hierarchy::ROOT, 0];
    let hierarchy = Hierarchy::new(&parents).expect("a hierarchy");
    let frames = black_box([[0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]; 4]);
    let plain = Clip::new(2, &frames).expect("whole frames");
    let packed = PackedClip::new(plain, Tolerance::default()).expect("it stays");
    let places = [packed.clips().place(0, black_box(0.5_f32)).expect("a clip").0; 16];
    let t = black_box([0.5_f32; 16]);
    let source = || Sampled::new(NlerpLerp, packed.clips(), &places, &t).expect("its places");
    let locals = Layered::blend(NlerpLerp, source(), source(), &t);
    let frame = black_box([0; 16]);
    let source = || Sampled::new(NlerpLerp, plain, &frame, &t).expect("its frames");
    let plain = Layered::blend(NlerpLerp, source(), source(), &t);
    let (mut scratch, binds) = ([DualQuat::IDENTITY; 32], black_box([DualQuat::IDENTITY; 2]));
    let mut palette = [[[0.0_f32; 4]; 3]; 32];
    hierarchy.job().palette(locals, &mut scratch, &binds, &mut palette).expect("they fit");
    black_box(palette);
    hierarchy.job().palette(plain, &mut scratch, &binds, &mut palette).expect("they fit");
    black_box(palette);
}

/// Each on blocks of `N` lanes.
fn kernels<const N: usize>(a: [Block<f32, N>; 2], points: [Block<f32, N, 3>; 2])
where
    [f32; N]: Row<Real = f32>,
{
    let backend = Backend::best();
    let parents = [Hierarchy::ROOT, 0];
    let hierarchy = Hierarchy::new(&parents).expect("a hierarchy");
    let (mut out, mut moved) = (black_box(a), black_box(points));
    let fits = "they are of one length";
    backend.mul(&black_box(a), &black_box(a), &mut out).expect(fits);
    backend.normalize(&black_box(a), &mut out).expect(fits);
    backend.sclerp(&black_box(a), &black_box(a), black_box(0.5), &mut out).expect(fits);
    backend.transform_points(black_box(DualQuat::IDENTITY), &points, &mut moved).expect(fits);
    hierarchy.job().local_to_model_in_place(&mut out).expect(fits);
    black_box((out, moved));
}
