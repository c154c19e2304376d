#!/usr/bin/env bash
# The documentation as pages of HTML: what the docstrings say, and the figures of the tutorial. Of the Python that
# $PYTHON names, which has dq8, matplotlib and SciPy, or of a new environment with this package.
#
#     ./docs.sh target/site
set -euo pipefail
cd "$(dirname "$0")"
site=${1:?the directory to write to}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

if [ -z "${PYTHON-}" ]; then
  python3 -m venv "$out/user"
  PYTHON=$out/user/bin/python
  "$PYTHON" -m pip install --quiet --disable-pip-version-check ".[scipy,dask,plot]"
fi
# Sphinx has what it needs beside, and not in that environment.
"$PYTHON" -m pip install --quiet --disable-pip-version-check --target "$out/sphinx" 'sphinx>=8,<9' 'myst-parser>=4'

mkdir -p "$out/source/figures" "$out/source/benches"
cp benches/compare.svg "$out/source/benches"
cp docs/conf.py docs/index.rst tutorial/tutorial.py "$out/source"
cp README.md "$out/source/readme.md"
cp tutorial/millions.md "$out/source/millions.md"
"$PYTHON" tutorial/tutorial.py "$out/source/figures" >/dev/null
PYTHONPATH=$out/sphinx "$PYTHON" -m sphinx -W --keep-going -q -b html "$out/source" "$site"
echo "$site/index.html"
