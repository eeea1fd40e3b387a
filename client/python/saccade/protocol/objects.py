"""Makes the ObjectMotion messages from the setting `objects`."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from saccade.protocol.setting_checks import OWN, STILL
from saccade.protocol.trajectory import make_keyframes, read_poses
from saccade.v1 import control_pb2 as c


def make_objects(settings: Mapping[str, Any]) -> list[c.ObjectMotion]:
    """Of checked settings. Raises ValueError for a file that is no text, and OSError for one that cannot be read."""
    return [c.ObjectMotion(name=name, path=_path(name, path)) for name, path in settings.get("objects", {}).items()]


def _path(name: str, path: Any) -> c.ObjectPath:
    if isinstance(path, c.ObjectSpeed):
        return c.ObjectPath(motion=path)
    if isinstance(path, str) and path == OWN:
        return c.ObjectPath(own=c.OwnMotion())
    if isinstance(path, str) and path == STILL:
        return c.ObjectPath(still=c.NoMotion())
    if isinstance(path, np.ndarray):
        return c.ObjectPath(keyframes=make_keyframes(path))
    return c.ObjectPath(csv=read_poses(f"objects.{name}", path))
