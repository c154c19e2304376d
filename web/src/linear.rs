//! Linear blends of positions. On wide registers dq8 multiplies rows of matrices by points and adds
//! along the rows, which takes 24 shuffles of two registers for four points. JavaScriptCore has
//! five instructions for such a shuffle. By columns there are eight, and none to store points.

use dq8::skinning::Skin;
use dq8::{Kernel, Lanes, Level};

/// A 3×4 matrix by rows, as dq8 gives it.
pub(crate) type Row = [[f32; 4]; 3];
/// A 3×4 matrix, column after column, in three registers.
pub(crate) type Packed = [[f32; 4]; 3];

/// Vertices of four influences, and where they go. Joints are less than the count of matrices.
pub(crate) struct ByColumns<'s> {
    joints: &'s [[u16; 4]],
    weights: &'s [[f32; 4]],
    matrices: &'s [Packed],
    rest: &'s [[f32; 3]],
    posed: &'s mut [[f32; 3]],
}

impl<'s> ByColumns<'s> {
    /// Fills `columns` by `matrices`. Returns `None` for other influences than four, and for what
    /// does not fit. The skin is from `Skin::new`, so its joints and weights lie without gaps.
    pub(crate) fn new(
        skin: &Skin<'s, u16, f32>,
        matrices: &[Row],
        columns: &'s mut Vec<Packed>,
        rest: &'s [[f32; 3]],
        posed: &'s mut [[f32; 3]],
    ) -> Option<Self> {
        // The skin has checked its joints against its own count.
        let fits = [rest.len(), posed.len()] == [skin.vertices(); 2]
            && matrices.len() == skin.joint_count();
        if !fits || skin.influences() != 4 {
            return None;
        }
        columns.clear();
        columns.extend(matrices.iter().map(|rows| {
            let mut packed = Packed::default();
            for (i, number) in packed.as_flattened_mut().iter_mut().enumerate() {
                *number = rows[i % 3][i / 3];
            }
            packed
        }));
        let (joints, weights) = (skin.joints().as_chunks().0, skin.weights().as_chunks().0);
        Some(Self { joints, weights, matrices: columns, rest, posed })
    }
}

impl Kernel for ByColumns<'_> {
    type Output = ();

    /// Sums in the order of `dq8::skinning::Linear`, so that both give the same bits.
    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let posed = self.posed.as_flattened_mut();
        let vertices = self.joints.iter().zip(self.weights).zip(self.rest);
        let mut first = 0;
        for ((joints, weights), &[x, y, z]) in vertices {
            let mut sums = [V::F32x4::splat(level, 0.0); 3];
            for influence in 0..4 {
                // SAFETY: the joint is less than the count of matrices, which `new` has checked.
                let matrix = unsafe { self.matrices.get_unchecked(usize::from(joints[influence])) };
                let weight = V::F32x4::splat(level, weights[influence]);
                for (sum, part) in sums.iter_mut().zip(matrix) {
                    let part = V::F32x4::load(level, part);
                    *sum = if influence == 0 { part * weight } else { part.mul_add(weight, *sum) };
                }
            }
            // The fourth number of a column is any.
            let [[_, _, _, bx], [by, bz, cx, cy], [cz, tx, ty, tz]] = sums.map(Lanes::to_array);
            let (a, b) = (sums[0], V::F32x4::load(level, &[bx, by, bz, cx]));
            let (c, t) = ([cx, cy, cz, tx], [tx, ty, tz, tz]);
            let (c, t) = (V::F32x4::load(level, &c), V::F32x4::load(level, &t));
            let [x, y, z] = [x, y, z].map(|number| V::F32x4::splat(level, number));
            let moved = (x * a + z * c) + (y * b + t);
            // The next vertex overwrites the fourth number; behind the last one is no room for it.
            if let Some(four) = posed.get_mut(first..).and_then(|rest| rest.first_chunk_mut()) {
                moved.store(four);
            } else if let Some(three) = posed.get_mut(first..) {
                three.copy_from_slice(&moved.to_array()[..three.len()]);
            }
            first += 3;
        }
    }
}
