#!/usr/bin/env bash
# Builds the package: `web/build.sh [--older] [LEVEL…]`, of simd128 and relaxed; both by default, or those of the
# variable `LEVELS`. With `--older`, only modules that are older than what they are made of. Of the compilers that are
# here, in this order: with the sources of the standard library (Debian's rust-web-src, rustup's rust-src), which makes
# the smallest modules; with the library compiled for wasm32-unknown-unknown (rustup's target of that name); Debian's,
# which root installs. `RUSTC` names the only compiler that may be taken.
set -euo pipefail
cd "$(dirname "$0")"
# rustup's own programs install what a project asks for; nothing here may.
export RUSTUP_AUTO_INSTALL=0

older=
[ "${1:-}" != --older ] || { older=1; shift; }
[ $# -gt 0 ] || read -ra levels <<<"${LEVELS:-simd128 relaxed}"
[ $# -eq 0 ] || levels=("$@")
made_of=(build.sh Cargo.toml Cargo.lock src ../{,simd/,robot/}{Cargo.toml,build.rs,src})
wanted=()
for level in "${levels[@]}"; do
  [[ $level == simd128 || $level == relaxed ]] || { echo "no level: $level; simd128 and relaxed are" >&2; exit 1; }
  names=(dq8 robots)
  # Packing has no kernels, and must give the same bytes everywhere.
  [ $level = relaxed ] || names+=(pack)
  for name in "${names[@]}"; do
    file=package/$name.$level.wasm
    if [ -z "$older" ] || ! [ -e "$file" ] || [ "$(find "${made_of[@]}" -newer "$file" -print -quit)" ]; then
      wanted+=("$name.$level")
    fi
  done
done
finish() {
  cp ../LICENSE-MIT ../LICENSE-APACHE package/
  for level in simd128 relaxed; do
    [ -e "package/dq8.$level.wasm" ] && [ -e "package/robots.$level.wasm" ] ||
      echo "The package has no modules of the level $level." >&2
  done
}
[ ${#wanted[@]} -gt 0 ] || { finish; exit; }

rustlib() { echo "$("$1" --print sysroot 2>/dev/null)/lib/rustlib"; }
sources() { [ -d "$(rustlib "$1")/src/rust/library/std" ]; }
compiled() { compgen -G "$(rustlib "$1")/wasm32-unknown-unknown/lib/libstd-*.rlib" >/dev/null; }
# The first compiler that has sources or a compiled library, and the cargo beside it.
found() {
  for rustc in ${RUSTC:-rustc /usr/bin/rustc}; do
    rustc=$(command -v "$rustc") && "$1" "$rustc" || continue
    cargo=$(dirname "$rustc")/cargo
    [ -x "$cargo" ] || cargo=$(command -v cargo) || continue
    return 0
  done
  return 1
}
if ! found sources && ! found compiled; then
  if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null; then
    cat >&2 <<'WORDS'
No Rust compiler here makes WebAssembly. Any of these does:
  rustup target add wasm32-unknown-unknown
  rustup component add rust-src                            (smaller modules)
  apt-get install rustc-web cargo-web rust-web-src lld     (Debian)
WORDS
    exit 1
  fi
  ../scripts/install_missing.sh /usr/bin/rustc=rustc-web /usr/bin/cargo=cargo-web \
    /usr/lib/rustlib/src/rust/library=rust-web-src
  found sources
fi
# rustup brings a linker; Debian's compiler has none for this target.
host=$("$rustc" -vV | sed -n 's/^host: //p')
if ! [ -x "$(rustlib "$rustc")/$host/bin/rust-lld" ]; then
  linker=$(command -v wasm-ld || compgen -G '/usr/bin/wasm-ld-*' | tail -1) || {
    if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null; then
      echo 'There is no linker: wasm-ld, which Debian has in lld.' >&2
      exit 1
    fi
    ../scripts/install_missing.sh /usr/bin/wasm-ld=lld
    linker=wasm-ld
  }
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker
fi

export RUSTC=$rustc RUSTC_BOOTSTRAP=1 CARGO_INCREMENTAL=0
# Every browser since 2023 and node since 18 know these.
export RUSTFLAGS='-Ctarget-feature=+simd128,+bulk-memory,+nontrapping-fptoint,+sign-ext'
# Names of functions are 14 to 50 kilobytes. Cargo forgets `strip` for a package that has options of its own below.
RUSTFLAGS+=' -Clink-arg=--strip-all'
flags=()
if sources "$rustc"; then
  # A panic ends the module without a text: nobody could read one, and kernels do not panic. Old compilers cannot.
  abort='-Zunstable-options -Cpanic=immediate-abort'
  ! "$rustc" $abort --print cfg >/dev/null 2>&1 || RUSTFLAGS+=" $abort"
  flags=(-Zbuild-std=std,panic_abort -Zbuild-std-features=optimize_for_size)
fi
target=${CARGO_TARGET_DIR:-target}

for made in "${wanted[@]}"; do
  name=${made%.*} features=()
  # Kernels say themselves what is inlined into them. Of other functions small ones are, where all packages become one
  # module: with 20 in place of 8 robots are 0.2 kB smaller, Jacobians take 0.79 of the time, files 0.93 and reaching
  # 0.86 to 0.98; but dq8 is 0.2 kB larger and its palettes take 1.03 of the time.
  inline=20 relaxed=
  [ "$name" != dq8 ] || inline=8
  # The packages with lanes alone: the standard library is the same, and is not built again.
  [ "${made#*.}" = simd128 ] || relaxed="'-Ctarget-feature=+relaxed-simd'"
  [ -z "$relaxed" ] || for package in dq8 dq8-robot dq8-simd; do
    features+=(--config "profile.release.package.$package.rustflags=[$relaxed]")
  done
  inline="'-Cllvm-args=-inline-threshold=$inline'"
  features+=(--config "profile.release.package.dq8-web.rustflags=[$inline${relaxed:+,$relaxed}]")
  module=$name
  [ "$name" != dq8 ] || module=skeletons
  # What runs once for a file is as small as it can be.
  [ "$name" != pack ] || features+=(--config 'profile.release.package.dq8-web.opt-level="z"')
  # What these packages run while they are built is compiled for the host, which warns that it has no such feature.
  { "$cargo" build --release --locked --target wasm32-unknown-unknown "${flags[@]}" -Zprofile-rustflags \
      "${features[@]}" --no-default-features --features "$module" 2>&1 >&3 |
    sed "/unknown and unstable feature.*relaxed-simd/,/^\$/d; /(build script) generated/d
      /'+relaxed-simd' is not a recognized feature/d" >&2; } 3>&1
  cp "$target/wasm32-unknown-unknown/release/dq8_web.wasm" "package/$made.wasm"
done
finish
