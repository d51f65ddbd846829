"""The dock Curve plot: what a curve has over its arc length, linked to the 3D view."""
