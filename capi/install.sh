#!/usr/bin/env bash
# Builds the C library and copies it to a prefix: header, static and shared library, pkg-config file,
# CMake package.
#
#     capi/install.sh /usr/local
set -euo pipefail
[ $# -eq 1 ] || { echo "usage: $0 PREFIX" >&2; exit 2; }
mkdir -p "$1"
prefix=$(cd "$1" && pwd)
cd "$(dirname "$0")"

# Cargo says where it has put things, and rustc which libraries of the system a static one needs.
said=$(cargo rustc --release --lib --message-format json-render-diagnostics -- --print native-static-libs 2>&1) \
  || { echo "$said" >&2; exit 1; }
libraries=$(sed -n 's/.*note: native-static-libs: //p' <<<"$said" | tail -n 1)
static=$(grep -o '"[^"]*/libdq8_capi\.a"' <<<"$said" | tail -n 1 | tr -d '"')
version=$(cargo pkgid | sed 's/.*[#@]//')
if [ -z "$static" ] || [ -z "$libraries" ]; then
  echo 'cargo did not name the library or what it needs' >&2
  exit 1
fi

mkdir -p "$prefix"/include "$prefix"/lib/pkgconfig "$prefix"/lib/cmake/dq8
install -m 644 include/dq8.h "$prefix/include/"
install -m 644 "$static" "$prefix/lib/"
install -m 755 "${static%.a}.so" "$prefix/lib/"
fill() { sed "s|@prefix@|$prefix|; s|@version@|$version|; s|@libraries@|$libraries|" "$1"; }
fill dq8.pc.in > "$prefix/lib/pkgconfig/dq8.pc"
fill cmake/dq8-config.cmake.in > "$prefix/lib/cmake/dq8/dq8-config.cmake"
