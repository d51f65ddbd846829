"""The task panel of Analyze join: a session that analyses, and small widgets that show it."""
