#!/usr/bin/env bash
# Tests the package in node against the native library and three.js, and the page in Debian's Chromium:
# `web/test.sh [LEVEL…]`, of levels that `web/build.sh` has built; simd128 by default. A picture of the page is left in
# `web/target/page.png`.
set -euo pipefail
cd "$(dirname "$0")"

../scripts/install_missing.sh /usr/bin/chromium=chromium
command -v node >/dev/null || ../scripts/install_missing.sh /usr/bin/node=nodejs
# three.js, which palettes of glTF files are compared with.
[ -d bench/node_modules/three ] || npm install --silent --no-package-lock --prefix bench
[ $# -gt 0 ] || set -- simd128
export LEVELS="$*" CARGO_INCREMENTAL=0
cargo build --quiet --locked --example answers
relaxed=
# node 20 has relaxed-simd behind a flag; newer ones have no such flag.
if [[ $LEVELS == *relaxed* ]] && node --experimental-wasm-relaxed-simd -e 0 2>/dev/null; then
  relaxed=--experimental-wasm-relaxed-simd
fi
node $relaxed --test tests/*.test.mjs
