"""A copy of the tree with many changes in one build: `dq8::mutant()` is the number of the one that is switched on, by the
variable DQ8_MUTANT. For falsify.py and mutants.py."""

import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SWITCH = """
/// The number of the change that is switched on; only in copies made by scripts/switched.py.
#[doc(hidden)]
#[allow(missing_docs, clippy::all)]
pub fn mutant() -> usize {
    static ON: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    *ON.get_or_init(|| std::env::var("DQ8_MUTANT").map_or(usize::MAX, |n| n.parse().unwrap()))
}
"""


def copy(to):
    """All files that belong to the tree, and no source that does not."""
    command = ["git", "ls-files", "-co", "--exclude-standard"]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    wanted = {name for name in listed if (ROOT / name).is_file()}
    for name in wanted:
        write(to / name, (ROOT / name).read_bytes())
        shutil.copymode(ROOT / name, to / name)
    for place in to.rglob("*.rs"):
        name = str(place.relative_to(to))
        if not name.startswith("target/") and name not in wanted:
            place.unlink()
    write(to / "src/lib.rs", (ROOT / "src/lib.rs").read_bytes() + SWITCH.encode())


def write(place, data):
    """Only what differs, so that Cargo builds only what differs."""
    if not place.exists() or place.read_bytes() != data:
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(data)
