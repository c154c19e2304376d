#!/usr/bin/env bash
# Measures dq8-retarget by MuJoCo's kinematics on robots from PyPI, and beside mink with the same goals, one thread, some
# minutes; prints tables in Markdown. Further clips may be given: run.sh [--quick] [CLIP.bvh…]. `--quick` compares dq8's
# own report with MuJoCo on one robot and one clip, in an unoptimised build.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
root=$here/../..
clips=()
for word; do
  case $word in --quick) quick=1 ;; *) clips+=("$(realpath "$word")") ;; esac
done

target=${CARGO_TARGET_DIR:-$root/target}
packages=$target/contest/mujoco
python=$packages/bin/python
"$python" -c 'import mink, mujoco, scipy, daqp' 2>/dev/null || {
  python3 -m venv --clear "$packages"
  "$python" -m pip install --quiet --disable-pip-version-check mujoco==4.0.0 mink==1.3.0 daqp==0.11.0 scipy numpy
}
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
cd "$root"
if [ -n "${quick-}" ]; then
  cargo build --quiet --package dq8-retarget-program --example retarget
  exec "$python" "$here/contest.py" --quick "$target/debug/examples/retarget"
fi

# Robots and clips with licences that permit their use (BSD, MIT); nothing of them is copied here.
"$python" -c 'from importlib.metadata import files; files("example-robot-data")' 2>/dev/null ||
  "$python" -m pip install --quiet --disable-pip-version-check --no-deps example-robot-data==6.0.0
if [ ! -d "$packages/bvhtoolbox-0.1.3" ]; then
  "$python" -m pip download --quiet --disable-pip-version-check --no-deps --no-binary bvhtoolbox bvhtoolbox==0.1.3 -d "$packages"
  tar -xzf "$packages/bvhtoolbox-0.1.3.tar.gz" -C "$packages"
fi
cargo build --quiet --release --package dq8-retarget-program --example retarget
# The last core is the one that others use least.
exec taskset -c "$(($(nproc) - 1))" "$python" "$here/contest.py" "$target/release/examples/retarget" \
  "$packages"/bvhtoolbox-0.1.3/tests/example_files/*.bvh "${clips[@]}"
