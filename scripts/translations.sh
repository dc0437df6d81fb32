#!/usr/bin/env bash
# Makes the files that FreeCAD loads of the translations that are newer, where Qt's lrelease is installed.
set -euo pipefail
cd "$(dirname "$0")/../Resources/translations"
lrelease=$(command -v lrelease || echo /usr/lib/qt5/bin/lrelease)
[ -x "$lrelease" ] || exit 0
for source in SweepMesh_*.ts; do
  if [ "$source" -nt "${source%.ts}.qm" ]; then "$lrelease" -silent "$source" -qm "${source%.ts}.qm"; fi
done
