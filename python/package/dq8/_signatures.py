"""The functions that compute each result from one element of each argument: their parameters and shapes, one a line.

`check` behind them says that it refuses first arguments that are not unit, unless told not to.

What is generated from it: the types in `_core.pyi` (`stubs.py`), and `dq8.dask`. A test compares it with the docstrings.
"""

from __future__ import annotations

import re

TABLE = """
mul a(8),b(8)->(8)
compose a(8),b(8)->(8)
inverse motions(8)->(8)
conjugate motions(8)->(8)
normalize motions(8)->(8)
unit_or_identity motions(8)->(8)
nlerp a(8),b(8),t()->(8)
sclerp a(8),b(8),t()->(8)
squad start(8),control_start(8),control_end(8),end(8),t()->(8)
squad_control previous(8),current(8),next(8)->(8)
log motions(8)->(8)
exp logs(8)->(8)
to_twist motions(8)->(6)
from_twist twists(6)->(8)
pow motions(8),t()->(8)
to_screw motions(8)->(8)
from_screw screws(8)->(8) check
left_jacobian twists(6)->(6,6)
left_jacobian_inverse twists(6)->(6,6)
integrate_body motions(8),twists(6),dt()->(8)
integrate_spatial motions(8),twists(6),dt()->(8)
transform_points motions(8),points(3)->(3)
transform_vectors motions(8),vectors(3)->(3)
transform_lines motions(8),lines(6)->(6)
transform_planes motions(8),planes(4)->(4)
adjoint motions(8),twists(6)->(6)
coadjoint motions(8),wrenches(6)->(6)
from_translation translations(3)->(8)
from_rotation_translation rotations(4),translations(3)->(8) check
translation motions(8)->(3)
to_matrix motions(8)->(4,4)
rigidity matrices(4,4)->(3)
angle_to a(8),b(8)->()
distance_to a(8),b(8)->()
distance_weighted a(8),b(8),length_per_radian()->()
point_error a(8),b(8),points(3)->()
unit_defect motions(8)->()
"""

Shape = tuple[int, ...]


def _shape(text: str) -> Shape:
    return tuple(int(size) for size in text.split(",") if size)


def _parsed(line: str) -> tuple[str, tuple[dict[str, Shape], Shape]]:
    name, signature = line.split()[:2]
    arguments, result = signature.split("->")
    parameters = {own: _shape(shape) for own, shape in re.findall(r"(\w+)\(([\d,]*)\)", arguments)}
    return name, (parameters, _shape(result.strip("()")))


# Those that check their first argument.
CHECKED = [line.split()[0] for line in TABLE.split("\n") if line.endswith(" check")]

# By name: the shape of one element of each parameter, and of the result.
SIGNATURES: dict[str, tuple[dict[str, Shape], Shape]] = dict(map(_parsed, TABLE.split("\n")[1:-1]))
