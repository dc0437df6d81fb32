#!/usr/bin/env bash
# Builds the Release preset: build.sh [TARGET...]. Quiet unless something fails.
set -euo pipefail
cd "$(dirname "$0")/.."

log=$(mktemp)
trap 'rm -f "$log"' EXIT
quietly() { "$@" >"$log" 2>&1 || { tail -n 60 "$log" >&2; echo "Failed: $*" >&2; exit 1; }; }

[ -f build/build.ninja ] || quietly cmake --preset release
if ninja -C build -n "$@" 2>/dev/null | grep -q "no work to do"; then exit 0; fi
echo "Building (Release) ..."
quietly cmake --build --preset release ${1:+--target "$@"}
