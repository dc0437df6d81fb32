"""What is drawn over an object in the 3D view, read from its scene graph."""
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
    """The points of all markers that are drawn."""
    points = []
    for group in nodes(obj, coin.SoSeparator):
        children = [group.getChild(i) for i in range(group.getNumChildren())]
        if any(isinstance(child, coin.SoMarkerSet) for child in children):
            for child in children:
                if isinstance(child, coin.SoCoordinate3):
                    points.extend(tuple(point.getValue()) for point in child.point.getValues())
    return points
