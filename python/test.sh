#!/usr/bin/env bash
# The Python package as its users have it: a wheel, built by maturin in an environment of its own, installed
# into a fresh one, tested there. A missing tool is a failure that says so.
set -euo pipefail
cd "$(dirname "$0")"

need() { command -v "$1" >/dev/null || { echo "missing: $1 ($2)" >&2; exit 1; }; }
need cargo 'a stable Rust toolchain, 1.89 or later'
need python3 'Debian package python3'
python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
  { echo 'missing: Python 3.11 or later, which SciPy 1.17 needs' >&2; exit 1; }
python3 -c 'import venv, ensurepip' 2>/dev/null || { echo 'missing: venv (Debian package python3-venv)' >&2; exit 1; }

echo 'format, lints'
cargo fmt --check
cargo clippy --all-targets -- -D warnings

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
echo 'wheel'
python3 -m venv "$out/build"
"$out/build/bin/pip" install --quiet 'maturin>=1.9,<2'
"$out/build/bin/maturin" build --release --locked --quiet --interpreter "$out/build/bin/python" --out "$out/wheels"

echo 'tests, in a fresh environment'
python3 -m venv "$out/user"
"$out/user/bin/pip" install --quiet "$out"/wheels/dq8-*.whl
# What it needs of itself is NumPy alone.
(cd "$out" && user/bin/python -c 'import dq8; dq8.mul(dq8.identity(3), dq8.identity())')
"$out/user/bin/pip" install --quiet -r tests/requirements.txt
"$out/user/bin/python" -m pytest -q -p no:cacheprovider

echo 'types'
"$out/user/bin/mypy" --strict --disable-error-code import-untyped --cache-dir "$out/mypy" --no-error-summary -p dq8
