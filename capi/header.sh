#!/usr/bin/env bash
# Writes include/dq8.h and dq8_generic.h from the sources; with --check, only says whether it is what they give.
set -euo pipefail
cd "$(dirname "$0")"

cbindgen=${CBINDGEN:-cbindgen}
command -v "$cbindgen" >/dev/null || {
  echo 'missing: cbindgen 0.29 or later (cargo install cbindgen --locked)' >&2
  exit 1
}
IFS=. read -r major minor patch < <(cargo pkgid | sed 's/.*[#@]//')
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
# Macros are expanded by rustc, which a stable one does only when told so.
RUSTC_BOOTSTRAP=1 "$cbindgen" --quiet --config cbindgen.toml --crate dq8-capi . |
  # What Rust wants said of every unsafe function, the head of the file says once.
  sed -z 's/\n \*\n \* # Safety\(\n \* [^\n]*\)*//g' |
  sed "s/@major@/$major/; s/@minor@/$minor/; s/@patch@/$patch/" > "$made/found.h"
python3 headers.py "$made/found.h" "$made"
rm "$made/found.h"
if [ "${1-}" = --check ]; then
  diff -u --exclude dq8.hpp include "$made" || { echo 'capi/include is out of date: run capi/header.sh' >&2; exit 1; }
else
  cp "$made"/* include
fi
