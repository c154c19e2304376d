#!/usr/bin/env bash
# The C example as firmware: the static library without std, linked by gcc for a Cortex-M4F with newlib,
# run in QEMU. Then every function is linked at once, and nothing of it may be able to panic or to
# allocate.
set -euo pipefail
cd "$(dirname "$0")"

need() { command -v "$1" >/dev/null || { echo "missing: $1 (Debian package $2)" >&2; exit 1; }; }
need arm-none-eabi-gcc 'gcc-arm-none-eabi, and libnewlib-arm-none-eabi'
need qemu-system-arm qemu-system-arm
need /usr/bin/cargo 'cargo-web, and rustc-web and rust-web-src'
[ -d /usr/lib/rustlib/src/rust/library ] || { echo 'missing: Debian package rust-web-src' >&2; exit 1; }

# Debian's compiler builds the library of Rust for the target, so that no target need be installed.
target=thumbv7em-none-eabihf
said=$(RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo rustc --release --lib --crate-type staticlib \
  --message-format json-render-diagnostics --manifest-path ../Cargo.toml \
  --no-default-features --features libm --target "$target" \
  -Zbuild-std=core,compiler_builtins -Zbuild-std-features=compiler-builtins-mem)
library=$(grep -o '"[^"]*/libdq8_capi\.a"' <<<"$said" | tail -n 1 | tr -d '"')
[ -n "$library" ] || { echo 'cargo did not name the library' >&2; exit 1; }

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
link() {
  arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c99 -O2 -Wall -Wextra -Werror \
    -ffunction-sections -fdata-sections -I../include --specs=rdimon.specs -nostartfiles -T link.ld \
    -Wl,--gc-sections -Wl,--no-warn-rwx-segments,-z,noexecstack "$@" start.c ../examples/arm.c "$library" -lm -o "$out/image"
}

link
arm-none-eabi-size "$out/image" | tail -n 1 | awk '{ print "image: " $1 " bytes of code, " $2 + $3 " of data" }'
said=$(timeout 60 qemu-system-arm -M mps2-an386 -display none -serial none -monitor none \
  -semihosting-config enable=on,target=native -kernel "$out/image") \
  || { echo "$said" >&2; echo 'the firmware failed' >&2; exit 1; }
echo "$said"
[ "${said##*$'\n'}" = PASS ] || { echo 'the firmware did not say PASS' >&2; exit 1; }

# Functions of trajectories, of URDF files and of packing need a heap, and the library has none of them without these features.
# A function that can panic brings core::panicking into the image, one that allocates an allocator.
mapfile -t roots < <(sed '/^static inline/,/^}/d' ../include/dq8.h | grep -o '\bdq8_[a-z0-9_]*(' | tr -d '(' | grep -vE 'dq8_(resample|trajectory|spline|urdf)_|dq8_clips_pack' | sort -u | sed 's/^/-Wl,-u,/')
link "${roots[@]}"
if arm-none-eabi-nm -C "$out/image" | grep -E 'core::(panicking|slice::index|option::|result::)|rust_begin_unwind|__rust_alloc'; then
  echo 'a function can panic or allocate' >&2
  exit 1
fi
echo "all ${#roots[@]} functions: none can panic or allocate"
