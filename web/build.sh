#!/usr/bin/env bash
# Builds the package: `web/build.sh [LEVEL…]`, of simd128 and relaxed; the first alone by default. It needs Debian's rustc-web,
# cargo-web, rust-web-src and lld; no rustup target, no wasm-bindgen.
set -euo pipefail
cd "$(dirname "$0")"

../scripts/install_missing.sh /usr/bin/rustc=rustc-web /usr/bin/cargo=cargo-web \
  /usr/lib/rustlib/src/rust/library=rust-web-src /usr/bin/wasm-ld=lld
export RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_INCREMENTAL=0 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld
# Every browser since 2023 and node since 16 know these. A panic would end the module
# without a text: nobody could read one, and kernels do not panic.
export RUSTFLAGS='-Ctarget-feature=+simd128,+bulk-memory,+nontrapping-fptoint,+sign-ext -Zunstable-options -Cpanic=immediate-abort'
target=${CARGO_TARGET_DIR:-target}

[ $# -gt 0 ] || set -- simd128
for level; do
  flags=()
  case $level in
    simd128) ;;
    # The packages with lanes alone: the standard library is the same, and is not built again.
    relaxed) for package in dq8 dq8-robot dq8-simd dq8-web; do
        flags+=(--config "profile.release.package.$package.rustflags=['-Ctarget-feature=+relaxed-simd']")
      done ;;
    *) echo "no level: $level" >&2; exit 1 ;;
  esac
  for module in skeletons robots; do
    /usr/bin/cargo build --release --locked --target wasm32-unknown-unknown -Zbuild-std=std,panic_abort \
      -Zbuild-std-features=optimize_for_size -Zprofile-rustflags "${flags[@]}" --no-default-features --features "$module"
    name=dq8; [ "$module" = skeletons ] || name=robots
    cp "$target/wasm32-unknown-unknown/release/dq8_web.wasm" "package/$name.$level.wasm"
  done
done
