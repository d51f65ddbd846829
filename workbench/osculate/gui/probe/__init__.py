"""The task panel of a Probe, and the mouse that moves it."""
