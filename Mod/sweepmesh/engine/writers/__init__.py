"""File formats that need nothing but numpy."""
