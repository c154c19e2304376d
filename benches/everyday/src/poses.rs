//! The numbers that all contenders work on.

/// A rotation `[x, y, z, w]` and a translation.
#[derive(Clone, Copy)]
pub(crate) struct Pose {
    pub(crate) rotation: [f64; 4],
    pub(crate) translation: [f64; 3],
}

pub(crate) struct Poses {
    pub(crate) rows: Vec<Row>,
}

/// What one operation works on.
#[derive(Clone, Copy)]
pub(crate) struct Row {
    pub(crate) a: Pose,
    pub(crate) b: Pose,
    pub(crate) t: f64,
    pub(crate) point: [f64; 3],
}

/// In and out of 256 motions are 16 KiB in `f32`: the first cache holds both.
pub(crate) const COUNT: usize = 128;

impl Poses {
    pub(crate) fn new() -> Self {
        let mut numbers = Numbers(0x9e37_79b9_7f4a_7c15);
        let rows = (0..COUNT).map(|_| {
            let (a, turn) = (numbers.pose(1.0), numbers.pose(1.5));
            // Key poses are near each other, with signs as they come.
            let b = Pose { rotation: product(a.rotation, turn.rotation), ..turn };
            Row { a, b, t: 0.5 + 0.5 * numbers.next(), point: [(); 3].map(|()| numbers.next()) }
        });
        Self { rows: rows.collect() }
    }
}

/// Numbers in −1 … 1 (Marsaglia 2003, xorshift).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// `w` is what of the scalar part is not chance: the larger, the smaller the turn.
    fn pose(&mut self, w: f64) -> Pose {
        let [x, y, z] = [(); 3].map(|()| self.next());
        let w = w + self.next();
        let sign = self.next().signum();
        let norm = sign * (x * x + y * y + z * z + w * w).sqrt();
        let translation = [(); 3].map(|()| 2.0 * self.next());
        Pose { rotation: [x, y, z, w].map(|c| c / norm), translation }
    }
}

fn product([ax, ay, az, aw]: [f64; 4], [bx, by, bz, bw]: [f64; 4]) -> [f64; 4] {
    [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
        aw * bw - ax * bx - ay * by - az * bz,
    ]
}
