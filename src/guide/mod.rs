//! The guide: pages for questions that no single item answers. There is no code here.

#[doc = include_str!("conventions.md")]
pub mod conventions {}

#[doc = include_str!("layout.md")]
pub mod layout {}

#[doc = include_str!("kernel.md")]
pub mod kernel {}

#[doc = include_str!("clips.md")]
pub mod clips {}

#[doc = include_str!("skins.md")]
pub mod skins {}

#[doc = include_str!("robots.md")]
pub mod robots {}

#[doc = include_str!("accuracy.md")]
pub mod accuracy {}

#[doc = include_str!("reproducible.md")]
pub mod reproducible {}

#[doc = include_str!("firmware.md")]
pub mod firmware {}

#[doc = include_str!("migration.md")]
pub mod migration {}
