#!/usr/bin/env bash
# Opens FreeCAD with the workbench, and with SHAPE where one is given: gui.sh [SHAPE]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
fail() { echo "sweepmesh: $1" >&2; exit 1; }
[ $# -eq 0 ] || [ -f "$1" ] || fail "There is no file $1."
[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || fail "There is no display to open FreeCAD on."

"$root/scripts/translations.sh"
mods="${FREECAD_USER_HOME:-${XDG_DATA_HOME:-$HOME/.local/share}/FreeCAD}/Mod"
if [ "$(readlink -f "$mods/SweepMesh")" != "$root" ]; then
  mkdir -p "$mods"
  ln -sfn "$root" "$mods/SweepMesh"
  echo "Linked $root as $mods/SweepMesh."
fi
# The browser of FreeCAD's start page refuses to run as root unless it is told so.
[ "$(id -u)" -ne 0 ] || export QTWEBENGINE_DISABLE_SANDBOX=1
exec freecad "$@" "$root/scripts/activate_workbench.py"
