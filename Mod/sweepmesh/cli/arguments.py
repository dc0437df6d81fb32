"""The options of the command line."""

import argparse
import sys

from sweepmesh.engine import Options, __version__
from sweepmesh.output import FORMATS

_FACE_OPTIONS = ("--source", "--target", "--pair", "--type")

_EPILOG = """exit status: 0 meshed (or, with --assess, sweepable), 2 not sweepable, 1 anything else.

example: python -m sweepmesh bracket.step --size 2.5 --source Face3 --out bracket.vtu --out bracket.inp
"""


class Parser(argparse.ArgumentParser):
    """Ends with status 1 on wrong usage, as 2 means that a solid cannot be swept."""

    def parse_args(self, args=None, namespace=None):
        return super().parse_args(_joined_points(sys.argv[1:] if args is None else args), namespace)

    def error(self, message):
        self.exit(1, f"sweepmesh: {message}. See --help.\n")


def _joined_points(arguments):
    """Writes `--source -1,2,3` as `--source=-1,2,3`: argparse would take the point for an option."""
    joined = []
    for argument in arguments:
        if joined and joined[-1] in _FACE_OPTIONS and argument[:1] == "-" and "," in argument:
            joined[-1] += "=" + argument
        else:
            joined.append(argument)
    return joined


def make_parser():
    """The parser of the whole command line."""
    defaults = Options()
    parser = Parser(
        prog="sweepmesh",
        description="Meshes a CAD solid with swept hexahedra.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("shape", metavar="SHAPE", help="a .step, .stp, .iges, .igs, .brep or .FCStd file")
    add("--object", metavar="NAME", help="the object of an .FCStd file (default: its first solid)")
    add("--solid", type=int, metavar="N", help="mesh this solid of a shape of several (default: all)")
    add("--version", action="version", version=f"SweepMesh {__version__}")

    sweep = parser.add_argument_group("sweep", "FACE is a name (Face7) or a point on the face (x,y,z)")
    add = sweep.add_argument
    add("--source", action="append", default=[], metavar="FACE", help="a source face; repeatable")
    add("--target", action="append", default=[], metavar="FACE", help="a target face; repeatable")
    add(
        "--pair",
        action="append",
        default=[],
        metavar="SOURCE=TARGET",
        help="this source is to be swept to this target; repeatable",
    )
    add(
        "--type",
        action="append",
        default=[],
        metavar="FACE:VERTEX=TYPE",
        help="END, SIDE, CORNER or REVERSAL at this vertex (Vertex7 or a point) of this linking face; repeatable",
    )
    add("--size", type=float, metavar="S", help="edge length of the elements (default: from the volume)")
    add("--layers", type=int, metavar="N", help="number of layers (default: from the size)")
    add("--element", choices=["hex", "prism", "polyhedron"], default=defaults.element)
    add("--order", type=int, choices=[1, 2], default=defaults.order, help="1 linear, 2 quadratic")
    add("--threads", type=int, default=defaults.threads, metavar="N", help="default: all")
    add("--force", action="store_true", help="lift the limit on the number of elements")

    out = parser.add_argument_group("output")
    add = out.add_argument
    add(
        "--out",
        action="append",
        default=[],
        metavar="FILE",
        help=f"write the mesh, format by suffix ({' '.join(FORMATS)}); repeatable",
    )
    add("--report", metavar="FILE", help="write verdict, counts, quality and times as JSON")
    add("--assess", action="store_true", help="only say whether the solid can be swept")
    add(
        "--cut",
        metavar="FILE",
        help="cut a solid that cannot be swept along a plane that is found, write the pieces to FILE (.brep) and mesh these",
    )
    add("--quiet", action="store_true", help="print nothing but errors")
    return parser
