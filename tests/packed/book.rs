//! Packed clips by the book: their bytes read as the documentation lists them, and kinematics of
//! `f64` matrices.

/// `[x, y, z, w, tx, ty, tz]`
pub(crate) type Key = [f64; 7];

pub(crate) struct Book<'b> {
    bytes: &'b [u8],
    pub(crate) joints: usize,
    pub(crate) clips: usize,
    keys: usize,
}

impl<'b> Book<'b> {
    pub(crate) fn new(bytes: &'b [u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(bytes[at..][..4].try_into().unwrap()) as usize;
        Self { bytes, joints: word(12), clips: word(16), keys: word(20) }
    }
    fn word(&self, at: usize) -> usize {
        u32::from_le_bytes(self.bytes[at..][..4].try_into().unwrap()) as usize
    }
    /// Where rests, clips and rows begin.
    pub(crate) fn sections(&self) -> [usize; 3] {
        let rests = 32 + 8 * self.keys;
        let clips = rests + 16 * self.joints;
        [rests, clips, clips + (16 + 12) * self.clips]
    }
    /// The first key, how many frames, how many keys from one to the next, and the row.
    fn clip(&self, clip: usize) -> [usize; 4] {
        let [_, clips, _] = self.sections();
        std::array::from_fn(|i| self.word(clips + 16 * clip + 4 * i))
    }
    /// The first key of a column, and whether it has one for each frame.
    fn entry(&self, clip: usize, column: usize) -> (usize, usize) {
        let ([_, _, rows], [first, .., row]) = (self.sections(), self.clip(clip));
        let at = rows + 2 * (2 * self.joints * row + column);
        let entry = usize::from(u16::from_le_bytes(self.bytes[at..][..2].try_into().unwrap()));
        (first + entry / 2, entry % 2)
    }
    /// Whether all keys that rows lead to are there, in all frames.
    pub(crate) fn leads_to_keys(&self) -> bool {
        (0..self.clips * 2 * self.joints).all(|index| {
            let (clip, column) = (index / (2 * self.joints), index % (2 * self.joints));
            let ([_, frames, step, _], (key, moves)) = (self.clip(clip), self.entry(clip, column));
            key + moves * (frames - 1) * step < self.keys
        })
    }
    fn numbers(&self, clip: usize, column: usize, frame: usize) -> [f64; 4] {
        let ([_, _, step, _], (first, moves)) = (self.clip(clip), self.entry(clip, column));
        let key = first + moves * frame * step;
        std::array::from_fn(|i| {
            let at = 32 + 8 * key + 2 * i;
            i16::from_le_bytes(self.bytes[at..][..2].try_into().unwrap()).into()
        })
    }
    /// The pose `t` of the way from a frame to the next, t rounded as the documentation says.
    pub(crate) fn pose(&self, clip: usize, joint: usize, frame: usize, t: f64) -> Key {
        let t = if t > 0.0 { (t.min(1.0) * 16384.0).round_ties_even() / 16384.0 } else { 0.0 };
        let [rests, ..] = self.sections();
        let next = (frame + 1).min(self.clip(clip)[1] - 1);
        let between = |column| {
            let (a, b) = (self.numbers(clip, column, frame), self.numbers(clip, column, next));
            std::array::from_fn::<f64, 4, _>(|i| (1.0 - t) * a[i] + t * b[i])
        };
        let turn = between(joint);
        let length = turn.iter().map(|c| c * c).sum::<f64>().sqrt();
        let rest: [f64; 4] = std::array::from_fn(|i| {
            f32::from_bits(self.word(rests + 16 * joint + 4 * i) as u32).into()
        });
        let shift = if rest[3] == 0.0 { [0.0; 4] } else { between(self.joints + joint) };
        let [x, y, z, w] = turn.map(|c| c / length);
        let [tx, ty, tz] = std::array::from_fn(|i| rest[i] + rest[3] * 16384.0 * shift[i]);
        [x, y, z, w, tx, ty, tz]
    }
}

/// Rows of rotation matrices with translations.
fn matrix([x, y, z, w, a, b, c]: Key) -> [[f64; 4]; 3] {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y), a],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x), b],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y), c],
    ]
}

pub(crate) fn point(m: [[f64; 4]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|r| r[0] * v[0] + r[1] * v[1] + r[2] * v[2] + r[3])
}

/// The models of one instance.
pub(crate) fn models(parents: &[u32], locals: &[Key]) -> Vec<[[f64; 4]; 3]> {
    let mut models: Vec<[[f64; 4]; 3]> = Vec::new();
    for (local, &parent) in locals.iter().map(|&local| matrix(local)).zip(parents) {
        let model = models.get(parent as usize).map_or(local, |&parent| {
            let mut product = [[0.0; 4]; 3];
            for (row, out) in parent.iter().zip(&mut product) {
                for (column, number) in out.iter_mut().enumerate() {
                    *number = (0..3).map(|k| row[k] * local[k][column]).sum();
                }
                out[3] += row[3];
            }
            product
        });
        models.push(model);
    }
    models
}
