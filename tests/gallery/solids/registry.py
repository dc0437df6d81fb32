"""The list of solids, and how faces and sweep schemes are named in it."""

import math

import Part
from solids.kit import Z_UP, rounded, vec


def interior_point(face):
    """A repeatable point of the face that is far from its edges."""
    points, triangles = face.tessellate(face.BoundBox.DiagonalLength / 200.0)
    centroids = [(points[a] + points[b] + points[c]) * (1 / 3.0) for a, b, c in triangles]
    areas = [(points[b] - points[a]).cross(points[c] - points[a]).Length
             for a, b, c in triangles]
    order = sorted(range(len(triangles)), key=lambda k: -areas[k])[:60]
    rim = Part.Compound([e for e in face.Edges if not e.Degenerated])
    best, best_distance = None, -1.0
    for candidate in [face.CenterOfMass] + [centroids[k] for k in order]:
        u, v = face.Surface.parameter(candidate)
        if not face.isPartOfDomain(u, v):
            continue
        point = face.valueAt(u, v)
        distance = Part.Vertex(point).distToShape(rim)[0]
        if distance > best_distance + 1e-6:
            best, best_distance = point, distance
    return best


def outward_normal(face, point):
    u, v = face.Surface.parameter(point)
    return face.normalAt(u, v)


def face_at(shape, point):
    """The face of the shape nearest to a point."""
    vertex = Part.Vertex(point)
    return min(shape.Faces, key=lambda f: vertex.distToShape(f)[0])


def caps(shape, axis):
    """Planar faces whose outward normal is exactly `axis`."""
    found = []
    for face in shape.Faces:
        if face.Surface.TypeId != "Part::GeomPlane":
            continue
        if outward_normal(face, face.CenterOfMass).getAngle(axis) < 1e-6:
            found.append(face)
    return found


def cylinder_faces(shape, *radii):
    """Cylindrical faces of the given radii."""
    return [f for f in shape.Faces if f.Surface.TypeId == "Part::GeomCylinder"
            and round(f.Surface.Radius, 6) in radii]


def scheme(sources, targets, **extra):
    """A sweep scheme: lists of source and target faces."""
    return dict(sources=list(sources), targets=list(targets), **extra)


def axial(shape, axis=Z_UP, **extra):
    """Sweep along an axis: planar caps facing +axis are sources, -axis targets."""
    return scheme(caps(shape, axis), caps(shape, axis * -1), **extra)


SOLIDS = []


def solid(figure, kind, genus, reason, unsweepable=False, hexes=2500, size=None, note=""):
    """
    Register a builder.

    genus: expected genus of each boundary shell (the check that holes go
    through).  hexes: the count that the suggested element size aims at, unless
    `size` gives that element size itself.
    """
    def register(build):
        SOLIDS.append(dict(name=build.__name__, build=build, figure=figure, kind=kind,
                           genus=sorted(genus), reason=reason, unsweepable=unsweepable,
                           hexes=hexes, size=size, note=note,
                           about=" ".join(build.__doc__.split())))
        return build
    return register


TYPES = {"END": 1, "SIDE": 0, "CORNER": -1, "REVERSAL": -2}


def interior_angle(face, vertex):
    """Angle in degrees that a planar face spans at one of its vertices."""
    rays = []
    for edge in face.Edges:
        for parameter, sign in ((edge.FirstParameter, 1), (edge.LastParameter, -1)):
            if edge.valueAt(parameter).distanceToPoint(vertex) < 1e-6:
                rays.append(edge.tangentAt(parameter) * sign)
    first, second = rays
    angle = math.degrees(first.getAngle(second))
    if angle > 179.99:
        return 180.0
    probe = vertex + (first + second).normalize() * 1e-3
    u, v = face.Surface.parameter(probe)
    return angle if face.isPartOfDomain(u, v) else 360.0 - angle


def submapped(shape, height, expected=None, virtual=(), alternatives=()):
    """
    Result of a plate: the plain sweep plus the record of its top face.

    expected: vertex types that differ from the type read off the angle, keyed
    by (x, y).  virtual: ((x, y), type) added on rounds by the templates.
    """
    top = caps(shape, Z_UP)[0]
    vertices, total, by_angle = [], 0, 0
    for vertex in top.Vertexes:
        p = vertex.Point
        angle = interior_angle(top, p)
        value = max(-2, min(1, int(math.floor(2 * (1 - angle / 180.0) + 0.5))))
        guess = next(name for name, number in TYPES.items() if number == value)
        wanted = guess
        for (x, y), name in (expected or {}).items():
            if p.distanceToPoint(vec(x, y, height)) < 1e-3:
                wanted = name
        total += TYPES[wanted]
        by_angle += TYPES[guess]
        vertices.append(dict(point=rounded(p), angle=round(angle, 2), by_angle=guess,
                             expected=wanted))
    added = [dict(point=rounded((x, y, height)), expected=name) for (x, y), name in virtual]
    total += sum(TYPES[item["expected"]] for item in added)
    holes = len(top.Wires) - 1
    if total != 4 - 4 * holes:
        raise ValueError("vertex types add up to %d" % total)
    record = dict(face=rounded(interior_point(top)), holes=holes, sum_required=4 - 4 * holes,
                  sum_by_angle=by_angle, vertices=vertices, virtual_vertices=added,
                  alternatives=list(alternatives))
    return shape, [axial(shape)], dict(submap=record)
