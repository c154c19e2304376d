#!/usr/bin/env bash
# Runs the bench in three engines, each against flat JavaScript in the same run: V8 (node, chromium), SpiderMonkey
# (firefox) and JavaScriptCore (jsc; webkit, GTK's browser): `web/engines.sh [NAME…]`, all by default. Answers
# are compared with those of peers, and all engines must have the same bits. In firefox and webkit the page is driven
# first, as `web/test.sh` drives it in chromium; pictures are left in `web/target/engines`. The level is simd128.
set -euo pipefail
cd "$(dirname "$0")"

[ $# -gt 0 ] || set -- node chromium firefox jsc webkit
needs=(/usr/bin/node=nodejs)
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
missing=()
for need in "${needs[@]}"; do [ -e "${need%%=*}" ] || missing+=("${need##*=}"); done
if [ ${#missing[@]} -gt 0 ] && { [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null; }; then
  echo "These packages of Debian are missing: ${missing[*]}" >&2
  exit 1
fi
../scripts/install_missing.sh "${needs[@]}"
[ -d bench/node_modules/three ] || npm install --silent --no-package-lock --prefix bench
./build.sh --older simd128

folder=target/engines
mkdir -p $folder
for engine; do
  echo "== $engine"
  case $engine in firefox | webkit) ENGINE=$engine node --test engines/page.test.mjs ;; esac
  case $engine in
    node | chromium) node "bench/$engine.mjs" ;;
    firefox | webkit) node bench/browser.mjs "$engine" ;;
    jsc) jsc -m bench/jsc.mjs ;;
  esac | tee "$folder/$engine.txt"
done
for engine; do
  bits=$(sed -n 's/^simd128 has the bits //p' "$folder/$engine.txt")
  if [ "$bits" != "${first:=$bits}" ] || [ -z "$bits" ]; then
    echo "$engine has the bits $bits, and $1 has $first" >&2
    exit 1
  fi
done
echo "All of $* have the bits $first."
