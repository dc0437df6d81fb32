"""The demonstration: from an example part to a solved analysis and a picture."""
