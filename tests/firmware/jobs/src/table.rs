use crate::Board;

/// Prints a line a job: what it took, and whether its answer is right.
///
/// Without `core::fmt`, which can panic as far as the linker knows.
pub struct Table<'b, B: Board> {
    board: &'b mut B,
    /// Instructions of a measurement of nothing.
    overhead: u32,
    passed: bool,
}

impl<'b, B: Board> Table<'b, B> {
    pub fn begin(board: &'b mut B) -> Self {
        board.print(B::NAME);
        board.print("\njob                                   instructions  error  bound\n");
        let mut table = Self { board, overhead: 0, passed: true };
        table.overhead = table.count(|| ());
        table
    }

    /// How many instructions `work` takes; it reads its inputs through `black_box`.
    pub fn count(&mut self, work: impl FnOnce()) -> u32 {
        let before = self.board.instructions();
        work();
        let after = self.board.instructions();
        after.wrapping_sub(before).saturating_sub(self.overhead)
    }

    /// A line, red if `error` is beyond `bound`; both in units of 2⁻²³.
    pub fn line(&mut self, name: &str, instructions: u32, error: f32, bound: f32) {
        // Not `error > bound`: NaN is a failure.
        let passed = error <= bound;
        self.passed &= passed;
        self.left(name, 36);
        self.whole(instructions, 14);
        self.board.print(" ");
        self.tenths(error, 6);
        self.board.print(" ");
        self.tenths(bound, 6);
        self.board.print(if passed { "  PASS\n" } else { "  FAIL\n" });
    }

    pub fn end(self) -> bool {
        self.board.print(if self.passed { "all: PASS\n" } else { "all: FAIL\n" });
        self.passed
    }

    fn left(&mut self, text: &str, width: usize) {
        self.board.print(text);
        self.spaces(width.saturating_sub(text.len()));
    }

    fn spaces(&mut self, count: usize) {
        for _ in 0..count {
            self.board.print(" ");
        }
    }

    fn whole(&mut self, value: u32, width: usize) {
        let digits = value.checked_ilog10().map_or(1, |log| log as usize + 1);
        self.spaces(width.saturating_sub(digits));
        self.digits(value);
    }

    fn digits(&mut self, value: u32) {
        const DIGITS: [&str; 10] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];
        if value >= 10 {
            self.digits(value / 10);
        }
        self.board.print(DIGITS.get(value as usize % 10).copied().unwrap_or_default());
    }

    fn tenths(&mut self, value: f32, width: usize) {
        if value.is_nan() {
            self.spaces(width.saturating_sub(3));
            return self.board.print("NaN");
        }
        let tenths = (value * 10.0 + 0.5) as u32;
        self.whole(tenths / 10, width.saturating_sub(2));
        self.board.print(".");
        self.digits(tenths % 10);
    }
}
