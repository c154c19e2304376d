#!/usr/bin/env bash
# The Python package as its users have it: a wheel, built by pip as `pip install ./python` builds it, installed
# into a fresh environment, tested there. Arguments are those of cargo. A missing tool is a failure that says so.
#
#     DQ8_ENGINES=1 ./test.sh    # with the engines of tests/engines.txt too
set -euo pipefail
cd "$(dirname "$0")"

need() { command -v "$1" >/dev/null || { echo "missing: $1 ($2)" >&2; exit 1; }; }
need cargo 'a stable Rust toolchain, 1.89 or later'
need python3 'Debian package python3'
python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
  { echo 'missing: Python 3.11 or later, which SciPy 1.17 needs' >&2; exit 1; }
python3 -c 'import venv, ensurepip' 2>/dev/null || { echo 'missing: venv (Debian package python3-venv)' >&2; exit 1; }

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
step() { printf '%s (%ss)\n' "$*" "$SECONDS"; }

step 'format, lints'
cargo fmt --all --check
# In release, as the wheel is: what macros and build scripts need is then compiled once for both.
cargo clippy --release --workspace --all-targets -- -D warnings

step 'wheel'
# Where it stays: PyO3 is compiled again for an interpreter with another path.
build=$PWD/target/builder
"$build/bin/python" -c '' 2>/dev/null || python3 -m venv --clear "$build"
pip() { "$build/bin/python" -m pip "$@" --quiet --disable-pip-version-check --prefer-binary; }
# Where LLD links, from Rust 1.90 on, functions that resemble each other stand side by side, and are compressed better.
link=
case "$(rustc -vV)" in
*'release: 1.89.'*) ;;
*'host: x86_64-unknown-linux-gnu'*) link='-- -C link-arg=-Wl,--bp-compression-sort=both' ;;
esac
# maturin, as `pyproject.toml` asks for it, comes into an environment that lives as long as the build.
MATURIN_PEP517_ARGS="--locked --compression-level=9 $* $link" pip wheel --no-deps --wheel-dir "$out/wheels" .
pip install zopfli
"$build/bin/python" smaller.py "$out"/wheels/dq8-*.whl
# The wheel without other features: what users download.
[ -n "$*" ] || [ -z "$link" ] || [ "$(stat -c %s "$out"/wheels/dq8-*.whl)" -le 2900000 ] ||
  { echo 'the wheel is larger than 2.9 MB: look for kernels that are compiled twice' >&2; exit 1; }

step 'tests, in a fresh environment'
python3 -m venv --without-pip "$out/user"
# Modules are compiled when they are imported; most never are.
user() { pip --python "$out/user/bin/python" install --no-compile "$@"; }
user "$out"/wheels/dq8-*.whl
# What it needs of itself is NumPy alone.
(cd "$out" && user/bin/python -c 'import dq8; dq8.mul(dq8.identity(3), dq8.identity())')
user -r tests/requirements.txt
[ -z "${DQ8_ENGINES-}" ] || user -r tests/engines.txt
"$out/user/bin/python" -m pytest -q -p no:cacheprovider

step 'types'
"$out/user/bin/mypy" --strict --disable-error-code import-untyped --cache-dir "$out/mypy" --no-error-summary -p dq8
step 'done'
