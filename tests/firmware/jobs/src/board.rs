/// What a job needs of the board that it runs on.
pub trait Board {
    /// What the table is headed with.
    const NAME: &'static str;
    /// Writes to the console of the emulator.
    fn print(&mut self, text: &str);
    /// Instructions since some time in the past, modulo 2³²; the emulator counts, not a cycle
    /// model.
    fn instructions(&mut self) -> u32;
}
