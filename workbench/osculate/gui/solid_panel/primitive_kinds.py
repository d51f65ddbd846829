"""The kinds of solids that can be made from a few numbers, and their parameters."""

from dataclasses import dataclass
from typing import Callable

import numpy

from osculate import solids
from osculate.features.control_net import MOST_DEGREE
from osculate.gui.qt import translate
from osculate.gui.solid_panel.fields import (
    ChoiceField, CountField, NumberField, PointField, length_field)

_MOST_SEED = 2 ** 31 - 1


@dataclass(frozen=True)
class Kind:
    """A kind of solid."""

    name: str
    title: str        #: in the user's language
    fields: Callable  #: makes {key: (label, field)}
    make: Callable    #: from the values of the fields to one BezierTetrahedron or a list


def kinds():
    """All kinds, in the order in which they are offered."""
    return (
        Kind("tetrahedron", translate("Osculate", "Tetrahedron"), _tetrahedron_fields,
             solids.tetrahedron),
        Kind("cone", translate("Osculate", "Cone"), _cone_fields, solids.cone),
        Kind("elliptic-cone", translate("Osculate", "Elliptic cone"), _elliptic_cone_fields,
             solids.elliptic_cone),
        Kind("frustum-wedge", translate("Osculate", "Frustum or sector of one"), _frustum_fields,
             solids.frustum_wedge),
        Kind("cylinder-wedge", translate("Osculate", "Cylinder or sector of one"),
             _cylinder_fields, solids.cylinder_wedge),
        Kind("ball-octant", translate("Osculate", "Ball octant"), _octant_fields,
             solids.ball_octant),
        Kind("sphere-wedge", translate("Osculate", "Spherical wedge"), _sphere_fields,
             _on_sphere(solids.sphere_wedge)),
        Kind("circle-wedge", translate("Osculate", "Wedge with circular edges"), _sphere_fields,
             _on_sphere(solids.sphere_wedge_by_circles)),
        Kind("random", translate("Osculate", "Random, to learn from"), _random_fields,
             solids.random),
    )


def _tetrahedron_fields():
    corners = ((0, 0, 0), (50, 0, 0), (0, 50, 0), (0, 0, 50))
    return {key: (translate("Osculate", "Corner {}").format(number), PointField(corner))
            for number, (key, corner) in enumerate(zip("abcd", corners))}


def _cone_fields():
    return {"radius": (translate("Osculate", "Radius"), length_field(25)),
            "height": (translate("Osculate", "Height"), length_field(50))}


def _elliptic_cone_fields():
    return {"radius_x": (translate("Osculate", "Half axis along x"), length_field(40)),
            "radius_y": (translate("Osculate", "Half axis along y"), length_field(25)),
            "apex": (translate("Osculate", "Apex"), PointField((0, 0, 60)))}


def _frustum_fields():
    return {"lower_radius": (translate("Osculate", "Radius below"), length_field(30)),
            "upper_radius": (translate("Osculate", "Radius above"), length_field(15)),
            "height": (translate("Osculate", "Height"), length_field(40)),
            "angle": (translate("Osculate", "Angle"), NumberField(90, "°", 0, 360))}


def _cylinder_fields():
    return {"radius": (translate("Osculate", "Radius"), length_field(25)),
            "height": (translate("Osculate", "Height"), length_field(40)),
            "angle": (translate("Osculate", "Angle"), NumberField(90, "°", 0, 360))}


def _octant_fields():
    return {"radius": (translate("Osculate", "Radius"), length_field(50))}


def _sphere_fields():
    directions = ((1, 0, 0), (0.3, 1, 0.2), (0.2, 0.3, 1))
    return {"centre": (translate("Osculate", "Centre"), PointField((0, 0, 0))),
            "radius": (translate("Osculate", "Radius"), length_field(50)),
            **{key: (translate("Osculate", "Direction {}").format(number),
                     PointField(direction, suffix=""))
               for number, (key, direction) in enumerate(zip("abc", directions), start=1)}}


def _random_fields():
    return {"degree": (translate("Osculate", "Degree"), CountField(3, 1, MOST_DEGREE)),
            "seed": (translate("Osculate", "Number of the drawing"),
                     CountField(1, 0, _MOST_SEED)),
            "dimension": (translate("Osculate", "Space"), ChoiceField((
                (3, translate("Osculate", "three dimensions")),
                (4, translate("Osculate", "four dimensions")))))}


def _on_sphere(make):
    """A maker of a wedge over corners at a radius in directions from the centre."""
    def make_at(centre, radius, **directions):
        if not radius > 0.0:
            raise ValueError(translate("Osculate", "The radius must be more than 0."))
        corners = []
        for direction in directions.values():
            length = numpy.linalg.norm(direction)
            if length == 0.0:
                raise ValueError(translate("Osculate", "A direction must not be 0, 0, 0."))
            corners.append(numpy.add(centre, numpy.multiply(direction, radius / length)))
        return make(centre, *corners)
    return make_at
