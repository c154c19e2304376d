//! The main job: forward kinematics of a motion-capture clip, all frames at once.
//!
//! ```text
//! cargo run --release --example mocap                                    # an embedded biped
//! cargo run --release --example mocap -- walk.bvh --csv walk.csv --svg walk.svg
//! ```

use std::process::ExitCode;

fn main() -> ExitCode {
    mocap::main()
}
