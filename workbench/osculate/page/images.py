"""Pictures from files, put into a page."""

import base64
import os

from osculate.page.markup import tag

#: How files begin, and what they are.
_KINDS = ((b"\x89PNG\r\n\x1a\n", "image/png"), (b"\xff\xd8\xff", "image/jpeg"),
          (b"<?xml", "image/svg+xml"), (b"<svg", "image/svg+xml"))


def figures(pictures):
    """A figure for each of some pictures: paths, or pairs of a path and a caption.

    Raises OSError for a file that cannot be read, ValueError for what is no PNG, JPEG or SVG,
    TypeError for what is neither path nor pair.
    """
    if isinstance(pictures, (str, bytes, os.PathLike)):
        raise TypeError("pictures: must be a list of paths, got a path")
    return [_figure(*_path_and_caption(picture)) for picture in pictures]


def _figure(path, caption):
    with open(path, "rb") as file:
        content = file.read()
    kind = next((kind for start, kind in _KINDS if content.startswith(start)), None)
    if kind is None:
        raise ValueError(f"pictures: {os.fsdecode(path)} is no PNG, JPEG or SVG file")
    source = f"data:{kind};base64,{base64.b64encode(content).decode('ascii')}"
    return tag("figure", tag("img", src=source, alt=caption or "a picture of the model"),
               tag("figcaption", caption) if caption else None)


def _path_and_caption(picture):
    if isinstance(picture, (str, os.PathLike)):
        return picture, ""
    if isinstance(picture, (tuple, list)) and len(picture) == 2 and isinstance(picture[1], str):
        return tuple(picture)
    raise TypeError("pictures: each must be a path, or a path with a caption, got "
                    f"{type(picture).__name__}")
