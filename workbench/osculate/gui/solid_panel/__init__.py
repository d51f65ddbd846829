"""The task panels of Bézier solids."""
