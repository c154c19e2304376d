"""Tables that notebooks show of robots, clips and reports."""

from __future__ import annotations

import html
from collections.abc import Iterable
from typing import Any

import numpy as np

from . import _core
from ._outcome import Outcome

# More rows than a screen has are not shown.
_MOST = 30


def _cells(kind: str, values: Iterable[Any]) -> str:
    return "".join(f"<{kind}>{html.escape(str(value))}</{kind}>" for value in values)


def table(caption: str, head: Iterable[str], rows: list[list[Any]]) -> str:
    lines = [f"<tr>{_cells('td', row)}</tr>" for row in rows[:_MOST]]
    if len(rows) > _MOST:
        lines.append(f"<tr><td>and {len(rows) - _MOST} more</td></tr>")
    return f"<table><caption>{html.escape(caption)}</caption><tr>{_cells('th', head)}</tr>{''.join(lines)}</table>"


def _mechanism(self: _core.Mechanism) -> str:
    limits = [[f"{low:.4g}", f"{high:.4g}"] for low, high in self.limits]
    return table(
        f"Mechanism of {len(self)} links with {len(self.values)} values",
        ["value", "from", "to"],
        [[name, *bounds] for name, bounds in zip(self.values, limits)],
    )


def _clip(self: _core.PackedClip) -> str:
    return table(repr(self).strip("<>"), ["bytes"], [[len(self.to_bytes())]])


def _report(self: _core.ReachReport) -> str:
    outcomes, counts = np.unique(np.asarray(self.outcome), return_counts=True)
    total = int(counts.sum())
    rows = [[Outcome(int(one)).name, count, f"{count / total:.1%}"] for one, count in zip(outcomes, counts)]
    worst = [float(np.max(np.asarray(error), initial=0)) for error in (self.angular_error, self.linear_error)]
    caption = f"{total} targets; the largest errors are {worst[0]:.3g} rad and {worst[1]:.3g}"
    return table(caption, ["outcome", "targets", "part"], rows)


for _kind, _shown in ((_core.Mechanism, _mechanism), (_core.PackedClip, _clip), (_core.ReachReport, _report)):
    setattr(_kind, "_repr_html_", _shown)
