"""The panels in which curves are constructed: what they have in common, and one file for each."""
