#!/usr/bin/env python3
"""The table of operations, read from the sources -> docs/operations.md; and the numbers of it in IN_PROSE.

    python3 scripts/operations_table.py            # writes the files
    python3 scripts/operations_table.py --check    # exit 1 if one differs from what the sources say

An operation is a public function of the scalar reference. The script looks for the same on lanes, in the traits, in the
kernels over slices, in the C header and in the vectors. Where it finds none there must be a reason below, or it
fails; so it does for a reason, a kernel or a C function that belongs to no operation any more.
"""

import json
import re
import sys
import tomllib
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OUT = ROOT / "docs/operations.md"
OPERATORS = {"Add": "+", "Sub": "−", "Mul": "×", "Div": "÷", "Neg": "neg"}
TRAITS = {"DualQuat": "motion", "Quat": "quaternion", "Dual": "dual_number"}
# The order of the tables, with what they are called.
TYPES = {
    "DualQuat": "Motions: `DualQuat`",
    "Quat": "Quaternions: `Quat`",
    "Dual": "Dual numbers: `Dual`",
    "DualVector": "Dual vectors: `DualVector`",
    "Line": "Lines: `Line`",
    "Plane": "Planes: `Plane`",
    "Screw": "Screws: `Screw`",
    "Twist": "Twists: `Twist`",
    "Wrench": "Wrenches: `Wrench`",
    "RotationTranslation": "Rotations with translations: `RotationTranslation`",
    "EulerAngles": "Euler angles: `EulerAngles`",
    "Polar": "Polar decomposition: `Polar`",
    "Affine": "Affine maps: `Affine`",
    "TwoBone": "Limbs of two bones: `TwoBone`",
    "": "Functions",
}

# Lanes have another name where an error becomes a mask.
ON_LANES = {
    ("Dual", "inverse"): ("Dual", "inverse_checked"),
}
IN_TRAIT = {("DualQuat", "try_normalize"): "normalize_checked", ("DualQuat", "try_inverse"): "inverse_checked",
            ("Quat", "try_normalize"): "normalize_checked"}
# C functions of one motion, `dq8_motion_…`, whose name is not that of the operation without `transform_`.
IN_C = {
    ("DualQuat", "×"): "mul",
    ("DualQuat", "is_unit"): "check_unit",
    ("DualQuat", "rotation"): "to_rotation_translation",
    ("DualQuat", "translation"): "to_rotation_translation",
    ("DualQuat", "to_matrix3x4"): "to_matrix_3x4",
    ("DualQuat", "to_matrix4"): "to_matrix_4x4",
    ("DualQuat", "try_from_matrix3x4"): "from_matrix_3x4",
    ("DualQuat", "try_from_matrix4"): "from_matrix_4x4",
    ("DualQuat", "dlb"): "blend",
    ("DualQuat", "dib"): "mean",
    ("DualQuat", "adjoint"): "twist",
    ("Quat", "from_euler"): "from_euler",
    ("Quat", "to_euler"): "to_euler",
}
NO_OPERATION_IN_C = {"identity"}
# Kernels over slices of what is no operation: fits of maps to points.
NO_OPERATION_IN_SLICES = {"fit_each"}
# Kernels of the list that Python's functions on arrays do not have under the name of the operation, and why.
NOT_IN_PYTHON = {"slerp_lerp": "of laws that take rotations and translations apart Python has none"}
# Names in the files of vectors that are not those of the functions.
IN_VECTORS = {
    "conj_dual": "conjugate_dual", "conj_quat": "conjugate", "conj_both": "conjugate_both", "point": "transform_point",
    "vector": "transform_vector", "matrix": "to_matrix3x4", "line": "transform_line", "screw": "to_screw",
    "add": "+", "sub": "−", "mul": "×", "div": "÷",
}
FUNCTIONS_IN_VECTORS = {"gram_schmidt"}

# Sentences with numbers of the page, which are written too.
IN_PROSE = {
    "docs/results.md": "{answers} of the {operations} [operations]",
    "src/guide/accuracy.md": "Of the {operations} public operations, {answers} have",
}

REASONS = {
    "a": "another order of the same numbers: lanes hold components, and their order is that of the memory they are "
         "loaded from",
    "b": "changes the type of the number, which lanes do when they load",
    "c": "goes along a sequence in memory, each element by the one before",
    "d": "a part, or a name for numbers; there is nothing to compute",
    "e": "no trait over these types: what they have in common is compared in `tests/lanes/`",
    "f": "returns an error in the reference and a mask on lanes; the trait has the form without",
    "g": "a column or a row of `left_jacobian` for each unit twist; the trait has that",
    "h": "by the parts: the other operations of the trait are made of it",
    "k": "no kernel of its own: `Kernel` and `Backend::run` run the form on lanes over any slices",
    "l": "asked for one at a time: lines, planes, maps, poses, Euler angles, directions; no kernel has many",
    "m": "not in the C interface, which has what firmware and engines call on motions in memory",
    "p": "signs, sums or copies: exact, or one rounding; the laws hold them",
    "q": "no vectors of 60 digits; every implementation is compared with the scalar path in `f64`, and that with laws "
         "and other libraries (`tests/agree.rs`, `tests/laws.rs`, `tests/metric.rs`, `tests/differential/`)",
    "t": "one text for numbers and for lanes, without a trait: there is nothing to compare",
    "u": "another way to write `EulerAngles::to_quat`, which has them",
}
PARTS = {"new", "from_array", "to_array", "from_xyzw", "from_parts", "real", "dual", "dual_scalar", "dual_vector",
         "from_dual_parts", "x", "y", "z", "w", "xyz"}
ORDERS = {"from_wxyz", "to_wxyz", "to_cols_array_2d", "to_rows_array_2d", "try_from_cols_array_2d",
          "try_from_rows_array_2d"}
OF_EULER_ANGLES = {"from_euler", "from_rpy"}
NO_LANES = {**dict.fromkeys(ORDERS, "a"), "cast": "b", "make_continuous": "c", "from_rpy": "u"}
ALONE = {"Line", "Plane", "Polar", "Affine", "RotationTranslation", "EulerAngles"}
FEW = {"from_euler", "to_euler", "look_to", "look_at", "gram_schmidt"}
EXACT = PARTS | ORDERS | {"cast", "make_continuous", "abs_diff_eq", "is_finite", "neg", "apply", "scale", "from_rotation",
                          "from_translation", "rotation", "conjugate", "is_unit", "is_normalized",
                          "needs_renormalization", "+", "−", "uniform_scale", "from_matrix3x4", "to_matrix3x4"}
# What operations are made of, for kernels of users or for C: not in the tables. Nor is anything of `vector.rs`, nor of
# `shorthand.rs`, which are other ways to write operations that are.
PIECES = {"lie_bracket", "dib", "weighted_sum"}


def functions(*folders):
    """(type, function) -> file, of all public inherent functions, and of operators."""
    found = {}
    for folder in folders:
        path = ROOT / folder
        for file in [path] if path.is_file() else sorted(path.rglob("*.rs")):
            if file.name in ("vector.rs", "shorthand.rs"):
                continue
            owner, bare = None, None
            for text in file.read_text(encoding="utf-8").splitlines():
                if block := re.match(r"impl(?:<.*?>)? (?:(\w+)(?:<.*?>)? for )?(\w+)(?:<.*>)?", text):
                    trait, kind = block.groups()
                    owner = kind if trait is None else None
                    if trait in OPERATORS and kind in TYPES:
                        found.setdefault((kind, OPERATORS[trait]), file)
                elif text == "}":
                    owner = None
                # Sums of what is two parts, or two vectors, are written by a macro.
                if (parts := re.match(r"(?:    \[.*\] #\[.*\] |sums_of_vectors!\()(\w+)(?:<\w+>:| \{)", text)) and parts[1] in TYPES:
                    for trait in ("Add", "Sub", "Neg"):
                        found.setdefault((parts[1], OPERATORS[trait]), file)
                if owner in TYPES and (name := re.match(r"    pub (?:const )?fn (\w+)", text)):
                    found.setdefault((owner, name[1]), file)
                if (bare := re.match(r"pub fn (\w+)", text)) and bare[1] not in PIECES:
                    found.setdefault(("", bare[1]), file)
    return found


def declared_kernels():
    """Kernel over slices -> the function of a motion that it is of, as the list of kernels declares them."""
    text = (ROOT / "src/slices/kernels.rs").read_text(encoding="utf-8")
    row = (r'^ {4}(\w+)(?: as "\w+" )?\[[^]]*\]\s*\([^)]*\)\s*-> \w+: \w+ \w+(?:, in place (\w+))?'
           r"\s*= ([^{}]*), \{$")
    rows = re.findall(row, text, re.M)
    if len(rows) != text.count(", {\n        ///"):
        sys.exit("src/slices/kernels.rs has a row that this script cannot read")
    found = {}
    for name, in_place, one in rows:
        function = re.search(r"(?:\.|::)(\w+)\(", one)
        for kernel in filter(None, (name, in_place)):
            found[kernel] = function[1] if function else "×"
    return found


def kernels_over_slices():
    """(type, function) -> the kernels over slices that are of it, methods of `Backend`. Of kernels that are not in the
    list, the documentation links the function, or another kernel of it."""
    of = {kernel: [("DualQuat", function)] for kernel, function in declared_kernels().items()}
    for file in sorted((ROOT / "src/slices").glob("*.rs")):
        text = file.read_text(encoding="utf-8")
        for doc, kernel in re.findall(r"((?:^    (?:///|#\[).*\n)+)    pub fn (\w+)", text, re.M):
            links = re.findall(r"`(DualQuat|TwoBone)::(\w+)`\]", doc)
            if other := re.search(r"\(Self::(\w+)\)", doc) if not links else None:
                links = of.get(other[1], [])
            of[kernel] = list(dict.fromkeys(links))
    found = {}
    for kernel, functions_of_it in of.items():
        for key in functions_of_it:
            found.setdefault(key, []).append(kernel)
    return found


def methods_of_traits():
    found = {}
    for kind, file in TRAITS.items():
        text = (ROOT / f"src/contract/{file}.rs").read_text(encoding="utf-8")
        names = set(re.findall(r"^        fn (\w+)\(", text, re.M))
        operators = {sign for name, sign in OPERATORS.items() if f"{name}<Output = Self>" in text}
        found[kind] = names | operators
    return found


def vectors():
    """(type, function) -> how many; names without a type are of motions."""
    counts = Counter()
    for file in (ROOT / "tests/vectors").glob("*.jsonl"):
        for line in file.read_text(encoding="utf-8").splitlines():
            *kind, name = json.loads(line)["op"].split("::")
            owner = kind[0] if kind else "" if name in FUNCTIONS_IN_VECTORS else "DualQuat"
            counts[owner, IN_VECTORS.get(name, name)] += 1
    return counts


# Operators and quaternions in `proofs/bounds.toml`.
IN_BOUNDS = {"×": "mul", "+": "add", "−": "sub", "try_normalize": "normalize_checked", "try_inverse": "inverse_checked"}


def how_bounded(bounds, kind, name):
    """Where the bound of an operation comes from: all forms, single and on lanes, fused and not, or the weakest of them."""
    name = IN_BOUNDS.get(name, name)
    name = {"DualQuat": name, "Quat": f"quat_{name}"}.get(kind)
    found = []
    for form in ("single", "lanes"):
        entry = bounds[form].get(name, {})
        for parts in (entry, entry.get("fused", {})):
            errors = {value for part, value in parts.items() if part not in ("by", "tapes", "fused", "lengths", "underflow", "gappa")}
            if errors:
                found.append("exact" if errors == {"0"} else "measured" if "none" in errors
                             else "proved" if parts.get("by") else "by norms")
    return next((how for how in ("measured", "by norms", "proved", "exact") if how in found), "measured")


def main():
    bounds = tomllib.loads((ROOT / "proofs/bounds.toml").read_text(encoding="utf-8"))
    reference = functions("src/scalar", "src/representation", "src/incidence")
    shared = functions("src/geometry")
    lanes = functions("src/batch")
    traits = methods_of_traits()
    kernels = {name for text in (ROOT / "src/slices").glob("*.rs")
               for name in re.findall(r"^    pub fn (\w+)", text.read_text(encoding="utf-8"), re.M)}
    kernels_of = kernels_over_slices()
    stubs = (ROOT / "python/package/dq8/_core.pyi").read_text(encoding="utf-8")
    in_python = set(re.findall(r"^def (\w+)\(", stubs, re.M))
    header = (ROOT / "capi/include/dq8.h").read_text(encoding="utf-8")
    of_c = set(re.findall(r"\bdq8_motion_(\w+)_f32\(", header))
    known = vectors()
    wrong = []

    def in_c(key):
        own = key[1].removeprefix("transform_")
        return IN_C.get(key) or (own if key[0] == "DualQuat" and own in of_c else None)

    def cells(kind, name):
        key = (kind, name)
        both = key in shared and key not in reference
        yield "yes"
        # Lanes
        other = ON_LANES.get(key)
        candidates = [other] if other else [(kind, name), (kind, name.removeprefix("try_") + "_checked")]
        twin = next((candidate for candidate in candidates if candidate and candidate in lanes), None)
        if both:
            yield "the same text"
        elif twin is None:
            yield reason(key, "l" if kind in ALONE or name in FEW else NO_LANES.get(name), "lanes")
        else:
            yield "yes" if twin[1] == name else f"`{twin[1] if twin[0] == kind else '::'.join(twin)}`"
        # Trait
        in_trait = IN_TRAIT.get(key, name)
        if kind in traits and in_trait in traits[kind]:
            yield "yes" if in_trait == name else f"`{in_trait}`"
        elif kind not in traits:
            yield reason(key, "t" if both else "e", "the trait")
        elif name in NO_LANES:
            yield reason(key, NO_LANES[name], "the trait")
        elif name in PARTS:
            yield reason(key, "d", "the trait")
        elif name.startswith(("try_", "look_")) or key == ("Dual", "inverse"):
            yield reason(key, "f", "the trait")
        elif name.endswith("jacobian_matrix") or name.endswith("jacobian_inverse_matrix"):
            yield reason(key, "g", "the trait")
        elif name in ("is_finite", "is_normalized", "to_euler"):
            yield reason(key, "h" if name != "to_euler" else "e", "the trait")
        elif name in OF_EULER_ANGLES:
            yield reason(key, "u", "the trait")
        else:
            yield reason(key, None, "the trait")
        # Kernels over slices
        of_slices = kernels_of.get(key, [])
        alone = "l" if (kind in ALONE or name in FEW) and not both else "k"
        yield ", ".join(f"`{k}`" for k in of_slices) or (
            reason(key, "d" if name in PARTS else NO_LANES.get(name, alone), "slices"))
        # C
        c = in_c(key)
        if c and c not in of_c:
            wrong.append(f"{kind}::{name}: no C function dq8_motion_{c}")
        yield f"`{c}`" if c else reason(key, "d" if name in PARTS else "m", "C")
        # Known answers
        if known[key]:
            yield str(known[key])
        elif name in EXACT:
            yield reason(key, "p", "known answers")
        elif name in OF_EULER_ANGLES:
            yield reason(key, "u", "known answers")
        else:
            yield reason(key, "q" if kind == "DualQuat" else None, "known answers")

    used = set()

    def reason(key, letter, column):
        if letter is None:
            wrong.append(f"{'::'.join(key)}: nothing in {column}, and no reason why")
            return ""
        used.add(letter)
        return f"({letter})"

    lines = [
        "# Operations",
        "",
        "Every public operation of the scalar reference, and where it is: on lanes, in the trait that both share (`Motion`, "
        "`Quaternion`, `DualNumber`), as a kernel over slices (methods of `Backend`), in C (`dq8_motion_…` for one motion; those over slices have the names of the "
        "kernels, without `transform_`), and how many "
        "answers of 60 digits it is held to: the bounds (`digits` in `tests/contract/operations.rs`) are enforced on these "
        "answers, and are not proved for other input. A name in a cell is the name there. On lanes, errors are masks: what is `try_…` "
        "in the reference, or returns an error, ends in `_checked` there.",
        "",
        "Written by `scripts/operations_table.py` from the sources; `.ci/run` fails where the two differ. Jobs over memory "
        "(hierarchies, mechanisms, skins, trajectories, fits) are not operations, and not here; nor are the short ways to write some of "
        "these in [shorthand.rs](../src/representation/shorthand.rs).",
        "",
        "**Error** says where the bound of the rounding error comes from, in units of the roundoff and of the lengths of the "
        "arguments, against the formula computed exactly on the given floats: *exact*, nothing is rounded; *proved*, by Coq, of the "
        "operations that the code does, single motions and lanes, fused and not; *by norms*, the same analysis by a program of "
        "our own; all three of every input on the ordinary path ([what that is](../proofs/README.md)), with their numbers in [bounds.toml](../proofs/bounds.toml), and enforced by a search "
        "that climbs. *measured*: enforced on the inputs of the tests.",
        "",
        "| | reason why there is none |",
        "|---|---|",
    ]
    body = []
    total, by = Counter(), Counter()
    every = reference | {key: file for key, file in shared.items() if key not in reference}
    for kind, title in TYPES.items():
        rows = sorted(key for key in every if key[0] == kind)
        if not rows:
            wrong.append(f"no operation of {kind}")
            continue
        body += ["", f"## {title}", "", "| operation | scalar | lanes | trait | slices | C | answers | error |",
                 "|---|---|---|---|---|---|---|---|"]
        for key in rows:
            row = list(cells(*key))
            row.append(how_bounded(bounds, *key))
            if row[-1] == "measured" and row[5] == "(p)":
                row[-1] = "(p)"
            by[row[-1]] += 1
            total["operations"] += 1
            total["lanes"] += not row[1].startswith("(")
            total["trait"] += not row[2].startswith("(")
            total["answers"] += not row[5].startswith("(")
            where = f"../{every[key].relative_to(ROOT).as_posix()}"
            body.append(f"| [`{key[1]}`]({where}) | " + " | ".join(row) + " |")
    for kernel, name in declared_kernels().items():
        name = {"×": "mul"}.get(name, name)
        if (name in in_python or f"{name}s" in in_python) == (name in NOT_IN_PYTHON):
            wrong.append(f"Backend::{kernel}: python/package/dq8/_core.pyi should have {name}, or a reason why not here")
    mapped = {name for names in kernels_of.values() for name in names}
    wrong += [f"Backend::{name} belongs to no operation" for name in sorted(kernels - mapped - NO_OPERATION_IN_SLICES)]
    wrong += [f"Backend::{name} is no kernel without an operation" for name in sorted(NO_OPERATION_IN_SLICES - (kernels - mapped))]
    wrong += [f"dq8_motion_{name} belongs to no operation"
              for name in sorted(of_c - set(map(in_c, every)) - NO_OPERATION_IN_C)]
    wrong += [f"vectors of {'::'.join(key)} belong to no operation" for key in known if key not in every]
    wrong += [f"the reason ({letter}) is not used" for letter in sorted(set(REASONS) - used)]
    wrong += [f"{'::'.join(key)} in a list of this script is no operation"
              for key in [*ON_LANES, *IN_TRAIT, *kernels_of, *IN_C] if key not in every]
    if wrong:
        sys.exit("\n".join(dict.fromkeys(wrong)))
    lines += [f"| ({letter}) | {text} |" for letter, text in REASONS.items()]
    lines += ["", f"{total['operations']} operations; {total['lanes']} are on lanes, {total['trait']} in a trait, "
              f"{total['answers']} have answers of 60 digits. Errors: "
              f"{by['proved']} proved, {by['by norms']} by norms, {by['exact']} exact."]
    text = "\n".join(lines + body) + "\n"
    files = {OUT: text}
    for file, pattern in IN_PROSE.items():
        old = (ROOT / file).read_text(encoding="utf-8")
        sentence = pattern.format(answers=total["answers"], operations=total["operations"])
        any_numbers = re.escape(pattern).replace(r"\{answers\}", r"\d+").replace(r"\{operations\}", r"\d+")
        files[ROOT / file], times = re.subn(any_numbers, sentence, old)
        if times != 1:
            sys.exit(f"{file} should say once: {sentence}")
    for file, text in files.items():
        if "--check" not in sys.argv:
            file.write_text(text, encoding="utf-8")
        elif not file.exists() or file.read_text(encoding="utf-8") != text:
            sys.exit(f"{file.relative_to(ROOT)} is not what the sources say: run scripts/operations_table.py")
    print(f"{total['operations']} operations, {total['lanes']} on lanes, {total['trait']} in a trait")


main()
