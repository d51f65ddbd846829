"""Bézier solids and their contact in the 3D view."""
