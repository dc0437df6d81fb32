"""What is drawn over an object in the 3D view, read from its scene graph."""
from math import dist

from pivy import coin


def nodes(obj, kind):
    """All nodes of a kind below an object's root."""
    search = coin.SoSearchAction()
    search.setType(kind.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(obj.ViewObject.RootNode)
    paths = search.getPaths()
    return [paths[i].getTail() for i in range(paths.getLength())]


def letters(obj):
    """The texts that are drawn, sorted."""
    return sorted(node.string[0].getString().strip() for node in nodes(obj, coin.SoText2))


def tick_points(obj):
    """The points of all ticks that are drawn."""
    points = []
    for group in nodes(obj, coin.SoSeparator):
        children = [group.getChild(i) for i in range(group.getNumChildren())]
        if any(isinstance(child, coin.SoPointSet) for child in children):
            for child in children:
                if isinstance(child, coin.SoCoordinate3):
                    points.extend(tuple(point.getValue()) for point in child.point.getValues())
    return points


def _groups(obj, kind):
    """The children of every separator that has a node of a kind among them, where it is drawn."""
    for group in nodes(obj, coin.SoSeparator):
        children = [group.getChild(i) for i in range(group.getNumChildren())]
        if any(child.getTypeId() == kind.getClassTypeId() for child in children):
            yield children


def face_colours(obj):
    """The colours of the faces that are drawn over those of the object, sorted."""
    colours = []
    hidden = {id_of(switch.getChild(0)) for switch in nodes(obj, coin.SoSwitch) if switch.whichChild.getValue() == -1}
    for group in nodes(obj, coin.SoSeparator):
        children = [group.getChild(i) for i in range(group.getNumChildren())]
        kinds = [child.getTypeId() for child in children]
        if id_of(group) in hidden or coin.SoIndexedFaceSet.getClassTypeId() not in kinds:
            continue
        materials = [child for child in children if child.getTypeId() == coin.SoMaterial.getClassTypeId()]
        colours.extend(tuple(round(part, 3) for part in m.diffuseColor[0].getValue()) for m in materials)
    return sorted(colours)


def id_of(node):
    """A number that two Python objects for one node of the scene have in common."""
    return int(node.this)


def line_lengths(obj):
    """The lengths of the lines that are drawn as sets of polylines, rounded, sorted."""
    lengths = []
    for children in _groups(obj, coin.SoLineSet):
        coordinates = next(c for c in children if c.getTypeId() == coin.SoCoordinate3.getClassTypeId())
        lines = next(c for c in children if c.getTypeId() == coin.SoLineSet.getClassTypeId())
        points, start = [p.getValue() for p in coordinates.point.getValues()], 0
        for count in lines.numVertices.getValues():
            one = points[start : start + count]
            lengths.append(round(sum(dist(a, b) for a, b in zip(one, one[1:])), 3))
            start += count
    return sorted(lengths)
