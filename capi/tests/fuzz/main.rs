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

use dq8_fixtures::fuzz;
use random::Fuzz;

#[test]
fn the_c_functions_stay_within_their_arrays() {
    let functions = arrays::functions();
    fuzz::rounds(|seed| {
        let mut fuzz = Fuzz(fuzz::random(seed));
        for _ in 0..100 {
            for _ in 0..10 {
                arrays::arrays(&mut fuzz, &functions);
                motions::motions(&mut fuzz);
            }
            hierarchies::hierarchies(&mut fuzz);
            mechanisms::mechanisms(&mut fuzz);
            skins::skins(&mut fuzz);
        }
        100 * (10 * (1 + 26) + 24 + 9 + 12)
    });
}
