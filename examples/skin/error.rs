use std::fmt;
use std::path::Path;

/// What went wrong, and where.
pub(crate) fn at(place: impl AsRef<Path>, error: impl fmt::Display) -> String {
    format!("{}: {error}", place.as_ref().display())
}

pub(crate) fn write(to: &Path, text: impl AsRef<[u8]>) -> Result<(), String> {
    std::fs::write(to, text).map_err(|error| at(to, error))
}

/// What `read` does with a file. The crate gltf does not check all that it relies on: where it
/// gives up, that is an error of the file too.
pub(crate) fn guarded<T>(
    file: &Path,
    read: impl FnOnce() -> Result<T, String> + std::panic::UnwindSafe,
) -> Result<T, String> {
    std::panic::catch_unwind(read).unwrap_or_else(|panic| {
        let what = panic.downcast_ref::<String>().map(String::as_str);
        let what = what.or(panic.downcast_ref::<&str>().copied()).unwrap_or("no reason given");
        Err(at(file, format!("its structure is broken: {what}")))
    })
}
