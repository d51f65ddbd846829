#!/usr/bin/env python3
"""Writes the icons of Osculate as SVG beside this file: one family, drawn with strokes only.

    python3 resources/icons/make_icons.py

Verdict tiles carry white strokes on a colour per order; the others are mid-tone strokes that read
on light and on dark backgrounds. The colours of the verdicts and sides are those of
workbench/osculate/gui/colors.py.
"""

from pathlib import Path

FOLDER = Path(__file__).resolve().parent

FIRST, SECOND, NEUTRAL = "#e8860c", "#a24bd8", "#7c8794"
COMB, POLYGON = "#1c86d1", "#c98a00"
GOOD, UNDECIDED = "#2f9e44", "#8250c4"
ORDER_COLORS = ["#e8590c", "#b98900", "#3f8f29", "#0f8a8a"] + 5 * ["#2468d8"]
GAP, ERROR = "#d6293e", "#6b7280"

LETTER_G = "M20.8 16.2 A8.3 11.5 0 1 0 21.8 31 V26 H16.5"
DIGITS = [
    "M35 12.5 A6.3 11.5 0 1 0 35 35.5 A6.3 11.5 0 1 0 35 12.5 Z",
    "M29.5 18 L36 12.5 V35.5",
    "M29 18.5 C29 10.5 41 10.5 41 18.5 C41 24 33 29 29 35.5 H41.5",
    "M29 12.5 H40.5 L34 21.5 C43.5 21.5 43.5 35.5 35 35.5 C32 35.5 30 34 28.8 31.5",
    "M38 35.5 V12.5 L28.3 29 H42.5",
    "M40.5 12.5 H31 L30 22 C36 19 41.8 22 41.8 28 C41.8 35.5 33 38 28.5 33",
    "M38.5 12.5 C31 16 29 22 29 29 A6.3 6.3 0 1 0 41.6 29 A6.3 6.3 0 1 0 29 29",
    "M28.8 12.5 H41.5 L33 35.5",
    "M35 12.5 A5 5 0 1 0 35 22.5 A5 5 0 1 0 35 12.5 Z M35 22.5 A6.5 6.5 0 1 0 35 35.5"
    " A6.5 6.5 0 1 0 35 22.5 Z",
]
QUESTION = "M17.5 18.5 C17.5 8.5 31 9 31 18 C31 24 24.3 24 24.3 29.5"
ARRIVING = "M4 41 C12 41 18 35 24 24"
LEAVING = "M24 24 C30 13 36 7 44 7"


def stroke(path, color, width, extra=""):
    return (f'<path d="{path}" fill="none" stroke="{color}" stroke-width="{width}"'
            f' stroke-linecap="round" stroke-linejoin="round"{extra}/>')


def dot(x, y, radius, fill, ring=None, width=0):
    outline = f' stroke="{ring}" stroke-width="{width}"' if ring else ""
    return f'<circle cx="{x}" cy="{y}" r="{radius}" fill="{fill}"{outline}/>'


def tile(color, *marks):
    return (f'<rect x="1" y="5" width="46" height="38" rx="8" fill="{color}"/>', *marks)


def with_undecided_badge(marks):
    return ('<g transform="translate(0 -4)">', *marks, "</g>",
            dot(38, 38.5, 8.5, UNDECIDED, "#ffffff", 2),
            stroke("M35.6 36.6 C35.6 32.8 40.6 32.8 40.6 36.2 C40.6 38.4 38.2 38.4 38.2 40.2",
                   "#ffffff", 2.2),
            dot(38.2, 43.2, 1.4, "#ffffff"))


def order_tile(order):
    return tile(ORDER_COLORS[order], stroke(LETTER_G, "#ffffff", 4.6),
                stroke(DIGITS[order], "#ffffff", 4.6))


def verdict_icons():
    icons = {}
    for order in range(len(DIGITS)):
        icons[f"verdict-g{order}"] = order_tile(order)
        icons[f"verdict-g{order}-undecided"] = with_undecided_badge(order_tile(order))
    icons["verdict-gap"] = tile(GAP, stroke("M6 32 C12 32 16 30 19 26.5", "#ffffff", 4.6),
                                stroke("M29 21.5 C32 18 36 16 42 16", "#ffffff", 4.6))
    icons["verdict-undecided"] = tile(UNDECIDED, stroke(QUESTION, "#ffffff", 4.6),
                                      dot(24.3, 36.6, 2.8, "#ffffff"))
    icons["verdict-error"] = tile(ERROR, stroke("M24 12.5 V26", "#ffffff", 5.2),
                                  dot(24, 35, 3, "#ffffff"))
    return icons


def curves(*marks):
    return (stroke(ARRIVING, FIRST, 4.6), stroke(LEAVING, SECOND, 4.6), *marks)


NODE = ("#ffffff", "#3a4653", 2.4)


def node():
    return dot(24, 24, 5, "#ffffff", "#3a4653", 2.6)


def construction(*marks):
    """Two given curves, and what is made between them."""
    return (stroke("M3 36 C7 39 12 40 17 40", FIRST, 4.6),
            stroke("M31 8 C36 8 41 9 45 12", SECOND, 4.6), *marks)


def command_icons():
    lens = (dot(33, 33, 8.5, "#ffffff", "#3a4653", 3.4), stroke("M39.4 39.4 L45 45", NEUTRAL, 5),
            stroke("M29 33.4 L32 36.4 L37.2 30", GOOD, 3))
    pin = ('<path d="M18 4 H32 L30 16 L37 24 H13 L20 16 Z" fill="#e8860c"/>',
           stroke("M25 24 V44", NEUTRAL, 4))
    workbench = curves('<circle cx="33.5" cy="29" r="10.8" fill="none" stroke="#7c8794"'
                       ' stroke-width="2.4" stroke-dasharray="4 3.4"/>', node())
    return {
        "osculate": workbench,
        "preferences-osculate": workbench,  # by this name FreeCAD finds that of the preferences
        "analyze-join": curves(node(), *lens),
        "blend": construction(stroke("M17 40 C33 40 15 8 31 8", GOOD, 4.6), dot(17, 40, 4, *NODE),
                              dot(31, 8, 4, *NODE)),
        "join": (stroke("M4 40 C12 42 18 36 20 28", FIRST, 4.6),
                 stroke("M20 28 C22 20 26 16 32 17", GOOD, 4.6),
                 stroke("M32 17 C38 18 41 14 44 7", SECOND, 4.6), dot(20, 28, 4, *NODE),
                 dot(32, 17, 4, *NODE)),
        "interpolate": (stroke("M6 36 C10 10 20 8 24 24 C28 40 38 38 42 12", GOOD, 4.6),
                        dot(6, 36, 4, *NODE), dot(24, 24, 4, *NODE), dot(42, 12, 4, *NODE)),
        "extend": (stroke("M4 40 C10 42 17 38 21 31", FIRST, 4.6),
                   stroke("M21 31 C25 23 28 13 40 9", GOOD, 4.6),
                   stroke("M32.5 6.5 L41.5 8.6 L37 16.5", GOOD, 4.2), dot(21, 31, 4, *NODE)),
        "match": (stroke("M3 38 C9 42 17 40 21 33", FIRST, 4.6),
                  stroke("M25 42 C29 32 34 14 45 9", SECOND, 3.4, ' stroke-dasharray="1 6.2"'),
                  stroke("M21 33 C26 23 33 13 45 9", GOOD, 4.6), dot(21, 33, 4, *NODE)),
        "curvature-comb": (stroke("M5 43 C14 25 34 25 43 43", NEUTRAL, 4.6),
                           *(stroke(f"M{x} {y} L{end} {tip}", COMB, 2.6)
                             for x, y, end, tip in ((11.5, 34, 8, 18), (17.5, 30, 15, 9),
                                                    (24, 29, 24, 6), (30.5, 30, 33, 9),
                                                    (36.5, 34, 40, 18))),
                           stroke("M2.5 36 C5 14 14 6 24 6 C34 6 43 14 45.5 36", COMB, 3.4)),
        "control-polygons": (
            stroke("M6 41 C8 -4 40 -4 42 41", NEUTRAL, 4.6),
            stroke("M6 41 L8 7 L40 7 L42 41", POLYGON, 3),
            dot(8, 7, 4, POLYGON, "#ffffff", 1.6), dot(40, 7, 4, POLYGON, "#ffffff", 1.6),
            *(f'<rect x="{x}" y="36" width="9" height="9" fill="{COMB}" stroke="#ffffff"'
              ' stroke-width="1.6"/>' for x in (2, 37))),
        "probe": (
            f'<circle cx="24" cy="17" r="13" fill="none" stroke="{POLYGON}" stroke-width="2.8"/>',
            stroke("M3 16 C6 27 14 30 24 30 C34 30 42 34 45 44", NEUTRAL, 4.6),
            stroke("M24 30 H41 M37 26 L41.5 30 L37 34", "#e5484d", 3.2),
            stroke("M24 30 V13 M20 17 L24 12.5 L28 17", GOOD, 3.2),
            dot(24, 30, 4.4, *NODE)),
        "curve-plot": (stroke("M7 5 V41 H44", NEUTRAL, 4.2),
                       stroke("M28 9 V36", SECOND, 3, ' stroke-dasharray="1 6"'),
                       stroke("M13 33 C16 17 23 13 28 17", COMB, 4.4),
                       stroke("M28 27 C33 35 37 32 43 20", COMB, 4.4), dot(28, 17, 3.6, *NODE)),
        "keep": pin,
        "audit": (stroke("M10 5 H38 V43 H10 Z", NEUTRAL, 3.6),
                  *(dot(18, y, 3.6, color) for y, color in (
                      (14.5, GAP), (24, ORDER_COLORS[1]), (33.5, ORDER_COLORS[4]))),
                  stroke("M25 14.5 H32 M25 24 H32 M25 33.5 H28", NEUTRAL, 3.2),
                  stroke("M30 37 L35 42 L45 30", GOOD, 4.6)),
    }


#: A tetrahedron with round edges: outline, its front edge, the edge behind.
BODY = "M5 34 C8 22 14 10 23 5 C34 10 41 20 43 30 C36 34 31 38 27 43 C19 42 11 39 5 34 Z"
FRONT = "M23 5 C28 17 29 30 27 43"
BEHIND = "M5 34 C17 29 31 27 43 30"
CORNERS = ((5, 34), (23, 5), (43, 30), (27, 43))


def body(color, *marks):
    """A solid in a colour, its faces faint."""
    return (f'<path d="{BODY}" fill="{color}" fill-opacity="0.28"/>',
            stroke(BEHIND, color, 2.2, ' stroke-dasharray="3 4"'), stroke(BODY, color, 3.8),
            stroke(FRONT, color, 3.8), *marks)


def small(color, transform):
    return (f'<g transform="{transform}">', *body(color), "</g>")


def solid_icons():
    net = "M5 38 L22 4 L45 32 L27 45 Z M22 4 L27 45"
    lens = (dot(33, 33, 8.5, "#ffffff", "#3a4653", 3.4), stroke("M39.4 39.4 L45 45", NEUTRAL, 5),
            stroke("M29 33.4 L32 36.4 L37.2 30", GOOD, 3))
    facing = (*small(FIRST, "translate(-2 6) scale(0.62)"),
              *small(SECOND, "translate(50 42) scale(-0.62)"))
    return {
        "bezier-solid": body(GOOD),
        "solid-points": (*body(GOOD), stroke(net, NEUTRAL, 1.8),
                         *(dot(x, y, 4, *NODE) for x, y in ((5, 38), (22, 4), (45, 32), (27, 45)))),
        "solid-subdivide": body(
            GOOD, stroke("M24 28 L5 34 M24 28 L23 5 M24 28 L43 30 M24 28 L27 43", FIRST, 2.8),
            dot(24, 28, 4, *NODE)),
        "solid-elevate": (*body(GOOD), stroke("M39 20 V4 M33 10 L39 4 L45 10", "#4a90d9", 4.2)),
        "solid-attach": (*small(FIRST, "translate(0 4) scale(0.72)"),
                         stroke("M31 24 L45 8 M31 24 L46 34 M45 8 L46 34 M19 36 L46 34", SECOND,
                                3.4)),
        "solid-contact": (*facing, *lens),
        "solid-validity": (*body(GOOD), *lens),
        "solid-project": (*small(SECOND, "translate(9 -1) scale(0.62)"),
                          stroke("M12 24 L6 41 M23 27 L24 43 M34 22 L42 39", NEUTRAL, 2.2,
                                 ' stroke-dasharray="3 4"'),
                          stroke("M4 41 L24 44 L44 39", GOOD, 4.2)),
        "solid-brep": ('<path d="M5 34 L23 5 L43 30 L27 43 Z" fill="#4a90d9" fill-opacity="0.35"/>',
                       stroke("M5 34 L23 5 L43 30 L27 43 Z M23 5 L27 43", "#4a90d9", 4)),
        "solid-export": (*small(GOOD, "translate(0 0) scale(0.78)"),
                         stroke("M38 22 V43 M29 34 L38 43 L46 34", "#4a90d9", 4.6)),
    }


def button_icons():
    sheet = "M17 15 H38 V44 H17 Z"
    return {
        "swap": (stroke("M8 17 H38 L30 9", FIRST, 4.6), stroke("M40 31 H10 L18 39", SECOND, 4.6)),
        "nearest": (stroke("M4 24 H17 L11.5 18.5 M17 24 L11.5 29.5", FIRST, 4.2),
                    stroke("M44 24 H31 L36.5 18.5 M31 24 L36.5 29.5", SECOND, 4.2),
                    dot(24, 24, 3.2, NEUTRAL)),
        "follow": ('<path d="M13 5 L13 38 L21 30.5 L26.5 43 L32 40.5 L26.5 28.5 L37.5 27.5 Z"'
                   ' fill="#4a90d9" stroke="#ffffff" stroke-width="2" stroke-linejoin="round"/>',),
        "back": (stroke("M8 18 H30 C42 18 42 38 30 38 H20", "#4a90d9", 4.6),
                 stroke("M17 8 L7 18 L17 28", "#4a90d9", 4.6)),
        "forward": (stroke("M40 18 H18 C6 18 6 38 18 38 H28", "#4a90d9", 4.6),
                    stroke("M31 8 L41 18 L31 28", "#4a90d9", 4.6)),
        "fair": (stroke("M4 40 C12 40 13 12 24 12 C35 12 36 40 44 40", GOOD, 4.6),
                 *(stroke(f"M{x} {y} V{y - 6}", NEUTRAL, 2.6)
                   for x, y in ((10, 30), (16, 16), (24, 8), (32, 16), (38, 30)))),
        "free": (stroke("M15 24 V14 A8 8 0 0 1 30 10.5", NEUTRAL, 4.2),
                 stroke("M10 24 H38 V42 H10 Z", NEUTRAL, 4.2)),
        "locked": (stroke("M15 24 V15 A9 9 0 0 1 33 15 V24", NEUTRAL, 4.2),
                   '<rect x="9" y="23" width="30" height="20" rx="3" fill="#e8860c"/>'),
        "up": (stroke("M24 42 V8 M12 20 L24 8 L36 20", "#4a90d9", 4.6),),
        "down": (stroke("M24 6 V40 M12 28 L24 40 L36 28", "#4a90d9", 4.6),),
        "add": (stroke("M24 8 V40 M8 24 H40", GOOD, 5),),
        "remove": (stroke("M8 24 H40", "#c8102e", 5),),
        "copy": (stroke("M31 12 V6 H9 V35 H15", NEUTRAL, 3.6), stroke(sheet, "#4a90d9", 3.6),
                 stroke("M23 24 H32 M23 31 H32", "#4a90d9", 3.2)),
        "paste": (stroke("M15 8 H8 V43 H40 V8 H33", NEUTRAL, 3.6),
                  stroke("M17 5 H31 V12 H17 Z", NEUTRAL, 3.4),
                  stroke("M24 18 V36 M16 28 L24 36 L32 28", "#4a90d9", 4.2)),
        "open": (stroke("M4 40 V9 H17 L21 14 H38 V20", NEUTRAL, 3.6),
                 stroke("M4 40 L12 21 H45 L37 40 Z", "#4a90d9", 3.6)),
        "save": (stroke("M24 6 V30 L14 20 M24 30 L34 20", "#4a90d9", 4.6),
                 stroke("M7 31 V42 H41 V31", NEUTRAL, 4.6)),
    }


def write(name, marks):
    body = "\n  ".join(marks)
    text = ('<svg xmlns="http://www.w3.org/2000/svg" width="48" height="48"'
            f' viewBox="0 0 48 48">\n  {body}\n</svg>\n')
    (FOLDER / f"{name}.svg").write_text(text, encoding="utf-8")


def main():
    for name, marks in {**verdict_icons(), **command_icons(), **solid_icons(),
                        **button_icons()}.items():
        write(name, marks)


if __name__ == "__main__":
    main()
