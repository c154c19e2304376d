#!/usr/bin/env python3
"""Minimax coefficients of the even functions in the lane kernels -> src/batch/even_coefficients.rs.

    pip install mpmath                     # the only dependency; Python 3.11
    python3 scripts/fit_even.py            # writes the file, prints the table (a minute)
    python3 scripts/fit_even.py --check    # derives it again (seconds), exit 1 if the committed file differs

The argument is the square of the angle or chord, so no kernel takes a square root. Every polynomial runs on a dual
number: p and p' are both results. A fit that is minimax in p is poor there, because its
derivative error peaks at the ends of the interval, some degree^2 times larger. So Remez levels the error of p' against
f', and p(0) = f(0) fixes the integral: the error of p is then far below that of p', and ARC needs one degree less.
LEFT and INVERSE are the coefficients of x × (x × y) in the left Jacobian of SE(3) and in its inverse.
"""

import sys
import textwrap
from functools import cache
from pathlib import Path

from mpmath import mp, mpf

OUT = Path(__file__).resolve().parent.parent / "src/batch/even_coefficients.rs"
BITS = {"F32": 24, "F64": 53}
# The pick, and what it has to meet as (value, derivative); `!` in the table marks a row that does not.
DEGREE = {
    "ARC": {"F32": 10, "F64": 21},
    "SINC": {"F32": 5, "F64": 8},
    "COS": {"F32": 5, "F64": 8},
    "LEFT": {"F32": 6, "F64": 10},
    "INVERSE": {"F32": 8, "F64": 16},
}
BOUND = {"F32": (1.5e-8, 3e-8), "F64": (3e-17, 1e-16)}
# Where f(0) and f'(0) are no floats themselves, nothing is better than half a unit of the last place.
BOUND_INEXACT = {"F32": (6e-8, 6e-8), "F64": (1.2e-16, 1.2e-16)}

mp.prec = 400  # small y to the power 23 must still be far above the noise
V_END = (mp.pi / 2) ** 2 * mpf("1.02")  # half an angle, squared, once the sign is fixed; 2 % to spare


def arc(c):
    s = mp.sqrt(c) / 2
    k = mp.asin(s) / s if c else mpf(1)
    return k, (1 / mp.sqrt(1 - s * s) - k) / (2 * c) if c else mpf(1) / 24


def sinc(v):
    s = mp.sqrt(v)
    k = mp.sin(s) / s if v else mpf(1)
    return k, (mp.cos(s) - k) / (2 * v) if v else -mpf(1) / 6


def cos(v):
    return mp.cos(mp.sqrt(v)), -sinc(v)[0] / 2


def left(u):
    s = mp.sqrt(u)
    k = (s - mp.sin(s)) / s**3 if u else mpf(1) / 6
    return k, ((1 - mp.cos(s)) / u - 3 * k) / (2 * u) if u else -mpf(1) / 120


def inverse(u):
    h = mp.sqrt(u) / 2
    c = h * mp.cot(h) if u else mpf(1)
    k = (1 - c) / u if u else mpf(1) / 12
    return k, ((c * c + u / 4 - c) / (2 * u) - k) / u if u else mpf(1) / 720


# name: (f and f', end of the interval, its spelling, formula, kind of error: cos reaches 0, so its error is absolute)
FUNCTIONS = {
    "ARC": (arc, mpf(2), "2", "arcsin(√c/2)/(√c/2)", "relative"),
    "SINC": (sinc, V_END, "1.02·(π/2)²", "sin(√v)/√v", "relative"),
    "COS": (cos, V_END, "1.02·(π/2)²", "cos(√v)", "absolute"),
    "LEFT": (left, 4 * V_END, "1.02·π²", "(√u − sin √u)/√u³", "relative"),
    "INVERSE": (inverse, 4 * V_END, "1.02·π²", "(1 − (√u/2) cot(√u/2))/u", "relative"),
}


def rounded(x, bits):
    """Nearest number of so many bits: exactly f32 or f64, as nothing here comes near overflow or underflow."""
    with mp.workprec(bits):
        return +x


@cache
def samples(name, count, bits=None):
    """(y, f, f', scale of f, scale of f') from 0 to the end: dense at both, or even and on numbers of the format."""
    f, end, *_, kind = FUNCTIONS[name]
    rows = []
    for i in range(count + 1):
        y = rounded(end * i / count, bits) if bits else end * (1 - mp.cos(mp.pi * i / count)) / 2
        v, d = f(y)
        rows.append((y, v, d, abs(v), abs(d)) if kind == "relative" else (y, v, d, mpf(1), mpf(1)))
    return rows


def alternation(error, want):
    """Indices of `want` extrema of alternating sign, the largest among them."""
    runs = []
    for i, e in enumerate(error):
        if runs and (e > 0) == (error[runs[-1]] > 0):
            runs[-1] = max(runs[-1], i, key=lambda j: abs(error[j]))
        else:
            runs.append(i)
    while len(runs) > want:
        size = [abs(error[i]) for i in runs]
        k = size.index(min(size))
        if len(runs) == want + 1:  # only an end can go without breaking the alternation
            del runs[0 if size[0] < size[-1] else -1]
        elif k in (0, len(runs) - 1):
            del runs[k]
        else:  # a small inner wiggle goes with its smaller neighbour
            j = k - 1 if size[k - 1] < size[k + 1] else k
            del runs[j : j + 2]
    return runs


def remez(columns, target):
    """Coefficients that minimise max |target - sum c_k columns_k| over the samples: the discrete exchange algorithm."""
    n, count = len(columns), len(target)
    reference = [int(count * (r + 0.5) / (n + 1)) for r in range(n + 1)]
    for _ in range(60):
        system = mp.matrix([[c[i] for c in columns] + [(-1) ** r] for r, i in enumerate(reference)])
        *c, level = mp.lu_solve(system, mp.matrix([target[i] for i in reference]))
        error = [t - mp.fdot(c, row) for t, *row in zip(target, *columns)]
        if max(map(abs, error)) <= abs(level) * mpf("1.0001"):
            return c
        reference = alternation(error, n + 1)
    raise ArithmeticError("Remez did not converge")


def fit(name, degree, bits, of="derivative"):
    """Coefficients from the constant up, each rounded before all above it are fitted again.

    The first two are f(0) and f'(0), rounded: where f(0) = 1 the identity is exact, and a tiny screw is as good
    as the format allows. So the derivative's error at 0 is given; the weight y/(y + end/1000) keeps it from setting the
    level elsewhere.
    """
    zero, *points = samples(name, 20 * degree)
    coefficients = [rounded(zero[1], bits), rounded(zero[2], bits)]
    powers = range(1, degree + 1)
    if of == "derivative":
        end = points[-1][0]
        weight = [y / (y + end / 1000) / scale for y, *_, scale in points]
        columns = [[w * k * y ** (k - 1) for w, (y, *_) in zip(weight, points)] for k in powers]
        rest = [w * d for w, (_, _, d, *_) in zip(weight, points)]
    else:  # what the table compares with
        columns = [[y**k / scale for y, _, _, scale, _ in points] for k in powers]
        rest = [(v - coefficients[0]) / scale for _, v, _, scale, _ in points]
    while True:
        settled = columns.pop(0)
        rest = [r - coefficients[-1] * s for r, s in zip(rest, settled)]
        if not columns:
            return coefficients
        coefficients.append(rounded(remez(columns, rest)[0], bits))


def horner(coefficients, y, bits, fused):
    """p and p' in one pass, each operation rounded to so many bits as the CPU does it."""
    with mp.workprec(bits):
        p, slope = coefficients[-1], mpf(0)
        for c in reversed(coefficients[:-1]):
            slope, p = mp.fmul(slope, y, exact=fused) + p, mp.fmul(p, y, exact=fused) + c
    return p, slope


def error(name, coefficients, bits=None, fused=True):
    """Largest error of p and of p', in exact arithmetic or in the format's own."""
    worst = [mpf(0), mpf(0)]
    for y, v, d, *scale in samples(name, 4000, bits):
        for i, (got, want) in enumerate(zip(horner(coefficients, y, bits or mp.prec, fused), (v, d))):
            worst[i] = max(worst[i], abs(got - want) / scale[i])
    return worst


def literal(x, bits):
    """Shortest decimal that reads back as x."""
    shortest = next(s for n in range(1, 18) if rounded(mpf(s := f"{float(x):.{n}g}"), bits) == x)
    return shortest.replace("e-0", "e-") if "." in shortest or "e" in shortest else shortest + ".0"


def short(errors):
    return [f"{float(e):.1e}".replace("e-0", "e-") for e in errors]


def documented(text):
    """A doc comment of lines of at most 100 bytes, as scripts/comments.py wraps them."""
    lines = ["///"]
    for word in text.split():
        if len(f"{lines[-1]} {word}".encode()) > 100:
            lines.append("///")
        lines[-1] += f" {word}"
    return "".join(f"{line}\n" for line in lines)


def rust():
    text = (
        "//! Coefficients of the even functions, lowest degree first, for polynomials of dual numbers.\n//!\n"
        "//! The program `scripts/fit_even.py` writes this file and says how the coefficients are found. To\n"
        "//! change them, edit the program and run `pip install mpmath && python3 scripts/fit_even.py`. With\n"
        "//! `--check` the program compares this file with its own result and writes nothing.\n"
    )
    for name, (_, _, end, formula, kind) in FUNCTIONS.items():
        for precision, bits in BITS.items():
            c = fit(name, DEGREE[name][precision], bits)
            value, derivative = short(error(name, c))
            about = (
                f"Coefficients of a polynomial of degree {len(c) - 1} for {formula} on [0, {end}]. The {kind} error of the "
                f"fit is {value}, and that of its derivative is {derivative}."
            )
            text += "\n" + documented(about)
            text += f"pub(crate) const {name}_{precision}: [{precision.lower()}; {len(c)}] ="
            row = ", ".join(literal(x, bits) for x in c)
            # In rows, which rustfmt is told to leave alone: it would have a line for each number.
            rows = textwrap.wrap(row + ",", 96)
            text += " [\n" + "".join(f"    {row}\n" for row in rows) + "];\n"
    return text


def table():
    print("Error of value / derivative with the rounded coefficients, relative (cos: absolute): in exact arithmetic,")
    print("then in the format's own. * emitted, ! fit over the bound; a fit of the value is there for comparison.\n")
    print("| set | degree | fit of | fit error | fused | unfused |\n|---|---|---|---|---|---|")
    for name, precision in ((n, p) for n in FUNCTIONS for p in BITS):
        bits, pick = BITS[precision], DEGREE[name][precision]
        bounds = (BOUND if samples(name, 4000)[0][1] == 1 else BOUND_INEXACT)[precision]
        rows = [("derivative", d) for d in range(pick - 2, pick + 3)] + [("value", d) for d in range(pick, pick + 2)]
        for of, degree in rows:
            c = fit(name, degree, bits, of)
            errors = [error(name, c), error(name, c, bits, True), error(name, c, bits, False)]
            over = any(e > bound for e, bound in zip(errors[0], bounds))
            mark = "*" * ((of, degree) == ("derivative", pick)) + "!" * over
            cells = [f"{name}_{precision}", f"{degree}{mark}", of, *(" / ".join(short(e)) for e in errors)]
            print("|", " | ".join(cells), "|", flush=True)


if __name__ == "__main__":
    text = rust()
    if "--check" in sys.argv[1:]:
        sys.exit(0 if OUT.read_text("utf-8") == text else f"{OUT} is not what {Path(__file__).name} derives")
    OUT.write_text(text, "utf-8")
    table()
