#!/usr/bin/env bash
# Installs what is missing of scripts/packages.txt: install_packages.sh run [test]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

wanted=()
while read -r package use; do
  case "$package" in "" | "#"*) continue ;; esac
  for group in "$@"; do [ "$use" = "$group" ] && wanted+=("$package"); done
done <"$here/packages.txt"

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
sudo=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Run this as root, or install: ${missing[*]}" >&2; exit 1; }
  sudo=(sudo)
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
install() {
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q update &&
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get -q install -y --no-install-recommends "${missing[@]}"
}
install >"$log" 2>&1 || { tail -n 30 "$log" >&2; echo "apt-get failed." >&2; exit 1; }
