//! NEON code for the lanes of [`Portable`](crate::Portable): transposes of records, and products of
//! single dual quaternions. The crate `wide` has the arithmetic of these lanes.
//!
//! NEON has instructions for *structures*: `ld3` reads three components of each of four records
//! into three registers. This module uses them where LLVM's models of Neoverse N1, Neoverse V2 and
//! Apple's cores say that they are quicker than single loads with shuffles; `scripts/count_arm.py`
//! asks these models (docs/measured.md, *NEON*):
//!
//! | records that adjoin | loads | stores |
//! |---|---|---|
//! | 2 or 3 components | `ld2`, `ld3` | `st2`, `st3` |
//! | 4 components | `ld4` | shuffles: `st4` takes twice as long on V2 |
//! | 8 components | shuffles: two `ld4` would need as many shuffles | shuffles |

pub(crate) mod f32x4;
pub(crate) mod f64x2;
mod packed;
