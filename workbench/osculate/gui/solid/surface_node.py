"""Coin nodes of triangle meshes and lines that change in place."""

import numpy
from pivy import coin

from osculate.gui.overlays import nodes
from osculate.gui.solid.jacobian_colors import places_of, texture

_SHININESS, _SPECULAR = 0.3, (0.2, 0.2, 0.2)
_WHITE = (1.0, 1.0, 1.0)
_LINEAR = 0.3  # Coin's quality of textures that are interpolated, without smaller copies


class SurfaceNode:
    """A smooth surface, lit on both sides; `node` goes into the scene and can be picked."""

    def __init__(self, *before):
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE  # lights both sides
        hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        self._material = coin.SoMaterial()
        self._material.shininess = _SHININESS
        self._material.specularColor = _SPECULAR
        self._coordinates, self._normals = coin.SoCoordinate3(), coin.SoNormal()
        normal_binding = coin.SoNormalBinding()
        normal_binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        self._texture, self._places = coin.SoSwitch(), coin.SoTextureCoordinate2()
        for node in (_unmixed(), texture(), self._places):
            self._texture.addChild(node)
        self._faces = coin.SoIndexedFaceSet()
        self.node = nodes.separator(*before, hints, self._material, self._coordinates,
                                    self._normals, normal_binding, self._texture, self._faces)
        self._values = None

    def show(self, surfaces):
        """Shows Triangles, as one surface."""
        points, normals, indices, first = [], [], [], 0
        for surface in surfaces:
            points.append(surface.points)
            normals.append(surface.normals)
            ends = numpy.full((len(surface.triangles), 1), -1)
            indices.append(numpy.hstack([surface.triangles + first, ends]))
            first += len(surface.points)
        has_values = first > 0 and all(surface.values is not None for surface in surfaces)
        self._values = (numpy.concatenate([surface.values for surface in surfaces])
                        if has_values else None)
        fill(self._coordinates.point, rows(points))
        fill(self._normals.vector, rows(normals))
        fill(self._faces.coordIndex, numpy.concatenate(indices).ravel().tolist() if first else [])

    def paint(self, color, transparency):
        """One colour (r, g, b) for all."""
        self._texture.whichChild = coin.SO_SWITCH_NONE
        self._material.diffuseColor = self._material.ambientColor = tuple(color[:3])
        self._material.transparency = transparency

    def paint_jacobians(self, largest, transparency):
        """The colours of the values of the surfaces that are shown; `largest`: their magnitude."""
        if self._values is None:
            return
        fill(self._places.point, places_of(self._values, largest).tolist())
        self._material.diffuseColor = self._material.ambientColor = _WHITE
        self._material.transparency = transparency
        self._texture.whichChild = coin.SO_SWITCH_ALL


class LinesNode:
    """Lines of some pixels in one colour, without a rim; `node` goes into the scene."""

    def __init__(self, *before):
        self._material = coin.SoMaterial()
        self._style = coin.SoDrawStyle()
        self._coordinates, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        self.node = nodes.separator(*before, nodes.unlit(), self._material, self._style,
                                    self._coordinates, self._lines)

    def show(self, lines):
        """Shows lines through points, each (n, 3)."""
        lines = [line for line in lines if len(line) > 1]
        indices, first = [], 0
        for line in lines:
            indices.extend(range(first, first + len(line)))
            indices.append(-1)
            first += len(line)
        fill(self._coordinates.point, rows(lines))
        fill(self._lines.coordIndex, indices)

    def show_legs(self, points, legs):
        """Shows lines between some pairs of points."""
        fill(self._coordinates.point, rows([points]))
        fill(self._lines.coordIndex, [i for leg in legs for i in (*leg, -1)])

    def paint(self, color, width, transparency=0.0, pattern=nodes.SOLID):
        self._material.diffuseColor = tuple(color[:3])
        self._material.transparency = transparency
        self._style.lineWidth = width
        self._style.linePattern = pattern


def _unmixed():
    quality = coin.SoComplexity()
    quality.textureQuality = _LINEAR
    return quality


def behind_lines():
    """A node that draws the surfaces that follow a little deeper, so that lines on them show."""
    offset = coin.SoPolygonOffset()
    offset.factor, offset.units = 1.0, 1.0
    return offset


def through_everything():
    """A node after which nothing hides behind anything."""
    depth = coin.SoDepthBuffer()
    depth.test = False
    depth.write = False
    return depth


def rows(arrays):
    """The rows of arrays as one list of lists, which Coin takes fastest."""
    return numpy.concatenate(arrays).tolist() if len(arrays) else []


def fill(field, values):
    """Sets all values of a Coin field at once."""
    field.setNum(len(values))
    if values:
        field.setValues(0, len(values), values)
