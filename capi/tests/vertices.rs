//! One vertex buffer for all: a skin is made of the joints and weights in it, and poses the
//! positions in it.

use dq8::DualQuat;
use dq8_capi::Status;
use dq8_capi::mesh::VertexFields;
use dq8_capi::skin::{InfluenceField, Skin};
use dq8_capi::skinning::single as c;
use std::mem::MaybeUninit;
use std::ptr;

/// A vertex as an engine may have it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
struct Vertex {
    color: u32,
    position: [f32; 3],
    joints: [u16; 2],
    weights: [f32; 2],
}

const STRIDE: usize = size_of::<Vertex>() / size_of::<f32>();
const POSITIONS: VertexFields =
    VertexFields { stride: STRIDE, position: 1, normal: -1, tangent: -1 };

#[test]
fn a_skin_and_what_it_poses_may_lie_in_one_buffer() {
    let vertex = |i: u16| Vertex {
        color: 0xff00_0000,
        position: [f32::from(i), 1.0, 2.0],
        joints: [i % 3, (i + 1) % 3],
        weights: [0.75, 0.25],
    };
    let vertices: Vec<_> = (0..19).map(vertex).collect();
    let motions = [0.0, 8.0, 16.0].map(|x| DualQuat::from_translation([x, 0.0_f32, 0.0]));
    let mut posed = vertices.clone();
    let (start, count) = (vertices.as_ptr(), vertices.len());
    let joints_at = InfluenceField { stride: 2 * STRIDE, first: 2 * 4 };
    let weights_at = InfluenceField { stride: STRIDE, first: 5 };
    let mut made = MaybeUninit::<Skin<f32>>::zeroed();
    let (skin, by) = (made.as_mut_ptr(), motions.as_ptr().cast());
    // SAFETY: arrays have the length that is said, and what overlaps is refused.
    unsafe {
        let nowhere = ptr::null_mut();
        let (joints, weights) = (start.cast(), start.cast());
        let made =
            c::make_interleaved(3, 2, joints, joints_at, weights, weights_at, count, skin, nowhere);
        assert_eq!(made, Status::Ok);
        let pose = |to: *mut Vertex| {
            let (rest, to) = (start.cast(), to.cast());
            c::dual_interleaved(skin, by, 3, rest, POSITIONS, to, POSITIONS, count)
        };
        assert_eq!(pose(start.cast_mut()), Status::Overlap);
        assert_eq!(pose(posed.as_mut_ptr()), Status::Ok);
    }
    for (moved, at_rest) in posed.iter().zip(&vertices) {
        let [x, y, z] = at_rest.position;
        let [first, second] = at_rest.joints.map(|joint| 8.0 * f32::from(joint));
        let position = [x + 0.75 * first + 0.25 * second, y, z];
        assert_eq!(*moved, Vertex { position, ..*at_rest });
    }
}
