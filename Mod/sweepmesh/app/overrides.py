"""What is prescribed for single edges and vertices: as settings, as texts in an object's properties, and back.

    settings                                          property       text
    edge_count={"Edge5": 12}                          EdgeCounts     Edge5=12
    edge_size={"Edge5": 0.8}                          EdgeSizes      Edge5=0.8
    edge_bias={"Edge5": 1.2}                          EdgeBiases     Edge5=1.2
    edge_bias={"Edge5": (1.2, True)}                  EdgeBiases     Edge5=1.2 both
    vertex_types={("Face3", "Vertex7"): "corner"}     VertexTypes    Face3:Vertex7=corner
"""
from collections.abc import Mapping

from sweepmesh.app.shapes import edge_number, face_number, vertex_number
from sweepmesh.engine.errors import input_error

PROPERTIES = {
    "edge_count": "EdgeCounts",
    "edge_size": "EdgeSizes",
    "edge_bias": "EdgeBiases",
    "vertex_types": "VertexTypes",
}
_EXAMPLES = {"edge_count": (5, 12), "edge_size": (5, 0.8), "edge_bias": (5, (1.2, True)), "vertex_types": ((3, 7), "corner")}
_BOTH = "both"


def bias(value):
    """Return (ratio, grows from both ends) of a bias given so, or as the ratio alone; None for None."""
    if value is None:
        return None
    ratio, is_symmetric = value if isinstance(value, (tuple, list)) else (value, False)
    return float(ratio), bool(is_symmetric)


_VALUE = {"edge_count": int, "edge_size": float, "edge_bias": bias, "vertex_types": str}


def by_number(source, name, values):
    """Return {5: 12} for {"Edge5": 12}; `name` is that of the setting, keys are what edge_number and so on take.

    Vertex types may also be triples, [("Face3", "Vertex7", "corner")].
    """
    numbered = {_key_number(source, name, key): _VALUE[name](value) for key, value in _mapping(values).items()}
    return dict(sorted(numbered.items()))


def by_name(name, values):
    """Return {"Edge5": 12} for {5: 12}."""
    return {_key_name(key): value for key, value in values.items()}


def to_texts(values):
    """Return the texts for {5: 12} or {"Edge5": 12}, or for triples of vertex types."""
    return [f"{_key_text(key)}={_text(value)}" for key, value in _mapping(values).items()]


def from_texts(name, texts):
    """Return {5: 12} for ["Edge5=12"]; an InputError for a text that says nothing of the kind."""
    return dict(sorted(_from_text(name, text) for text in texts))


def _mapping(values):
    if isinstance(values, Mapping):
        return values
    return {(face, vertex): value for face, vertex, value in values or ()}


def _key_number(source, name, key):
    if name != "vertex_types":
        return edge_number(source, key)
    face, vertex = key
    return face_number(source, face), vertex_number(source, vertex)


def _key_name(key):
    if isinstance(key, tuple):
        face, vertex = key
        return (face, vertex) if isinstance(face, str) else (f"Face{face}", f"Vertex{vertex}")
    return key if isinstance(key, str) else f"Edge{key}"


def _key_text(key):
    name = _key_name(key)
    return name if isinstance(name, str) else ":".join(name)


def _text(value):
    if isinstance(value, str):
        return value
    ratio, is_symmetric = value if isinstance(value, (tuple, list)) else (value, False)
    return f"{ratio!r} {_BOTH}" if is_symmetric else repr(ratio)


def _from_text(name, text):
    key, _, value = (part.strip() for part in text.partition("="))
    try:
        return _key(name, key), _value(name, value)
    except ValueError:
        example = to_texts(dict([_EXAMPLES[name]]))[0]
        raise input_error(f"'{text}' in {PROPERTIES[name]} cannot be understood: {example} would be right.") from None


def _key(name, text):
    if name != "vertex_types":
        return _number("Edge", text)
    face, _, vertex = text.partition(":")
    return _number("Face", face.strip()), _number("Vertex", vertex.strip())


def _number(kind, name):
    if not name.startswith(kind) or int(name[len(kind) :]) < 1:
        raise ValueError(name)
    return int(name[len(kind) :])


def _value(name, text):
    if name == "vertex_types" and not text:
        raise ValueError(text)
    if name != "edge_bias":
        return _VALUE[name](text)
    ratio, _, ends = text.partition(" ")
    if ends.strip() not in ("", _BOTH):
        raise ValueError(ends)
    return float(ratio), bool(ends)
