"""The task panel of ControlPolygons."""
