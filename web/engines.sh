#!/usr/bin/env bash
# Runs the bench in three engines, each against flat JavaScript in the same run: V8 (node, chromium), SpiderMonkey
# (firefox) and JavaScriptCore (jsc; webkit, GTK's browser): `web/engines.sh [NAME…]`, all by default. Answers
# are compared with those of peers, and all engines must have the same bits. In firefox and webkit the page is driven
# first, as `web/test.sh` drives it in chromium; pictures are left in `web/target/engines`. The level is simd128.
set -euo pipefail
cd "$(dirname "$0")"

[ $# -gt 0 ] || set -- node chromium firefox jsc webkit
needs=()
command -v node >/dev/null || needs+=(/usr/bin/node=nodejs)
[ -d bench/node_modules/three ] || command -v npm >/dev/null || needs+=(/usr/bin/npm=npm)
for engine; do
  case $engine in
    node) ;;
    chromium) needs+=(/usr/bin/chromium=chromium) ;;
    firefox) needs+=(/usr/bin/firefox-esr=firefox-esr /usr/bin/xvfb-run=xvfb /usr/bin/xauth=xauth) ;;
    jsc) needs+=(/usr/bin/jsc=libjavascriptcoregtk-4.0-bin) ;;
    webkit) needs+=(/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser=libwebkit2gtk-4.1-0 /usr/bin/xvfb-run=xvfb
      /usr/bin/xauth=xauth /usr/bin/WebKitWebDriver=webkit2gtk-driver) ;;
    *) echo "no engine: $engine; node, chromium, firefox, jsc and webkit are" >&2; exit 1 ;;
  esac
done
missing() { for need in "${needs[@]}"; do [ -e "${need%%=*}" ] || echo "$need"; done; }
if [ "$(missing)" ]; then
  # Where nothing can be installed, or a package has the program elsewhere, some are still missing.
  [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null || ../scripts/install_missing.sh "${needs[@]}" || true
  still=$(missing)
  if [ "$still" ]; then
    echo "These files are missing, each of a package of Debian:" >&2
    sed 's/^/  /; s/=/ of /' <<<"$still" >&2
    exit 1
  fi
fi
[ -d bench/node_modules/three ] || npm install --silent --no-package-lock --prefix bench
./build.sh --older simd128

folder=target/engines
mkdir -p $folder
bench() {
  case $1 in
    node | chromium) node "bench/$1.mjs" ;;
    firefox | webkit) node bench/browser.mjs "$1" ;;
    jsc) jsc -m bench/jsc.mjs ;;
  esac
}
fail() {
  echo "$1" >&2
  exit 1
}
for engine; do
  echo "== $engine"
  case $engine in
    firefox | webkit)
      ENGINE=$engine node --test engines/page.test.mjs || fail "The page does not do in $engine what it should."
      ;;
  esac
  bench "$engine" | tee "$folder/$engine.txt" || fail "The bench has failed in $engine."
done
for engine; do
  bits=$(sed -n 's/^simd128 has the bits //p' "$folder/$engine.txt")
  [ "$bits" ] || fail "$engine has printed no bits."
  [ "$bits" = "${first:=$bits}" ] || fail "$engine has the bits $bits, and $1 has $first."
done
echo "All of $* have the bits $first."
