#!/usr/bin/env bash
# Everything that is proved, from the tapes of today's code: run.sh, from anywhere. For Debian; installs what is missing.
# Of CPU: half a minute for Gappa, 5 minutes for Coq to check its proofs, 5 for its own theorems.
set -euo pipefail
cd "$(dirname "$0")"

../scripts/install_missing.sh /usr/bin/gappa=gappa /usr/bin/sollya=sollya /usr/bin/coqc=coq \
  /usr/lib/ocaml/coq/user-contrib/Flocq=libcoq-flocq /usr/lib/ocaml/coq/user-contrib/Gappa=libcoq-gappa
for tool in gappa sollya coqc; do
  command -v "$tool" >/dev/null || { echo "missing: $tool (a package of Debian)" >&2; exit 1; }
done

out=$PWD/target/proved
rm -rf "$out"
mkdir -p "$out/gappa" "$out/coq"

echo '=== tapes: bit by bit the code'
DQ8_PROOFS_INPUTS=100000 cargo test

echo '=== Sollya: polynomials'
./sollya.py

prove() {
  coqc -noglob "$1" >"${1%.v}.log" || { echo "$1: not proved" >&2; return 1; }
  # Nothing is assumed but what the real numbers of Coq are made of.
  if grep -E '^[A-Za-z_.0-9]+( :|$)' "${1%.v}.log" \
    | grep -vE '^(ClassicalDedekindReals\.sig_|FunctionalExtensionality\.|Classical_Prop\.classic|Axioms)'; then
    echo "$1: another axiom" >&2
    return 1
  fi
}
# Gappa's proofs of some lemmas as one file for Coq, each a module. What they take for granted of real numbers, Gappa's
# rewriting rules, is proved; of `all` Coq says the axioms.
certify() {
  local script name names=
  exec >"steps_from_$(basename "${1%.g}").v"
  echo 'From Coq Require Import Reals. Require Import Gappa.Gappa_library.'
  for script; do
    name="M$(basename "${script%.g}")"
    names+=", $name.l1"
    echo "Module $name."
    gappa -Bcoq "$script" 2>"$script.log" \
      | sed -E 's/^Hypothesis (a[0-9]+ : .*)\.$/Lemma \1. Proof. first [ring | intros; field; auto]. Qed./; /^(Require|Proof)/d' \
      || { cat "$script" "$script.log" >&2; return 1; }
    echo "End $name."
  done
  echo "Definition all := (${names#, }). Print Assumptions all."
  # What is still supposed would be a premise of a lemma, not an axiom. (Variables are the numbers that lemmas are about.)
  if grep -qE '^(Hypothesis|Axiom|Parameter|Conjecture)' "steps_from_$(basename "${1%.g}").v"; then
    echo "$1: something is supposed" >&2
    return 1
  fi
}
export -f prove certify

echo '=== Gappa: every step to a number in a range'
cargo run --quiet -- gappa "$out/gappa"
cargo run --quiet -- coq "$out/coq"
cp coq/*.v "$out/coq"
mkdir "$out/certified"
cd "$out/certified"
time find "$out/gappa" -name '*.g' | sort -V \
  | xargs -P "$(nproc)" -n 60 bash -c 'set -euo pipefail; certify "$@"' certify

echo '=== Coq: what Gappa proved'
time find . -name '*.v' -printf '%f\n' | xargs -P "$(nproc)" -I{} bash -c 'prove {}'
grep -c '^Module' ./*.v | awk -F: '{ sum += $2 } END { print sum " steps" }'

echo '=== Coq: bounds in lengths, and the chain'
cd "$out/coq"
coqc rounding.v
time find . -name '*.v' ! -name rounding.v -printf '%f\n' | xargs -P "$(nproc)" -I{} bash -c 'prove {}'
grep -c '^Theorem' ./*.v | awk -F: '{ sum += $2 } END { print sum " theorems" }'
