"""What notebooks, shells and type checkers meet first."""

import subprocess
import sys
from html.parser import HTMLParser
from importlib import metadata

import matplotlib.figure
import numpy as np
import pytest
from calls import ARM, VALUES
from processes import run

import dq8


class Balanced(HTMLParser):
    """Counts rows, and fails where tags do not close each other."""

    def __init__(self, text):
        super().__init__()
        self.open, self.rows, self.cells = [], 0, []
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)
        self.rows += tag == "tr"

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.cells.append(data)


def test_notebooks_show_tables_of_robots_clips_and_reports(rng):
    named = dq8.Mechanism([-1, 0], "revolute", [0, 0, 1], dq8.identity(2), [[-1, 2], [-3, 4.5]], links=["<a>", "b"])
    table = Balanced(named._repr_html_())
    assert table.rows == 3 and {"-1", "2", "4.5"} <= set(table.cells) and "Mechanism of 2 links with 2 values" in table.cells
    long = dq8.Mechanism(list(range(-1, 99)), "revolute", [0, 0, 1], dq8.identity(100))
    assert Balanced(long._repr_html_()).rows == 32 and "and 70 more" in long._repr_html_()
    clip = dq8.PackedClip(dq8.random((20, 3), rng=rng))
    assert str(len(clip.to_bytes())) in Balanced(clip._repr_html_()).cells
    values = VALUES(rng)
    _, report = ARM.reach(ARM.poses(values, 3), values + 0.01, 3)
    table = Balanced(report._repr_html_())
    assert f"{len(values)} targets" in table.cells[0] and "100.0%" in table.cells
    _, one = ARM.reach(ARM.poses(values[0], 3), values[0], 3)
    assert "1 targets" in one._repr_html_()


def test_robots_are_drawn(rng):
    axes = matplotlib.figure.Figure().add_subplot(projection="3d")
    assert ARM.plot(VALUES(rng)[0], axes) is axes and len(axes.lines) == len(ARM)
    done = run("import matplotlib; matplotlib.use('agg'); from calls import ARM; print(type(ARM.plot([0, 0, 0])).__name__)")
    assert done.stdout == "Axes3D\n", done.stderr


@pytest.mark.parametrize(
    "package, extra, call",
    [
        ("scipy", "scipy", "dq8.to_scipy(dq8.identity())"),
        ("scipy", "scipy", "dq8.RigidTransform.from_dual_quat(dq8.identity()).rotation"),
        ("dask", "dask", "import dq8.dask"),
        ("matplotlib", "plot", "dq8.Mechanism([-1], 'revolute', [0, 0, 1], dq8.identity()).plot([0.0])"),
    ],
)
def test_what_is_missing_is_said_with_how_to_install_it(package, extra, call):
    done = run(f"import sys; sys.modules[{package!r}] = None; import dq8; {call}")
    assert done.stderr.endswith(f"ModuleNotFoundError: This needs {package}: pip install dq8[{extra}]\n"), done.stderr
    assert extra in metadata.metadata("dq8").get_all("Provides-Extra")


def test_an_empty_setting_of_threads_is_none():
    done = run("import dq8; print(dq8.get_num_threads())", DQ8_NUM_THREADS="")
    assert done.stdout == "1\n", done.stderr


def test_numbers_are_numbers_to_type_checkers(tmp_path):
    script = tmp_path / "script.py"
    script.write_text("""import dq8
a, b = dq8.random(rng=1), dq8.random(rng=2)
d: float = dq8.angle_to(a, b)
far: float = dq8.distance_to(a, b)
moved = dq8.mul(a, b).shape
text: str = moved
""")
    command = [sys.executable, "-m", "mypy", "--strict", "--disable-error-code", "import-untyped", "--cache-dir", tmp_path, script]
    done = subprocess.run(command, capture_output=True, text=True)
    # That it looks at all, the last line shows.
    assert "script.py:6: error" in done.stdout and "Found 1 error in 1 file" in done.stdout, done.stdout


def test_what_pip_shows_is_complete():
    shown = metadata.metadata("dq8")
    for name in ("Summary", "Author", "License-Expression", "Requires-Python", "Keywords"):
        assert shown[name], name
    assert shown.get_all("Project-URL")


@pytest.mark.parametrize("threads", ["1", "2"])
def test_long_calls_tell_how_much_is_done(threads):
    code = """
import numpy as np, dq8
told = []
many = np.tile(dq8.from_twist([0.3, 0, 0, 1, 2, 3]), (20_000, 8, 1))
with dq8.progress(told.append):
    dq8.mean(many, tolerance=-1.0, max_iterations=500)
assert told[-1] == 1 and len(told) > 3 and told == sorted(told) and 0 <= told[0] < 0.5, told
count = len(told)
dq8.mean(many[:2000], tolerance=-1.0, max_iterations=2_000)
assert len(told) == count
class Stop(Exception): pass
def stop(part): raise Stop
try:
    with dq8.progress(stop):
        dq8.mean(many, tolerance=-1.0, max_iterations=2_000)
except Stop:
    print("stopped")
"""
    done = run(code, DQ8_NUM_THREADS=threads)
    assert done.stdout == "stopped\n", done.stderr


def test_reports_and_arms_of_no_targets_are_shown():
    values = np.zeros((0, 3))
    _, report = ARM.reach(np.zeros((0, 8)), values, 3)
    assert Balanced(report._repr_html_()).rows == 1
