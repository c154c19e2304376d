#!/usr/bin/env bash
# Installs from Debian what is missing: install_missing.sh PATH=PACKAGE…, a path that must exist and the package that has it.
set -euo pipefail

# One at a time: what runs beside this may want packages too.
exec 9<"$0"
flock 9

packages=()
for need; do
  [ -e "${need%%=*}" ] || packages+=("${need##*=}")
done
if [ ${#packages[@]} -gt 0 ]; then
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
fi
