#!/usr/bin/env bash
# Runs the test suite on machines other than this one: foreign CPUs under QEMU's user mode, wasm32 under node.
#
#     bash tests/hosts/run.sh                       # every host, all tests
#     bash tests/hosts/run.sh aarch64 s390x         # these hosts
#     bash tests/hosts/run.sh --quick s390x         # only the tests of the lanes and the hashes of all bits but the example's
#     bash tests/hosts/run.sh --bits                # only the hashes, all of them, on every host
#     bash tests/hosts/run.sh --quick relaxed       # the tests of the lanes on wasm32 with relaxed-simd, only if it is named
#
# Needs Debian, and installs from it what is missing: no Rust target or component is downloaded. The standard library of each
# host is compiled from Debian's source.
set -euo pipefail
cd "$(dirname "$0")/../.."

# Programs have tests too, of which some look for files by other paths than those of the build; papers are in lab.
hosts=() packages=(dq8 dq8-simd dq8-simd-tests dq8-robot dq8-trajectory) programs=(dq8-mocap dq8-contest dq8-compare dq8-hand-eye) papers=(--manifest-path lab/Cargo.toml --test papers) features=() briefly=()
for argument; do
  case $argument in
    --quick) packages=(dq8-simd dq8-simd-tests) features=(--features dq8-simd/alloc) programs=() papers=() briefly=(--skip ten_thousand_steps) ;;
    --bits) packages=() programs=() papers=() ;;
    aarch64 | armv7 | s390x | wasm32 | relaxed) hosts+=("$argument") ;;
    *) echo "no such host: $argument" >&2; exit 2 ;;
  esac
done
[ ${#hosts[@]} -gt 0 ] || hosts=(aarch64 armv7 s390x wasm32)
packages=("${packages[@]/#/--package=}") programs=("${programs[@]/#/--package=}")

# What each step needs, and the Debian package that has it.
needs=(/usr/bin/rustc=rustc-web /usr/bin/cargo=cargo-web /usr/lib/rustlib/src/rust/library=rust-web-src)
for host in "${hosts[@]}"; do
  case $host in
    aarch64) needs+=(/usr/bin/qemu-aarch64=qemu-user /usr/bin/aarch64-linux-gnu-gcc=gcc-aarch64-linux-gnu
      /usr/aarch64-linux-gnu/lib/libc.so.6=libc6-dev-arm64-cross) ;;
    armv7) needs+=(/usr/bin/qemu-arm=qemu-user /usr/bin/arm-linux-gnueabihf-gcc=gcc-arm-linux-gnueabihf
      /usr/arm-linux-gnueabihf/lib/libc.so.6=libc6-dev-armhf-cross) ;;
    s390x) needs+=(/usr/bin/qemu-s390x=qemu-user /usr/bin/s390x-linux-gnu-gcc=gcc-s390x-linux-gnu
      /usr/s390x-linux-gnu/lib/libc.so.6=libc6-dev-s390x-cross) ;;
    wasm32 | relaxed) needs+=(/usr/bin/node=nodejs /usr/bin/wasm-ld=lld /usr/bin/clang=clang
      /usr/lib/wasm32-wasi/libc.a=wasi-libc) ;;
  esac
done
scripts/install_missing.sh "${needs[@]}"

# Optimised a little, because emulators are slow, and inlined as users have it (simd/build.rs); without debug information,
# because there is much to link.
export RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc RUSTC_BOOTSTRAP=1 CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}/hosts
export DQ8_CALLED_LANES=0 CARGO_PROFILE_DEV_OPT_LEVEL=1 CARGO_PROFILE_DEV_DEBUG=0 CARGO_INCREMENTAL=0
# Two workspaces, one profile: the standard library is compiled once for both.
export CARGO_PROFILE_DEV_LTO=off

# run TARGET LINKER RUNNER OPTION…: tests on one host.
run() {
  local target=$1 linker=$2 runner=$3
  local name=${target^^}
  name=${name//-/_}
  shift 3
  env "CARGO_TARGET_${name}_LINKER=$linker" "CARGO_TARGET_${name}_RUNNER=$runner" \
    /usr/bin/cargo test --quiet --no-fail-fast --target "$target" "$@"
}

# The same arguments: the hashes of everything, a workspace of its own; quickly, without the example.
bits() {
  run "$@" --manifest-path tests/bits/Cargo.toml -- "${briefly[@]}"
}

# The same arguments: the packages that are asked for.
suite() {
  local host=("${@:1:4}")
  shift 4
  [ ${#packages[@]} -eq 0 ] || run "${host[@]}" "${packages[@]}" "${features[@]}" "$@"
}

# The same arguments: the worked examples of the papers. Not where QEMU must not see optimised code, which lab is.
of_papers() {
  [ ${#papers[@]} -eq 0 ] || run "$@" "${papers[@]}"
}

table=() failed=0
for host in "${hosts[@]}"; do
  log=$(mktemp)
  status=0
  case $host in
    aarch64)
      emulated=(aarch64-unknown-linux-gnu aarch64-linux-gnu-gcc 'qemu-aarch64 -L /usr/aarch64-linux-gnu' -Zbuild-std)
      bits "${emulated[@]}" && suite "${emulated[@]}" --tests "${programs[@]}" && of_papers "${emulated[@]}" ;;
    armv7)
      emulated=(armv7-unknown-linux-gnueabihf arm-linux-gnueabihf-gcc 'qemu-arm -L /usr/arm-linux-gnueabihf' -Zbuild-std)
      bits "${emulated[@]}" && suite "${emulated[@]}" --tests "${programs[@]}" && of_papers "${emulated[@]}" ;;
    s390x)
      # Not optimised, not even what the workspace optimises for its tests: QEMU before 8.0 computes MDEBR (f32 · f32 as
      # f64) wrongly, which only the optimiser uses.
      plain=(--config 'profile.dev.package.dq8-simd.opt-level=0' --config 'profile.dev.package.dq8-contract.opt-level=0'
        --config 'profile.dev.package.dq8-fixtures.opt-level=0' --config 'profile.dev.package.dq8-arms.opt-level=0')
      emulated=(s390x-unknown-linux-gnu s390x-linux-gnu-gcc 'qemu-s390x -L /usr/s390x-linux-gnu' -Zbuild-std)
      (
        export CARGO_PROFILE_DEV_OPT_LEVEL=0
        bits "${emulated[@]}" && suite "${emulated[@]}" "${plain[@]}" --tests "${programs[@]}"
      ) ;;
    wasm32 | relaxed)
      simd=+simd128 flags=
      # node 20 has it behind a flag.
      [ "$host" = wasm32 ] || { simd+=,+relaxed-simd; flags=--experimental-wasm-relaxed-simd; }
      # Debian's C library instead of the one that rustup would bring along. Without one test that needs a thread, and
      # without the tests of programs. One compiler of node's from the start: node 20
      # crashes at the end of a program that it has begun to compile again.
      emulated=(wasm32-wasip1 wasm-ld "node --no-liftoff $flags $PWD/tests/hosts/wasi.mjs" -Zbuild-std=std,panic_abort,test)
      (
        export RUSTFLAGS="-Ctarget-feature=$simd -Clink-self-contained=no -Clink-arg=/usr/lib/wasm32-wasi/crt1-command.o
          -Clink-arg=-L/usr/lib/wasm32-wasi -Clink-arg=--allow-undefined -Clink-arg=-zstack-size=8388608"
        # With relaxed-simd products are fused with sums.
        [ "$host" = relaxed ] || bits "${emulated[@]}" || exit
        suite "${emulated[@]}" --lib --test '*' -- --skip a_long_chain_needs_no_stack
      ) ;;
  esac >"$log" 2>&1 || status=$?
  # How many tests passed: a host on which nothing ran has shown nothing.
  passed=$(awk '/^test result: ok/ { sum += $4 } END { print sum + 0 }' "$log")
  if [ "$status" -eq 0 ] && [ "$passed" -gt 0 ]; then
    table+=("$(printf '%-8s %5d tests  PASS' "$host" "$passed")")
  else
    grep -vE '^\.*$' "$log" | tail -n 60 >&2
    table+=("$(printf '%-8s %5d tests  FAIL' "$host" "$passed")")
    failed=1
  fi
  rm -f "$log"
done
printf '%s\n' "${table[@]}"
exit "$failed"
