#!/usr/bin/env python3
"""The polynomials of src/batch/even_coefficients.rs are as near to their functions as its comments say: Sollya's supnorm
proves it, with v = x² for the variable, so that no root is taken near 0."""

import re
import subprocess
import sys
from pathlib import Path

FILE = Path(__file__).resolve().parent.parent / "src/batch/even_coefficients.rs"
# Both sides times what makes them analytic, of x with v = x² (c = x² of ARC); and from where: below, the terms that are left
# out are smaller than the roundoff.
FUNCTIONS = {
    "ARC": ("x/2*P", "asin(x/2)", "[2^(-8); sqrt(2)]", "relative"),
    "SINC": ("x*P", "sin(x)", "[2^(-10); 1.5811388]", "relative"),
    "COS": ("P", "cos(x)", "[0; 1.5811388]", "absolute"),
    "LEFT": ("x^3*P", "x-sin(x)", "[2^(-3); 3.1622776]", "relative"),
    "INVERSE": ("x^2*P", "1-x/2*cos(x/2)/sin(x/2)", "[2^(-3); 3.1622776]", "relative"),
}


def main():
    text = FILE.read_text(encoding="utf-8")
    wrong = []
    pattern = r"///[^\n]* fit error ([\d.e-]+), [^\n]*\npub\(crate\) const (\w+)_(F\d\d): \[.*?\] =\s*\[(.*?)\];"
    found = re.findall(pattern, text, re.S)
    for claimed, name, real, numbers in found:
        polynomial, function, domain, kind = FUNCTIONS[name]
        rounding = "single" if real == "F32" else "double"
        terms = "+".join(f"{rounding}({c.strip()})*x^{2 * i}" for i, c in enumerate(numbers.split(",")) if c.strip())
        script = f"""prec = 160; verbosity = 0;
P = {terms};
r = supnorm({polynomial.replace("P", f"({terms})")}, {function}, {domain}, {kind}, 2^(-8));
print(sup(r)); quit;
"""
        run = subprocess.run(["sollya"], input=script, capture_output=True, text=True, check=False, timeout=300)
        try:
            bound = float(run.stdout.split()[-1])
        except (IndexError, ValueError):
            bound = float("nan")
        # Claims are rounded to two digits.
        holds = bound <= float(claimed) * 1.05
        print(f"{name}_{real}: {bound:.3e}, {claimed} said", flush=True)
        if not holds:
            wrong.append(f"{name}_{real}")
    if wrong or not found:
        sys.exit(f"not proved: {', '.join(wrong) or 'nothing found'}")


main()
