//! The files the program writes: all of them or none.

use crate::command::print;
use std::error::Error;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Files that can be written, and are not changed yet. Those that did not exist are gone again if
/// nothing comes to be written.
#[derive(Debug)]
pub struct Outputs<'a> {
    files: Vec<(&'a Path, File)>,
    created: Vec<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// Opens all files or none. `inputs` are files that must not be overwritten.
    pub fn open<'i>(
        paths: impl IntoIterator<Item = &'a Path>,
        inputs: impl IntoIterator<Item = &'i Path>,
    ) -> Result<Self, String> {
        let mut outputs = Self { files: Vec::new(), created: Vec::new() };
        let mut taken: Vec<PathBuf> =
            inputs.into_iter().filter_map(|path| fs::canonicalize(path).ok()).collect();
        for path in paths {
            let exists = path.exists();
            let mut options = OpenOptions::new();
            let file =
                options.write(true).create(true).truncate(false).open(path).map_err(fails(path))?;
            if !exists {
                outputs.created.push(path);
            }
            // Two names may mean one file. What has no name in the file system, like a pipe, is
            // taken as it is.
            let name = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
            if taken.contains(&name) {
                return Err(fails(path)(io::Error::other("it is an input or another output")));
            }
            taken.push(name);
            outputs.files.push((path, file));
        }
        Ok(outputs)
    }

    /// Writes one text, or bytes, to each.
    pub fn write(mut self, texts: &[impl AsRef<[u8]>]) -> Result<(), String> {
        for ((path, file), text) in self.files.iter_mut().zip(texts) {
            if file.metadata().is_ok_and(|metadata| metadata.is_file()) {
                file.set_len(0).map_err(fails(path))?;
            }
            file.write_all(text.as_ref()).map_err(fails(path))?;
        }
        self.created.clear();
        Ok(())
    }
}

impl Drop for Outputs<'_> {
    fn drop(&mut self) {
        for path in &self.created {
            // There is another error to be reported.
            let _ = fs::remove_file(path);
        }
    }
}

/// Writes all files or none, and prints their names. `inputs` are files that must not be
/// overwritten.
pub fn write<'i>(
    files: &[(&Path, Vec<u8>)],
    inputs: impl IntoIterator<Item = &'i Path>,
) -> Result<(), Box<dyn Error>> {
    let texts: Vec<_> = files.iter().map(|(_, text)| text).collect();
    Outputs::open(files.iter().map(|&(path, _)| path), inputs)?.write(&texts)?;
    files.iter().try_for_each(|(path, _)| print(&format!("  wrote {}\n", path.display())))
}

fn fails(path: &Path) -> impl FnOnce(io::Error) -> String {
    move |reason| format!("cannot write {}: {reason}", path.display())
}

#[cfg(test)]
mod tests {
    use super::write;
    use std::fs;
    use std::path::PathBuf;

    /// An empty directory for one test.
    fn directory(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("dq8-mocap-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        path
    }

    #[test]
    fn files_are_replaced_whole() {
        let directory = directory("replaced");
        let path = directory.join("a");
        fs::write(&path, "much longer than what comes").unwrap();
        write(&[(&path, "short".into())], None).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "short");
        fs::remove_dir_all(directory).unwrap();
    }

    #[test]
    fn a_path_that_cannot_be_written_leaves_no_file_and_changes_none() {
        let directory = directory("unwritable");
        let [new, old, wrong] =
            ["new", "old", "no such directory/file"].map(|name| directory.join(name));
        fs::write(&old, "before").unwrap();
        let texts = [&new, &old, &wrong].map(|path| (path.as_path(), "after".into()));
        let error = write(&texts, None).unwrap_err().to_string();
        assert!(error.contains("no such directory"), "{error}");
        assert!(!new.exists());
        assert_eq!(fs::read_to_string(&old).unwrap(), "before");
        fs::remove_dir_all(directory).unwrap();
    }

    #[test]
    fn inputs_and_an_output_are_not_overwritten_by_another() {
        let directory = directory("twice");
        let [clip, robot, output] =
            ["clip.bvh", "robot.urdf", "out"].map(|name| directory.join(name));
        let inputs = || [clip.as_path(), robot.as_path()];
        for input in inputs() {
            fs::write(input, "the input").unwrap();
        }
        for input in inputs() {
            assert!(write(&[(&output, "a".into()), (input, "b".into())], inputs()).is_err());
            assert_eq!(fs::read_to_string(input).unwrap(), "the input");
        }
        let same = directory.join(".").join("out");
        assert!(write(&[(&output, "a".into()), (&same, "b".into())], inputs()).is_err());
        assert!(!output.exists());
        fs::remove_dir_all(directory).unwrap();
    }
}
