#!/usr/bin/env bash
# Everything that is proved, from the tapes of today's code: run.sh, from anywhere. For Debian; installs what is missing.
# Of CPU: half a minute for Gappa, 11 minutes for Coq.
set -euo pipefail
cd "$(dirname "$0")"

../scripts/install_missing.sh /usr/bin/gappa=gappa /usr/bin/sollya=sollya /usr/bin/coqc=coq \
  /usr/lib/ocaml/coq/user-contrib/Flocq=libcoq-flocq /usr/lib/ocaml/coq/user-contrib/Gappa=libcoq-gappa
for tool in gappa sollya coqc; do
  command -v "$tool" >/dev/null || { echo "missing: $tool (a package of Debian)" >&2; exit 1; }
done

out=target/proved
rm -rf "$out"
mkdir -p "$out/gappa" "$out/coq"

echo '=== tapes: bit by bit the code'
DQ8_PROOFS_INPUTS=100000 cargo test

echo '=== Gappa: every step to a number in a range'
cargo run --quiet -- gappa "$out/gappa"
time find "$out/gappa" -name '*.g' | xargs -P "$(nproc)" -I{} \
  bash -c 'gappa {} >{}.log 2>&1 || { cat {} {}.log >&2; exit 1; }'

echo '=== Sollya: polynomials'
./sollya.py

echo '=== Coq: bounds in lengths, and the chain'
cargo run --quiet -- coq "$out/coq"
cp coq/*.v "$out/coq"
cd "$out/coq"
coqc rounding.v
prove() {
  coqc "$1" >"${1%.v}.log" || { echo "$1: not proved" >&2; return 1; }
  # Nothing is assumed but what the real numbers of Coq are made of.
  if grep -E '^[A-Za-z_.]+( :|$)' "${1%.v}.log" \
    | grep -vE '^(ClassicalDedekindReals\.sig_|FunctionalExtensionality\.|Classical_Prop\.classic|Axioms)'; then
    echo "$1: another axiom" >&2
    return 1
  fi
}
export -f prove
time find . -name '*.v' ! -name rounding.v -printf '%f\n' | xargs -P "$(nproc)" -I{} bash -c 'prove {}'
grep -c '^Theorem' ./*.v | awk -F: '{ sum += $2 } END { print sum " theorems" }'
