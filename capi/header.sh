#!/usr/bin/env bash
# Writes what is generated in include/ from the sources; with --check, only says whether it is what they give.
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
python3 cpp.py "$made/dq8.h" "$made"
for file in dq8.h dq8_generic.h dq8/abi.hpp dq8/arrays.hpp; do
  if [ "${1-}" = --check ]; then
    diff -u "include/$file" "$made/$file" || { echo 'capi/include is out of date: run capi/header.sh' >&2; exit 1; }
  else
    cp "$made/$file" "include/$file"
  fi
done
