#!/usr/bin/env bash
# Builds the C library and copies it to a prefix: header, static and shared library, pkg-config file,
# CMake package.
#
#     capi/install.sh /usr/local
#     FEATURES=reproducible capi/install.sh /usr/local    # with what dq8_set_reproducible needs
#     FEATURES=urdf capi/install.sh /usr/local            # with robots from URDF files
set -euo pipefail
[ $# -eq 1 ] || { echo "usage: $0 PREFIX" >&2; exit 2; }
mkdir -p "$1"
prefix=$(cd "$1" && pwd)
cd "$(dirname "$0")"

version=$(cargo pkgid | sed 's/.*[#@]//')
# Before 1.0 a new minor version may change the ABI.
abi=$(sed -E 's/^(0\.[0-9]+|[0-9]+).*/\1/' <<<"$version")
case "$(uname -s)" in
  Darwin)
    built=dylib soname="libdq8_capi.$abi.dylib" shared="libdq8_capi.$version.dylib"
    name="-Wl,-install_name,@rpath/$soname" unused=-Wl,-dead_strip ;;
  MINGW* | MSYS* | CYGWIN*)
    echo 'on Windows, cargo build --release in capi/ makes dq8_capi.dll, .dll.lib and .lib; this script copies none' >&2
    exit 1 ;;
  *)
    built=so soname="libdq8_capi.so.$abi" shared="libdq8_capi.so.$version"
    name="-Wl,-soname,$soname" unused=-Wl,--gc-sections ;;
esac

# Cargo says where it has put things, and rustc which libraries of the system a static one needs.
said=$(cargo rustc --release --lib --features "${FEATURES-}" --message-format json-render-diagnostics -- \
  -C link-arg="$name" --print native-static-libs 2>&1) \
  || { echo "$said" >&2; exit 1; }
libraries=$(sed -n 's/.*note: native-static-libs: //p' <<<"$said" | tail -n 1)
static=$(grep -o '"[^"]*/libdq8_capi\.a"' <<<"$said" | tail -n 1 | tr -d '"')
if [ -z "$static" ] || [ -z "$libraries" ]; then
  echo 'cargo did not name the library or what it needs' >&2
  exit 1
fi

mkdir -p "$prefix"/include/dq8 "$prefix"/lib/pkgconfig "$prefix"/lib/cmake/dq8
install -m 644 include/dq8.h include/dq8_generic.h include/dq8.hpp "$prefix/include/"
install -m 644 include/dq8/*.hpp "$prefix/include/dq8/"
install -m 644 "$static" "$prefix/lib/"
install -m 755 "${static%.a}.$built" "$prefix/lib/$shared"
# The name that programs ask for at run time, and the one that the linker looks for.
ln -sf "$shared" "$prefix/lib/$soname"
ln -sf "$soname" "$prefix/lib/libdq8_capi.$built"
# The name by which headers know that the library reads URDF files.
case " ${FEATURES-} " in *[\ ,]urdf[\ ,]*) defined=DQ8_URDF ;; *) defined= ;; esac
fill() {
  sed "s|@flags@|${defined:+ -D$defined}|; s|@defined@|$defined|; s|@prefix@|$prefix|; s|@version@|$version|; s|@libraries@|$libraries|; s|@shared@|$shared|; s|@soname@|$soname|
    s|@unused@|$unused|" "$1"
}
fill dq8.pc.in > "$prefix/lib/pkgconfig/dq8.pc"
fill cmake/dq8-config-version.cmake.in > "$prefix/lib/cmake/dq8/dq8-config-version.cmake"
fill cmake/dq8-config.cmake.in > "$prefix/lib/cmake/dq8/dq8-config.cmake"
