"""Pictures that are painted with Qt and shown in the 3D view."""

from pivy import coin

from osculate.gui.overlays import nodes
from osculate.gui.qt import Qt, QtGui

TEXT_COLOR = "#16202b"


def canvas(width, height):
    """A clear picture of width x height points, at the density of the screen."""
    density = QtGui.QGuiApplication.primaryScreen().devicePixelRatio()
    picture = QtGui.QImage(round(width * density), round(height * density),
                           QtGui.QImage.Format.Format_RGBA8888)
    picture.setDevicePixelRatio(density)
    picture.fill(0)
    return picture


def painter_on(picture):
    """A painter with smooth edges; it must be ended."""
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
    return painter


def image_node(picture, horizontal, vertical):
    """A node that shows a picture at its point, by Coin's alignments."""
    node = coin.SoImage()
    size = coin.SbVec2s(picture.width(), picture.height())
    upright = picture.mirrored(False, True)  # Coin counts rows from below
    node.image.setValue(size, 4, bytes(upright.constBits()))
    node.horAlignment = horizontal
    node.vertAlignment = vertical
    return nodes.without_extent(node)


def label_fonts(points):
    """The fonts of labels, plain and bold."""
    font = QtGui.QFont()
    font.setPointSize(points)
    bold = QtGui.QFont(font)
    bold.setBold(True)
    return font, bold


def draw_text(painter, box, text, font, color):
    """Writes into the middle of a box."""
    painter.setFont(font)
    painter.setPen(QtGui.QColor(color))
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
