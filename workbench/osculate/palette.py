"""Colours with a meaning, the same in icons, panels, plots, pages and the 3D view."""

#: Of combs and plots: told apart by the colour-blind (after Okabe and Ito), and on light and dark.
QUANTITIES = {"curvature": "#1c86d1", "torsion": "#d55e00", "curvature_rate": "#009e73",
              "curvature_rate2": "#b8689a", "torsion_rate": "#c98a00"}

#: Of the order of continuity; every order from 4 on has the last.
ORDERS = ("#e8590c", "#b98900", "#3f8f29", "#0f8a8a", "#2468d8")
GAP = "#d6293e"
UNDECIDED = "#8250c4"

#: The two sides of a join: arriving and leaving.
SIDES = ("#e8860c", "#a24bd8")


def of_order(order):
    """The colour of an order of continuity, -1 for a gap."""
    return GAP if order < 0 else ORDERS[min(order, len(ORDERS) - 1)]
