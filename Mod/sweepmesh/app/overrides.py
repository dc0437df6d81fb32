"""What is prescribed for single edges of a solid: as settings, as texts in an object's properties, and back.

    settings                                    property      text
    edge_count={"Edge5": 12}                    EdgeCounts    Edge5=12
    edge_size={"Edge5": 0.8}                    EdgeSizes     Edge5=0.8
    edge_bias={"Edge5": 1.2}                    EdgeBiases    Edge5=1.2
    edge_bias={"Edge5": (1.2, True)}            EdgeBiases    Edge5=1.2 both
"""
from sweepmesh.app.shapes import edge_number
from sweepmesh.engine.errors import input_error

PROPERTIES = {"edge_count": "EdgeCounts", "edge_size": "EdgeSizes", "edge_bias": "EdgeBiases"}
_BOTH = "both"


def bias(value):
    """Return (ratio, grows from both ends) of a bias given so, or as the ratio alone; None for None."""
    if value is None:
        return None
    ratio, is_symmetric = value if isinstance(value, (tuple, list)) else (value, False)
    return float(ratio), bool(is_symmetric)


_VALUE = {"edge_count": int, "edge_size": float, "edge_bias": bias}


def by_number(source, name, values):
    """Return {5: 12} for {"Edge5": 12}; `name` is that of the setting, edges are what edge_number takes."""
    numbered = {edge_number(source, edge): _VALUE[name](value) for edge, value in (values or {}).items()}
    return dict(sorted(numbered.items()))


def to_texts(values):
    """Return the texts for {5: 12} or {"Edge5": 12}."""
    return [f"{_edge(edge)}={_text(value)}" for edge, value in values.items()]


def from_texts(name, texts):
    """Return {5: 12} for ["Edge5=12"]; an InputError for a text that says nothing of the kind."""
    return dict(sorted(_from_text(name, text) for text in texts))


def _edge(edge):
    return edge if isinstance(edge, str) else f"Edge{edge}"


def _text(value):
    ratio, is_symmetric = value if isinstance(value, (tuple, list)) else (value, False)
    return f"{ratio!r} {_BOTH}" if is_symmetric else repr(ratio)


def _from_text(name, text):
    edge, _, value = (part.strip() for part in text.partition("="))
    try:
        if not edge.startswith("Edge") or int(edge[4:]) < 1:
            raise ValueError(edge)
        return int(edge[4:]), _value(name, value)
    except ValueError:
        example = to_texts({5: (1.2, True) if name == "edge_bias" else 12})[0]
        raise input_error(f"'{text}' in {PROPERTIES[name]} says nothing of an edge: {example} would.") from None


def _value(name, text):
    if name != "edge_bias":
        return _VALUE[name](text)
    ratio, _, ends = text.partition(" ")
    if ends.strip() not in ("", _BOTH):
        raise ValueError(ends)
    return float(ratio), bool(ends)
