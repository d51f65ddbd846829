"""Overlays of document objects, drawn in the coordinates of the world."""

import numpy
from pivy import coin


def matrix_from_world(obj):
    """Takes back the placement of an App::Part around a document object."""
    parent = obj.getParentGeoFeatureGroup()
    if parent is None:
        return coin.SbMatrix.identity()
    matrix = numpy.reshape(parent.getGlobalPlacement().inverse().toMatrix().A, (4, 4))
    return coin.SbMatrix(*map(float, matrix.T.ravel()))  # Coin multiplies rows
