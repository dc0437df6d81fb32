"""The command line, a thin layer over engine (and over app for FreeCAD's documents)."""
