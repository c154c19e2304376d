//! [`Octet`]: eight lanes that hold two quaternions of one motion.

use crate::lane::Lanes;
use bytemuck::Zeroable;

/// Eight lanes `[px, py, pz, pw, qx, qy, qz, qw]`: one dual quaternion p + εq, as it lies in memory.
///
/// Products of such vectors serve where there is only one thing to compute at a time: a child waits
/// for its parent. Two rearrangements are all that they need beside [`Lanes`].
pub trait Octet: Lanes {
    /// What the components x, y, z and w of another quaternion multiply, in both halves: with these
    /// four columns, p·b = c₀b_x + c₁b_y + c₂b_z + c₃b_w.
    ///
    /// ```text
    /// c₀ = (pw, pz, −py, −px)   c₁ = (−pz, pw, px, −py)   c₂ = (py, −px, pw, −pz)   c₃ = p
    /// ```
    #[inline(always)]
    #[must_use]
    fn columns(self) -> [Self; 4] {
        let level = self.level();
        let from = self.to_array();
        let mut columns = [Self::Array::zeroed(); 3];
        for (half, p) in from.as_ref().chunks_exact(4).enumerate() {
            let &[x, y, z, w] = p else { break };
            let rows = [[w, z, -y, -x], [-z, w, x, -y], [y, -x, w, -z]];
            for (column, row) in columns.iter_mut().zip(rows) {
                for (slot, value) in column.as_mut().iter_mut().skip(4 * half).zip(row) {
                    *slot = value;
                }
            }
        }
        let [x, y, z] = &columns;
        [Self::load(level, x), Self::load(level, y), Self::load(level, z), self]
    }

    /// εσ: the lower half in the upper one, and zero below, for ε² = 0.
    #[inline(always)]
    #[must_use]
    fn raised(self) -> Self {
        let mut raised = Self::Array::zeroed();
        let half = self.to_array();
        for (slot, &value) in raised.as_mut().iter_mut().skip(4).zip(half.as_ref()) {
            *slot = value;
        }
        Self::load(self.level(), &raised)
    }
}

impl Octet for wide::f32x8 {}
impl Octet for wide::f64x8 {}
