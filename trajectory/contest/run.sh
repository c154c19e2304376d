#!/usr/bin/env bash
# Measures dq8-trajectory beside its peers, one thread, about a minute, and prints a table in Markdown; installs what is missing.
# `--quick` checks all answers in an unoptimised build, but for those of evo.
set -euo pipefail
cd "$(dirname "$0")"

../../scripts/install_missing.sh /usr/bin/g++=g++ /usr/include/eigen3/Eigen/Core=libeigen3-dev
# Not beside the sources, which tests read.
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/../../target/contest}
if [ "${1-}" = --quick ]; then
  exec cargo run --quiet --locked -- --quick
fi

python=$CARGO_TARGET_DIR/evo/bin/python
"$python" -c 'import evo' 2>/dev/null || {
  python3 -m venv --clear "$CARGO_TARGET_DIR/evo"
  "$python" -m pip install --quiet --disable-pip-version-check evo==1.38.1
}
# One thread each, as dq8 takes; the last core is the one that others use least.
export OPENBLAS_NUM_THREADS=1 RUSTFLAGS=
cargo build --release --quiet --locked
exec taskset -c "$(($(nproc) - 1))" "$CARGO_TARGET_DIR/release/contest" --evo "$python" "$@"
