//! Many clips on one robot, on threads: a file of joint values for each, and a table of measures.

use crate::{csv, hint};
use dq8_retarget::{Humanoid, Person, Report, Settings, retarget};
use mocap::command::print;
use mocap::output::Outputs;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// The name of the table of measures.
const TABLE: &str = "measures";

/// The robot, the settings and the folder that all clips share.
pub(crate) struct Clips<'a> {
    pub(crate) humanoid: &'a Humanoid,
    /// A table of names.
    pub(crate) table: Option<&'a str>,
    pub(crate) settings: &'a Settings,
    /// The folder of the results.
    pub(crate) out: &'a Path,
    /// Files that no result may replace, as the robot and the table of names; clips are not listed.
    pub(crate) inputs: &'a [&'a Path],
}

/// The measures of a clip, and its number of frames.
type Row = (usize, Report);

impl Clips<'_> {
    /// Works on all clips with so many threads. A clip that fails does not end the others; the
    /// error at the end says how many have failed.
    pub(crate) fn run(&self, paths: &[PathBuf], jobs: usize) -> Result<(), Box<dyn Error>> {
        let clips = files(paths)?;
        fs::create_dir_all(self.out)
            .map_err(|error| format!("cannot make {}: {error}", self.out.display()))?;
        self.check(&clips)?;
        let clock = Instant::now();
        let rows = self.rows(&clips, jobs);
        let seconds = clock.elapsed().as_secs_f64();
        let path = self.result(TABLE);
        write(&path, &table(&rows))?;
        let frames: usize = rows.values().flatten().map(|row| row.0).sum();
        print(&format!(
            "{frames} frames in {seconds:.2} s, {:.0} frames/s\nwrote {}\n",
            frames as f64 / seconds,
            path.display()
        ))?;
        match rows.values().filter(|row| row.is_err()).count() {
            0 => Ok(()),
            failed => Err(format!("{failed} of {} clips failed", rows.len()).into()),
        }
    }

    /// The file of a clip's joint values, or of the table.
    fn result(&self, name: &str) -> PathBuf {
        self.out.join(format!("{name}.csv"))
    }

    /// Returns an error if a result would replace a file that is read. This is asked before any
    /// file is written, and of all files once, because each may be the result of any clip.
    fn check(&self, clips: &BTreeMap<String, PathBuf>) -> Result<(), String> {
        let read = self.inputs.iter().copied().chain(clips.values().map(PathBuf::as_path));
        let read: BTreeSet<_> = read.filter_map(|path| fs::canonicalize(path).ok()).collect();
        let names = clips.keys().map(String::as_str).chain([TABLE]);
        let replaces =
            |path: &PathBuf| fs::canonicalize(path).is_ok_and(|path| read.contains(&path));
        names
            .map(|name| self.result(name))
            .find(replaces)
            .map_or(Ok(()), |path| Err(format!("cannot write {}: it is an input", path.display())))
    }

    fn rows(&self, clips: &BTreeMap<String, PathBuf>, jobs: usize) -> Rows {
        let mut queue: Vec<_> = clips.iter().collect();
        // The longest first, so that no thread is left alone with a long one at the end.
        queue.sort_by_key(|(_, path)| {
            std::cmp::Reverse(fs::metadata(path).map_or(0, |file| file.len()))
        });
        let (next, rows) = (AtomicUsize::new(0), Mutex::new(Rows::new()));
        let work = || {
            while let Some((name, path)) = queue.get(next.fetch_add(1, Ordering::Relaxed)) {
                let row = self.row(name, path).map_err(|error| self.without_result(name, &*error));
                match &row {
                    Ok((frames, report)) => {
                        let residual = report.residual;
                        // Nobody may be there to be told.
                        let _ = print(&format!("{name}: {frames} frames, {residual:.1} mm\n"));
                        for warning in report.warnings() {
                            eprintln!("retarget: {name}: warning: {warning}");
                        }
                    }
                    Err(error) => eprintln!("retarget: {name}: {error}"),
                }
                let mut rows = rows.lock().unwrap_or_else(PoisonError::into_inner);
                rows.insert((*name).clone(), row);
            }
        };
        std::thread::scope(|scope| {
            for _ in 1..jobs.min(queue.len()) {
                scope.spawn(work);
            }
            work();
        });
        rows.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    fn row(&self, name: &str, path: &Path) -> Result<Row, Box<dyn Error>> {
        let mut person = Person::from_clip(&mocap::load(path)?)?;
        if let Some(table) = self.table {
            person = person.with_table(table)?;
        }
        let motion = retarget(&person, self.humanoid, self.settings).map_err(hint)?;
        let text = csv(self.humanoid, &motion.values, motion.step)?;
        write(&self.result(name), &text)?;
        Ok((motion.contacts.len(), motion.report))
    }

    /// The sentence of an error, after the joint values that an earlier run has written for the
    /// clip have been removed: they would be taken for those of this run.
    fn without_result(&self, name: &str, error: &dyn Error) -> String {
        let path = self.result(name);
        match path.is_file().then(|| fs::remove_file(&path)) {
            Some(Err(reason)) => {
                format!("{error}; cannot remove {} of an earlier run: {reason}", path.display())
            }
            _ => error.to_string(),
        }
    }
}

/// The rows by the names of clips; an error is a sentence.
type Rows = BTreeMap<String, Result<Row, String>>;

/// The files, and the BVH files of each folder, by their names without the end.
fn files(paths: &[PathBuf]) -> Result<BTreeMap<String, PathBuf>, Box<dyn Error>> {
    let mut clips = BTreeMap::new();
    for path in paths {
        let mut found = vec![path.clone()];
        if path.is_dir() {
            let cannot = |error| format!("cannot read {}: {error}", path.display());
            let entries = fs::read_dir(path).map_err(cannot)?;
            let all: Result<Vec<_>, _> = entries.map(|entry| entry.map(|it| it.path())).collect();
            // Files that cannot be looked at are kept, so that they are named as errors.
            let is_clip = |path: &PathBuf| {
                path.extension().is_some_and(|end| end.eq_ignore_ascii_case("bvh"))
                    && fs::metadata(path).map_or(true, |found| found.is_file())
            };
            found = all.map_err(cannot)?.into_iter().filter(is_clip).collect();
            if found.is_empty() {
                return Err(format!("{} has no BVH file", path.display()).into());
            }
        }
        for path in found {
            let stem = path.file_stem().unwrap_or(path.as_os_str());
            let name = stem.to_string_lossy().into_owned();
            let shown = path.display().to_string();
            if name == TABLE {
                return Err(format!("{shown} has the name of the table of measures").into());
            }
            if let Some(other) = clips.insert(name, path) {
                let other = other.display();
                return Err(format!("{other} and {shown} would be written to one file").into());
            }
        }
    }
    Ok(clips)
}

/// A row for each clip; the last column says why a clip has no measures.
fn table(rows: &Rows) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let names = Report::MEASURES;
    let mut text = format!("clip,frames,{},edges,error\n", names.join(","));
    for (name, row) in rows {
        let (frames, measures, edges, error) = match row {
            Ok((frames, report)) => {
                let number =
                    |measure: Option<f64>| measure.map_or(String::new(), |x| format!("{x:.4}"));
                let measures = report.measures().map(number);
                (frames.to_string(), measures, report.edges.to_string(), String::new())
            }
            Err(error) => {
                (String::new(), names.map(|_| String::new()), String::new(), quoted(error))
            }
        };
        text += &format!("{},{frames},{},{edges},{error}\n", quoted(name), measures.join(","));
    }
    text
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    // `Clips::check` has compared the path with the inputs.
    Outputs::open([path], [])?.write(&[text])
}
