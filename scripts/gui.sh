#!/usr/bin/env bash
# Opens FreeCAD with the workbench, and with SHAPE where one is given.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
if [ $# -gt 0 ] && [ ! -f "$1" ]; then echo "sweepmesh: There is no file $1." >&2; exit 1; fi
if [ -z "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then echo "sweepmesh: There is no display to open FreeCAD on." >&2; exit 1; fi

mods="${FREECAD_USER_HOME:-$HOME/.local/share/FreeCAD}/Mod"
if [ ! -e "$mods/SweepMesh" ]; then
  mkdir -p "$mods"
  ln -sfn "$root" "$mods/SweepMesh"
  echo "Linked $root into $mods."
fi
exec freecad "$@"
