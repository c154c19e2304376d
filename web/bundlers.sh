#!/usr/bin/env bash
# Tests the package as npm packs it: from one tarball, bundlers, engines and compilers of TypeScript, of the versions in
# `bundlers/package.json`: `web/bundlers.sh`, or with `--quick` esbuild, Rollup, two TypeScripts, this machine's node
# and Chromium. `LEVELS`, as for `web/build.sh`, are what the tarball has; both levels by default.
set -euo pipefail
cd "$(dirname "$0")"

export QUICK=
[ "${1:-}" != --quick ] || QUICK=1
../scripts/install_missing.sh /usr/bin/chromium=chromium
command -v npm >/dev/null || ../scripts/install_missing.sh /usr/bin/node=nodejs /usr/bin/npm=npm
npm install --prefix bundlers ${QUICK:+--omit=dev} --ignore-scripts --no-package-lock --no-audit --no-fund \
  --loglevel=error
node --test bundlers/*.test.mjs
