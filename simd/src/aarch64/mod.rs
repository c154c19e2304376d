//! Records and single dual quaternions by instructions of NEON, for the lanes of
//! [`Portable`](crate::Portable). Their arithmetic is that of `wide`.
//!
//! NEON reads and writes *structures*: `ld3` brings three numbers of each of four records into
//! three registers. It is used where it is quicker than single loads with shuffles in the models
//! of LLVM for Neoverse N1 and V2 and for Apple's cores, which `scripts/count_arm.py` asks
//! (docs/measured.md, *NEON*):
//!
//! | records that adjoin | loads | stores |
//! |---|---|---|
//! | 2 or 3 numbers | `ld2`, `ld3` | `st2`, `st3` |
//! | 4 numbers | `ld4` | shuffles: `st4` takes twice as long on V2 |
//! | 8 numbers | shuffles: after two `ld4` as many shuffles follow as `ld4` saved | shuffles |

pub(crate) mod f32x4;
pub(crate) mod f64x2;
mod packed;
