"""The plot of `benches/compare.py`, as it looks 800 pixels wide."""

import importlib
import itertools
from pathlib import Path

import matplotlib
import pytest
from matplotlib.text import Text

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
