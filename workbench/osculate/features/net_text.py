"""Control nets as text: what is copied from a table and pasted into one."""

import re

import FreeCAD

from osculate.features.control_net import (
    COLUMNS, FOURTH, WEIGHT, NetError, degree_of, indices_of, lists_of)

translate = FreeCAD.Qt.translate

_INDICES = ("i", "j", "k", "l")
#: Which columns a table without a head has, by their number.
_WITHOUT_HEAD = {
    3: COLUMNS[:3], 4: (*COLUMNS[:3], WEIGHT), 5: COLUMNS,
    7: (*_INDICES, *COLUMNS[:3]), 8: (*_INDICES, *COLUMNS[:3], WEIGHT), 9: (*_INDICES, *COLUMNS),
}
_SHORT_NAMES = {"w": WEIGHT, "x4": FOURTH, "x1": "x", "x2": "y", "x3": "z"}


def write(value):
    """The net of a BezierTetrahedron as a table with tabs and a head, every digit kept."""
    points, weights, fourth = lists_of(value)
    heads = [*_INDICES, *COLUMNS[:3], *([FOURTH] if fourth else []), *([WEIGHT] if weights else [])]
    lines = ["\t".join(heads)]
    for row, index in enumerate(indices_of(value.degree)):
        numbers = [*points[row], *fourth[row:row + 1], *weights[row:row + 1]]
        lines.append("\t".join([*map(str, index), *map(repr, numbers)]))
    return "\n".join(lines) + "\n"


def read(text):
    """(points, weights, fourth) of a table, as control_net.value_of takes them. Raises NetError.

    A row a point, its numbers between tabs, semicolons, commas or blanks: x y z, with a weight
    behind; in four dimensions x y z, fourth coordinate, weight. Indices i j k l may stand in
    front, else the rows are in the order of the net. A line of names in front says which columns
    there are instead (i j k l x y z fourth weight, or w). Lines that begin with # are left out.
    """
    lines = [(number, _fields(line)) for number, line in enumerate(text.splitlines(), start=1)
             if line.strip() and not line.lstrip().startswith("#")]
    if not lines:
        raise NetError(translate("Osculate", "There is no table in the text."))
    heads = _heads(lines[0][1])
    if heads:
        lines = lines[1:]
    columns = heads or _columns_by_count(len(lines[0][1]))
    rows = [_row(number, fields, columns) for number, fields in lines]
    degree = degree_of(len(rows))
    return _lists(_in_order(rows, degree) if "i" in columns else rows, columns)


def _fields(line):
    for separator in ("\t", ";"):
        if separator in line:
            return [field.strip() for field in line.split(separator)]
    if re.search(r",\s", line) or ("," in line and not re.search(r"\s", line.strip())):
        return [field.strip() for field in line.split(",")]
    return line.split()


def _heads(fields):
    """The names of the columns; empty if the fields are numbers."""
    names = [_SHORT_NAMES.get(field.lower(), field.lower()) for field in fields]
    if all(_is_number(field) for field in fields):
        return ()
    missing = [name for name in COLUMNS[:3] if name not in names]
    unknown = [name for name in names if name not in (*_INDICES, *COLUMNS)]
    if missing or unknown or len(set(names)) < len(names) or len({*_INDICES} & {*names}) in (
            1, 2, 3):
        raise NetError(translate("Osculate", "The first line names no columns of a net: {}. They "
                                             "are i j k l x y z fourth weight, x y z at least.")
                       .format(" ".join(fields)))
    return tuple(names)


def _columns_by_count(count):
    if count not in _WITHOUT_HEAD:
        raise NetError(translate("Osculate", "{} numbers in a row: x y z are needed, with a weight "
                                             "or not, with indices i j k l in front or not.")
                       .format(count))
    return _WITHOUT_HEAD[count]


def _row(line, fields, columns):
    if len(fields) != len(columns):
        raise NetError(translate("Osculate", "Line {}: {} numbers are needed, not {}.").format(
            line, len(columns), len(fields)))
    return {column: _number(line, column, field) for column, field in zip(columns, fields)}


def _number(line, column, field):
    if not _is_number(field):
        raise NetError(translate("Osculate", "Line {}: {} must be a number, not “{}”.").format(
            line, column, field))
    return float(_plain(field))


def _is_number(field):
    try:
        float(_plain(field))
    except ValueError:
        return False
    return True


def _plain(field):
    return field.replace("−", "-").replace(",", ".")


def _in_order(rows, degree):
    """The rows in the order of the net, by their indices."""
    by_index = {}
    for row in rows:
        index = tuple(row[name] for name in _INDICES)
        text = " ".join(f"{number:g}" for number in index)
        if index not in indices_of(degree):
            raise NetError(translate("Osculate", "{} is no index of degree {}: four whole numbers "
                                                 "from 0 with the sum {}.").format(
                text, degree, degree))
        if index in by_index:
            raise NetError(translate("Osculate", "Two rows have the index {}.").format(text))
        by_index[index] = row
    return [by_index[index] for index in indices_of(degree)]


def _lists(rows, columns):
    def numbers(column):
        return [row[column] for row in rows] if column in columns else []
    return list(zip(*map(numbers, COLUMNS[:3]))), numbers(WEIGHT), numbers(FOURTH)
