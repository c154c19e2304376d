#!/usr/bin/env bash
# Builds firmware for four boards, runs it under QEMU and proves what can be proved about its machine code: see docs/measured.md.
#
#     bash tests/firmware/run.sh             # everything; a table a board, and a line a proof
#     bash tests/firmware/run.sh cortex-m4   # one board
#     bash tests/firmware/run.sh --sizes     # everything; the sizes found become those that are checked
#
# Needs Debian, and installs from it what is missing: no Rust target or component is downloaded. The library of each target is
# compiled from Debian's source, which takes about half a minute a board the first time.
set -euo pipefail
cd "$(dirname "$0")"

boards=() update=()
for argument; do
  case $argument in
    --sizes) update=(--update) ;;
    cortex-m4 | aarch64 | riscv32 | x86-64) boards+=("$argument") ;;
    *) echo "no such board: $argument" >&2; exit 2 ;;
  esac
done
[ ${#boards[@]} -gt 0 ] || boards=(cortex-m4 aarch64 riscv32 x86-64)

# What each step needs, and the Debian package that has it.
needs=(/usr/bin/rustc=rustc-web /usr/bin/cargo=cargo-web /usr/lib/rustlib/src/rust/library=rust-web-src /usr/bin/ld.lld=lld
  /usr/bin/llvm-readelf=llvm /usr/bin/python3=python3 /etc/ssl/certs/ca-certificates.crt=ca-certificates)
for board in "${boards[@]}"; do
  case $board in
    cortex-m4 | aarch64) needs+=(/usr/bin/qemu-system-arm=qemu-system-arm) ;;
    riscv32) needs+=(/usr/bin/qemu-system-riscv32=qemu-system-misc) ;;
    x86-64) needs+=(/usr/bin/qemu-system-x86_64=qemu-system-x86) ;;
  esac
done
../../scripts/install_missing.sh "${needs[@]}"

export RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
semihosting=(-display none -serial none -monitor none -semihosting-config 'enable=on,target=native')

# build TARGET FLAGS PACKAGE…: with the library of the target, and the size of every stack frame in the object files.
build() {
  local target=$1 flags=$2
  shift 2
  RUSTFLAGS="-Clinker=ld.lld -Zemit-stack-sizes $flags" /usr/bin/cargo build --quiet --release --target "$target" \
    -Zbuild-std=core,compiler_builtins -Zbuild-std-features=compiler-builtins-mem "${@/#/--package=}"
}

# boot STATUS EMULATOR…: the image must end by itself with that status, in two minutes or in $limit seconds.
boot() {
  local expected=$1 status=0
  shift
  timeout "${limit:-120}" "$@" </dev/null || status=$?
  if [ "$status" -ne "$expected" ]; then
    echo "FAIL: $1 ended with status $status" >&2
    failed=1
  fi
}

# prove TARGET IMAGE
prove() {
  local out=$CARGO_TARGET_DIR/$1/release
  python3 ../../scripts/check_firmware.py "$1" "$out/libkernels.a" "$out/$2" "${update[@]}" || failed=1
}

failed=0
for board in "${boards[@]}"; do
  printf '\n=== %s (%ss)\n' "$board" "$SECONDS"
  # Instructions are counted by the clock of the emulator: `shift` says how long one takes, see each board.
  case $board in
    cortex-m4)
      target=thumbv7em-none-eabihf
      build $target -Ctarget-cpu=cortex-m4 dq8-firmware-cortex-m4 peers kernels
      for image in dq8-firmware-cortex-m4 peers; do
        boot 0 qemu-system-arm -M mps2-an386 "${semihosting[@]}" -icount shift=10,sleep=off \
          -kernel "$CARGO_TARGET_DIR/$target/release/$image"
      done
      limit=900 boot 0 qemu-system-arm -M mps2-an386 "${semihosting[@]}" -kernel "$CARGO_TARGET_DIR/$target/release/bits-$board"
      ;;
    aarch64)
      target=aarch64-unknown-none
      build $target '' dq8-firmware-aarch64 kernels
      boot 0 qemu-system-aarch64 -M virt -cpu cortex-a53 "${semihosting[@]}" -icount shift=4,sleep=off \
        -kernel "$CARGO_TARGET_DIR/$target/release/dq8-firmware-aarch64"
      ;;
    riscv32)
      target=riscv32imac-unknown-none-elf
      build $target '' dq8-firmware-riscv32 kernels
      boot 0 qemu-system-riscv32 -M virt -bios none "${semihosting[@]}" -icount shift=0,sleep=off \
        -kernel "$CARGO_TARGET_DIR/$target/release/dq8-firmware-riscv32"
      limit=900 boot 0 qemu-system-riscv32 -M virt -bios none "${semihosting[@]}" -kernel "$CARGO_TARGET_DIR/$target/release/bits-$board"
      ;;
    x86-64)
      # The bare target of this name has no SSE. This one has, and nothing of Linux is linked. Calls name what they call (plt).
      target=x86_64-unknown-linux-gnu
      build $target '-Clinker-flavor=ld -Crelocation-model=static -Zplt=yes' dq8-firmware-x86-64 kernels
      boot 33 qemu-system-x86_64 -cpu max -display none -serial none -monitor none -no-reboot -debugcon stdio \
        -device isa-debug-exit,iobase=0xf4,iosize=4 -icount shift=0,sleep=off \
        -kernel "$CARGO_TARGET_DIR/$target/release/dq8-firmware-x86-64"
      ;;
  esac
  prove $target "dq8-firmware-$board"
done

if [ $failed -ne 0 ]; then
  printf '\nfirmware: FAIL\n'
  exit 1
fi
printf '\nfirmware: PASS (%s, %ss)\n' "${boards[*]}" "$SECONDS"
