//! Random calls of the C functions: arrays of just the length that is said, on the heap, so that the address
//! sanitizer sees a number read or written beyond; null, misaligned and overlapping pointers; lengths that do
//! not fit. Nothing is written where the answer is an error.
//!
//! ```text
//! RUSTC_BOOTSTRAP=1 RUSTFLAGS=-Zsanitizer=address DQ8_FUZZ_SECONDS=60 cargo test --release -p dq8-capi \
//!   --test fuzz --target x86_64-unknown-linux-gnu
//! ```

mod arrays;
mod hierarchies;
mod mechanisms;
mod motions;
mod random;
mod skins;

use random::Fuzz;
use std::time::{Duration, Instant};

#[test]
fn the_c_functions_stay_within_their_arrays() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let seconds =
        number("DQ8_FUZZ_SECONDS").map_or(Duration::from_millis(200), Duration::from_secs);
    let (start, functions) = (Instant::now(), arrays::functions());
    let mut fuzz = Fuzz(number("DQ8_FUZZ_SEED").unwrap_or(1));
    let mut calls = 0_u64;
    while start.elapsed() < seconds {
        for _ in 0..100 {
            for _ in 0..10 {
                arrays::arrays(&mut fuzz, &functions);
                motions::motions(&mut fuzz);
            }
            hierarchies::hierarchies(&mut fuzz);
            mechanisms::mechanisms(&mut fuzz);
            skins::skins(&mut fuzz);
            calls += 10 * (1 + 26) + 24 + 9 + 12;
        }
    }
    println!("{calls} calls in {} s", start.elapsed().as_secs());
}
