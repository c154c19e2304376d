#!/usr/bin/env python3
"""Known answers for the operations that reference.jsonl leaves out -> tests/vectors/more.jsonl, geometry.jsonl.

    pip install mpmath                       # the only dependency; Python 3.11
    python3 scripts/make_vectors.py          # writes the files (two minutes of one core)
    python3 scripts/make_vectors.py --check  # derives them again, exit 1 if a committed file differs
    sha256sum --check --quiet tests/vectors/derived.sha256  # nothing has changed since they were written

more.jsonl is of motions; geometry.jsonl is of everything else: lines, planes, quaternions and other
forms of rotations, maps, dual numbers, twists.

The truth shares definitions with the crate, not methods. A quaternion is the 2×2 matrix w − i(xX + yY + zZ) with
Pauli's X, Y, Z, and σ = p + εq is the 4×4 matrix [p q; 0 p]. Products, inverses, square roots, logarithms and exponentials are those of
matrices, which know nothing of screws, half angles or dual numbers; rigid matrices are exponentials of skew ones. Twists are what
they are to 4×4 real matrices, [ω× v; 0 0], and every derivative is held to the real matrices as well.

One JSON object a line: op, kind, inputs by name, and the answer as text with 20 digits. σ is [pw,px,py,pz, qw,qx,qy,qz].
Inputs are exactly binary32 numbers, so that f32 and f64 start from the same. Only `rows` of rigid matrices, the axis
`l`, `m` of from_screw, the `derivative` of velocity and the motions `s` of dib are text with 20 digits, which each type
rounds: rigid ones are no binary32 numbers. A quaternion is [w,x,y,z], a pose that and a translation, a line [l,m], a plane
[n,d], a dual number [a,b]; `order` is a place in EulerOrder::ALL.
In more.jsonl the answers of add, sub, scale, scale_dual, dot, canonical and mul_rotation_translation are those of the inputs as they
stand; all others of the inputs normalized exactly, but for `derivative`, which is taken as it stands. In
geometry.jsonl quaternions, motions and poses are normalized exactly where the operation wants unit ones; lines and planes are
where the operation does it.
"""

import hashlib
import json
import multiprocessing
import os
import sys
from pathlib import Path

# With gmpy2, where there happens to be one, the last digits of a logarithm are others.
os.environ["MPMATH_NOGMPY"] = "1"
from mpmath import mp, mpf

from vectors import blends, distances, duals, incidence, maps, motions, quaternions, rotations, screws, velocities
from vectors.inputs import rng

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "tests/vectors"
FILES = {
    "more.jsonl": {**motions.OPERATIONS, **distances.OPERATIONS, **velocities.OPERATIONS, **blends.OPERATIONS},
    "geometry.jsonl": {
        **incidence.OPERATIONS, **rotations.OPERATIONS, **maps.OPERATIONS, **quaternions.OPERATIONS, **duals.OPERATIONS,
        **screws.OPERATIONS,
    },
}
OPERATIONS = {op: rows for operations in FILES.values() for op, rows in operations.items()}


def text(value):
    """What is not exactly binary32 as text; what is only noise beside a number of size 1 as zero."""
    if isinstance(value, list):
        return [text(v) for v in value]
    return value if isinstance(value, float) else mp.nstr(mp.chop(mpf(value), tol=mpf(10) ** -62), 20)


def lines(op):
    rng.seed(op)  # so that its rows do not depend on those before it
    made = []
    for kind, inputs, out in OPERATIONS[op]():
        numbers_of_row = {name: text(value) for name, value in {**inputs, "out": out}.items()}
        made.append(json.dumps({"op": op, "kind": kind, **numbers_of_row}, separators=(",", ":")) + "\n")
    return "".join(made)


if __name__ == "__main__":
    with multiprocessing.Pool() as pool:
        made = dict(zip(OPERATIONS, pool.map(lines, OPERATIONS, chunksize=1)))
    for file, operations in FILES.items():
        out, text_of_file = FOLDER / file, "".join(made[op] for op in operations)
        if "--check" not in sys.argv[1:]:
            out.write_text(text_of_file, "utf-8")
        elif out.read_text("utf-8") != text_of_file:
            sys.exit(f"{out} is not what {Path(__file__).name} derives")
    if "--check" not in sys.argv[1:]:
        sources = [Path(__file__).resolve(), *sorted((ROOT / "scripts/vectors").glob("*.py")), *(FOLDER / file for file in FILES)]
        sums = (f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.relative_to(ROOT)}\n" for path in sources)
        (FOLDER / "derived.sha256").write_text("".join(sums), "utf-8")
