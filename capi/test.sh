#!/usr/bin/env bash
# The C library as its users have it: installed to a prefix, found by pkg-config and by CMake, called
# from C99 and from C++. The example returns 0 only if all it computes is right.
set -euo pipefail
cd "$(dirname "$0")"

need() { command -v "$1" >/dev/null || { echo "missing: $1 (Debian package $2)" >&2; exit 1; }; }
need gcc gcc
need g++ g++
need pkg-config pkg-config
need cmake cmake

prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
FEATURES=urdf ./install.sh "$prefix"
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig" LD_LIBRARY_PATH="$prefix/lib"
strict=(-O1 -Wall -Wextra -Werror -pedantic)
read -ra cflags < <(pkg-config --cflags dq8)
read -ra shared < <(pkg-config --libs dq8)
read -ra private < <(pkg-config --static --libs-only-l dq8)
# The static library by its name, for -l prefers the shared one; then what it needs of the system.
static=("$prefix/lib/libdq8_capi.a" "${private[@]:1}")

passes() {
  local said
  said=$("$@") || { echo "$said" >&2; echo "failed: $*" >&2; exit 1; }
  [ "${said##*$'\n'}" = PASS ] || { echo "no PASS: $*" >&2; exit 1; }
}

echo 'C99, static'
gcc -std=c99 "${strict[@]}" "${cflags[@]}" examples/arm.c "${static[@]}" -o "$prefix/arm"
passes "$prefix/arm"
echo 'C99, shared'
gcc -std=c99 "${strict[@]}" "${cflags[@]}" examples/arm.c "${shared[@]}" -lm -o "$prefix/arm"
passes "$prefix/arm"
echo 'C++11'
g++ -std=c++11 "${strict[@]}" "${cflags[@]}" -x c++ examples/arm.c -x none "${static[@]}" -o "$prefix/arm"
passes "$prefix/arm"
echo 'C99 with the address and undefined behaviour sanitizers'
gcc -std=c99 -g -fsanitize=address,undefined -fno-sanitize-recover=all "${strict[@]}" "${cflags[@]}" \
  examples/arm.c "${static[@]}" -o "$prefix/arm"
passes "$prefix/arm"

echo 'C99: a character, an arm and a scan'
gcc -std=c99 -g -fsanitize=address,undefined -fno-sanitize-recover=all "${strict[@]}" "${cflags[@]}" \
  examples/scene.c "${static[@]}" -o "$prefix/scene"
passes "$prefix/scene"

echo 'C11, one name for float and double'
gcc -std=c11 -g -fsanitize=address,undefined -fno-sanitize-recover=all "${strict[@]}" "${cflags[@]}" \
  examples/generic.c "${static[@]}" -o "$prefix/generic"
passes "$prefix/generic"

echo 'C++17 and C++20: nouns, views, exceptions'
for standard in 17 20; do
  g++ -std=c++$standard -g -fsanitize=address,undefined -fno-sanitize-recover=all "${strict[@]}" "${cflags[@]}" \
    examples/scene.cpp "${static[@]}" -o "$prefix/scene"
  passes "$prefix/scene"
done

exports() { nm -D --defined-only "$prefix/lib/libdq8_capi.so" | sed -n 's/.* T \(dq8_.*\)/\1/p' | sort -u; }
echo 'every function of C has a door in C++'
# Without -O1: that of templates takes minutes.
g++ -std=c++17 -g -fsanitize=address,undefined -fno-sanitize-recover=all "${strict[@]}" -O0 "${cflags[@]}" \
  -c tests/doors.cpp -o "$prefix/doors.o"
g++ -fsanitize=address,undefined "$prefix/doors.o" "${static[@]}" -o "$prefix/doors"
passes "$prefix/doors"
diff <(nm -u "$prefix/doors.o" | grep -o '\bdq8_[a-z0-9_]*' | sort -u) <(exports) \
  || { echo 'tests/doors.cpp does not go through these functions' >&2; exit 1; }
g++ -std=c++20 -fsyntax-only "${strict[@]}" -Wshadow "${cflags[@]}" tests/doors.cpp
if grep -n 'dq8_[a-z0-9_]*_f\(32\|64\)' tests/doors.cpp examples/*.cpp; then
  echo 'a program in C++ names a function of C' >&2
  exit 1
fi

echo 'README, in C99 and C++20'
# Each of its listings is a function. The second one poses a skeleton that the reader has.
awk 'BEGIN { print "#include <stdio.h>\n#include \"dq8.h\"\nstatic dq8_status status;\nstatic float locals[32], models[32];" }
  /^```c$/ { inside = 1; printf "static void listing_%d(void) {\n", ++count; next }
  /^```$/ && inside { inside = 0; print "if (status != DQ8_STATUS_OK) puts(dq8_status_text(status));\n}" }
  inside && !/^#include/
  END { print "int main(void) {"; for (i = 1; i <= count; i++) printf "listing_%d();\n", i; print "puts(\"PASS\"); return 0; }" }' README.md > "$prefix/readme.c"
grep -q 'listing_4()' "$prefix/readme.c" || { echo 'README has fewer than four listings' >&2; exit 1; }
read_as() { "$@" "${strict[@]}" -Wno-unused "${cflags[@]}" "$prefix/readme.c" -x none "${static[@]}" -o "$prefix/readme"; }
read_as gcc -std=c99
[ "$("$prefix/readme")" = PASS ] || { echo 'a listing of README fails' >&2; exit 1; }
read_as g++ -std=c++20 -Wno-missing-field-initializers -x c++
[ "$("$prefix/readme")" = PASS ] || { echo 'a listing of README fails' >&2; exit 1; }

# The listing in C++ is the body of a function.
awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside && !/^#include/' README.md |
  { printf '#include "dq8.hpp"\nvoid listing() {\n'; cat; echo '}'; } > "$prefix/readme.cpp"
grep -q mechanism "$prefix/readme.cpp" || { echo 'README has no listing in C++' >&2; exit 1; }
g++ -std=c++17 -fsyntax-only "${strict[@]}" -Wno-unused "${cflags[@]}" "$prefix/readme.cpp"

echo 'CMake'
mkdir "$prefix/app"
cat > "$prefix/app/CMakeLists.txt" <<EOF
cmake_minimum_required(VERSION 3.16)
project(arm C)
set(CMAKE_C_STANDARD 99)
find_package(dq8 0.1 CONFIG REQUIRED)
find_package(dq8 0.2 CONFIG QUIET)
if(dq8_FOUND)
  message(FATAL_ERROR "0.1 passes for 0.2")
endif()
foreach(kind dq8 static)
  add_executable(arm_\${kind} $PWD/examples/arm.c)
  target_link_libraries(arm_\${kind} PRIVATE dq8::\${kind} m)
endforeach()
EOF
cmake -S "$prefix/app" -B "$prefix/app/build" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$prefix/app/build" >/dev/null
passes "$prefix/app/build/arm_dq8"
passes "$prefix/app/build/arm_static"
cmake -S examples/robot -B "$prefix/robot" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$prefix/robot" >/dev/null
passes "$prefix/robot/robot" ../robot/robots/arm6.urdf tool

# Of code, not of symbols. With everything that the library has it is several times as large.
code() { size "$1" | awk 'END { print $1 }'; }
gcc -std=c99 "${cflags[@]}" examples/arm.c "${static[@]}" -Wl,--no-gc-sections -o "$prefix/whole"
[ $(($(code "$prefix/app/build/arm_static") * 2)) -lt "$(code "$prefix/whole")" ] \
  || { echo "the static example has $(code "$prefix/app/build/arm_static") bytes of code: unused functions are linked" >&2; exit 1; }

echo 'the name that the shared library asks for'
readelf -d "$prefix/app/build/arm_dq8" | grep -q 'NEEDED.*\[libdq8_capi\.so\.0\.1\]' \
  || { echo 'the program does not ask for libdq8_capi.so.0.1' >&2; exit 1; }

echo 'the header names what the library has, and nothing else'
names() { sed '/^static inline/,/^}/d' include/dq8.h | grep -o '\bdq8_[a-z0-9_]*(' | tr -d '(' | sort -u; }
diff <(names) <(exports) || { echo 'header and library differ' >&2; exit 1; }
