//! Ten thousand steps of a crowd, with inverse kinematics and skins, and the hash of every bit of
//! them: the same on every machine. Without the feature it says what the machine's own instructions
//! give.
//!
//! ```sh
//! cargo run --release --example lockstep --features reproducible
//! ```

mod world;

use dq8::Backend;
use world::World;

fn main() {
    #[cfg(feature = "reproducible")]
    let backend = Backend::reproducible();
    #[cfg(not(feature = "reproducible"))]
    let backend = Backend::best();
    let begin = std::time::Instant::now();
    let hash = World::new(backend).run(10_000).expect("lengths fit");
    println!("bits {}, {backend}: {hash:016x}, in {:.2?}", dq8::BITS, begin.elapsed());
}
