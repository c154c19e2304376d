"""`dq8.plot`, and the plot of `benches/compare.py`, as it looks 800 pixels wide."""

import importlib
import itertools
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

import dq8
import dq8.plot

matplotlib.use("agg")
BENCHES = Path(__file__).parents[1] / "benches"
SMALLEST = 9  # pixels


@pytest.fixture
def compare(monkeypatch):
    monkeypatch.syspath_prepend(BENCHES)
    return importlib.import_module("compare")


def jobs(compare, scale):
    """The jobs of the comparison, with times of every size."""
    made = [*compare.of_arrays(10), *compare.of_an_arm(10)]
    for job in made:
        # Measured without: pinocchio may be missing.
        names = [*job.contenders, "pinocchio, in a loop"]
        job.best = {name: scale * 7.123**index for index, name in enumerate(names)}
    return made


@pytest.mark.parametrize("scale", [0.9, 1.0, 37.5, 5e4])
def test_no_two_texts_of_the_plot_overlap_and_none_leaves_the_page(compare, scale):
    figure = compare.drawn(jobs(compare, scale))
    figure.canvas.draw()
    assert figure.bbox.width == 800
    texts = [text for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip()]
    # What matplotlib keeps beyond the ends of an axis is not drawn.
    boxes = [(text, text.get_window_extent()) for text in texts if is_drawn(text, figure.axes[0])]
    said = " ".join(text.get_text() for text, _ in boxes)
    assert all(word in said for word in ("logarithmic scale", "product", "SciPy", "×)"))
    for text, box in boxes:
        assert figure.bbox.x0 <= box.x0 and box.x1 <= figure.bbox.x1, text
        assert figure.bbox.y0 <= box.y0 and box.y1 <= figure.bbox.y1, text
        assert text.get_size() * figure.dpi / 72 >= SMALLEST, text
    for (one, a), (other, b) in itertools.combinations(boxes, 2):
        apart = a.x1 <= b.x0 or b.x1 <= a.x0 or a.y1 <= b.y0 or b.y1 <= a.y0
        assert apart, (one, other)


def is_drawn(text, axes):
    ticks = [*axes.xaxis.get_major_ticks(), *axes.xaxis.get_minor_ticks()]
    beyond = [tick for tick in ticks if not axes.get_xlim()[0] <= tick.get_loc() <= axes.get_xlim()[1]]
    return not any(text in (tick.label1, tick.label2) for tick in beyond)


@pytest.fixture
def axes():
    return Figure().add_subplot(projection="3d")


def lines(axes):
    return [np.array(line.get_data_3d()).T for line in axes.lines]


def test_frames_have_their_axes_where_they_are(axes):
    motion = dq8.from_rotation_translation([0, 0, 0.6, 0.8], [1.0, 2.0, 3.0])
    drawn = lines(dq8.plot.frames(axes, motion, length=2.0))
    for axis, line in enumerate(drawn):
        np.testing.assert_allclose(line, dq8.transform_points(motion, [np.zeros(3), 2 * np.eye(3)[axis]]))
    dq8.plot.frames(axes, dq8.random((2, 5), rng=1), every=4, path=True)
    assert len(axes.lines) == 3 + 1 + 3 * 3


def test_bones_join_joints_with_their_parents(axes):
    tree = dq8.Hierarchy([-1, 0, 0])
    poses = dq8.from_translation([[0.0, 0, 1], [1, 0, 1], [0, 1, 1]])
    drawn = lines(dq8.plot.skeleton(axes, tree, poses))
    np.testing.assert_array_equal(drawn, [[[0, 0, 1], [0, 0, 1]], [[1, 0, 1], [0, 0, 1]], [[0, 1, 1], [0, 0, 1]]])
    with pytest.raises(ValueError, match=r"Expected `poses` to have shape \(3, 8\), got \(2, 8\)"):
        dq8.plot.skeleton(axes, tree, poses[:2])


def test_screws_say_their_pitch_and_move_points_on_a_helix(axes):
    motion = dq8.from_twist([0.0, 0, 2.0, 0, 0, 1.0])
    drawn = lines(dq8.plot.screw(axes, motion, start=[1.0, 0, 0]))
    assert [text.get_text() for text in axes.texts] == ["pitch 0.5 per radian"]
    np.testing.assert_allclose(np.linalg.norm(drawn[0][:, :2], axis=-1), 1)
    np.testing.assert_allclose(drawn[0][-1], dq8.transform_points(motion, [1.0, 0, 0]))
    dq8.plot.screw(axes, dq8.from_translation([1.0, 0, 0]))
    assert axes.texts[1].get_text() == "a translation"
    dq8.plot.fitted(axes)
    spans = [np.ptp(bounds) for bounds in (axes.get_xlim3d(), axes.get_ylim3d(), axes.get_zlim3d())]
    np.testing.assert_allclose(spans, spans[0])
