"""The task panel of Analyze join: the analysis, and small widgets that show it."""
