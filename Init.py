"""FreeCAD runs this file at every start: it puts the workbench's Python packages on the path."""
import os
import sys

# There is no __file__ here. FreeCAD has put this addon's folder on sys.path before.
for folder in list(sys.path):
    packages = os.path.join(folder, "Mod")
    if os.path.isdir(os.path.join(packages, "sweepmesh", "gui")):
        if packages not in sys.path:
            sys.path.append(packages)
        break
