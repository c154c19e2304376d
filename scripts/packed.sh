#!/usr/bin/env bash
# The crates as users get them: packed, unpacked elsewhere, and there they, their examples and their tests compile: no file
# is missing.
set -euo pipefail
cd "$(dirname "$0")/.."

crates=(dq8-simd dq8 dq8-robot dq8-bvh dq8-retarget dq8-trajectory dq8-capi)
cargo package --quiet --allow-dirty --no-verify "${crates[@]/#/--package=}"

target=${CARGO_TARGET_DIR:-target}
elsewhere=$(mktemp -d)
trap 'rm -rf "$elsewhere"' EXIT
{
  printf '[workspace]\nresolver = "3"\nmembers = ["dq8-*"]\n[patch.crates-io]\n'
  for crate in "${crates[@]}"; do
    archive=$(ls "$target/package/$crate"-[0-9]*.crate)
    # Archives have no times; files without would not be compiled again.
    tar -xzmf "$archive" -C "$elsewhere"
    echo "$crate = { path = \"$(basename "$archive" .crate)\" }"
  done
  # What others wrote is then compiled as it was for the repository, and is there already.
  sed -n '/^\[profile/,$p' Cargo.toml
} >"$elsewhere/Cargo.toml"
cp Cargo.lock "$elsewhere"

export CARGO_TARGET_DIR=$PWD/$target
cargo check --manifest-path "$elsewhere/Cargo.toml" --workspace --features dq8-robot/urdf --lib --tests --examples
# And those of robot files pass there.
cargo test --manifest-path "$elsewhere/Cargo.toml" --package dq8-robot --features urdf --test urdf
