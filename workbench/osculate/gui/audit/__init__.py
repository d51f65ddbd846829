"""The task panel of an Audit."""
