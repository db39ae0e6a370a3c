# SPDX-License-Identifier: Apache-2.0
"""What does my robot's camera see from here? Views from a room that was scanned with Spherewalk.

    import math
    import spherewalk

    dataset = spherewalk.Dataset.open("kitchen.dataset")
    camera = spherewalk.Camera.pinhole(640, 480, math.radians(69))
    renderer = spherewalk.Renderer(dataset)
    view = renderer.render(camera, [2, 1.5, 1.2, 0, 0, 0, 1], frame="body")
    view.picture    # numpy, (480, 640, 3) uint8
    view.report     # the photo it was made from, how far away that is, how far it can be trusted

Metres, radians, seconds, pixels. The room has x and y on the floor and z up. A pose is room_from_camera: a (4, 4)
matrix, or the seven numbers x y z qx qy qz qw; of the camera's optical frame (z forward, x right, y down), or, with
frame="body", of its body (x forward, y left, z up). Errors are spherewalk.Error, and Python's own kinds besides.
"""

import enum

from ._core import (
    Camera,
    Dataset,
    LightProbe,
    Overlay,
    Photo,
    Renderer,
    Sensor,
    StreamCounters,
    View,
    ViewOptions,
    ViewReport,
    ViewStream,
    __version__,
    pose_matrix,
    read_rig,
    read_tum,
    simd_target,
)
from ._errors import (
    BusyError,
    CorruptError,
    Error,
    InvalidInputError,
    NotFoundError,
    ReadError,
    StoppedError,
    UnsupportedError,
)


class PixelFlag(enum.IntFlag):
    """What is to be known of a pixel besides its error: the bits of View.flags."""

    UNSEEN = 1  #: the lens sees nothing there
    POLE = 2  #: near the photo's zenith or nadir, where the camera's own foot is in the picture
    STITCHING = 4  #: near where the pictures of a camera's two lenses were joined
    SEAM = 8  #: partly from the photo's left border, partly from its right one
    COARSE = 16  #: blurred, since the view was made from a coarser picture than the photo
    OVERLAY = 32  #: at least partly covered by an overlay
    FILLED = 64  #: filled in from beside, as no photo shows what is there
    UNSURE = 128  #: perhaps displaced by more than two pixels, or nothing is known


__all__ = [
    "BusyError",
    "Camera",
    "CorruptError",
    "Dataset",
    "Error",
    "InvalidInputError",
    "LightProbe",
    "NotFoundError",
    "Overlay",
    "Photo",
    "PixelFlag",
    "ReadError",
    "Renderer",
    "Sensor",
    "StoppedError",
    "StreamCounters",
    "UnsupportedError",
    "View",
    "ViewOptions",
    "ViewReport",
    "ViewStream",
    "__version__",
    "pose_matrix",
    "read_rig",
    "read_tum",
    "simd_target",
]
