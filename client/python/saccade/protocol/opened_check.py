"""Checks a server's reply to open_stream, so that the rest of the client can rely on it."""
from __future__ import annotations

from collections.abc import Sequence
from typing import NoReturn

from saccade.camera import cameras_of
from saccade.errors import StreamFault
from saccade.v1 import control_pb2

MOST_SIDE, MOST_PIXELS = 4096, 4 << 20  # of a view
RATES_HZ = 0.1, 1e5
MOST_DURATION_S = 1e7


def check_opened(opened: control_pb2.StreamOpened, asked: control_pb2.OpenStream) -> None:
    """Raises StreamFault unless the reply has a stream with the sensors, truth channels and views of `asked`."""
    resolved = opened.resolved
    if not opened.stream_id:
        _fail("a stream without stream_id")
    for what in ("sensors", "truth", "further_views"):
        if (count := len(getattr(resolved, what))) != len(getattr(asked, what)):
            _fail(f"{count} {what} instead of {len(getattr(asked, what))}")
    views = [resolved.view, *resolved.further_views]
    for view, wanted in zip(views, (asked.view, *asked.further_views)):
        _check_view(view, wanted)
    _check_view_numbers([sensor.view for sensor in resolved.sensors], len(views))
    _check_view_numbers([truth.view for truth in resolved.truth], len(views))
    if not RATES_HZ[0] <= resolved.timing.frame_rate_hz <= RATES_HZ[1]:
        _fail(f"timing.frame_rate_hz is {resolved.timing.frame_rate_hz}")
    if not 0 <= resolved.timing.duration_s <= MOST_DURATION_S:
        _fail(f"timing.duration_s is {resolved.timing.duration_s}")
    try:
        cameras_of(resolved)
    except ValueError as fault:
        _fail(str(fault))
    _check_delivery(opened, asked.delivery)


def _check_view(view: control_pb2.View, asked: control_pb2.View) -> None:
    same = (view.width, view.height) == (asked.width, asked.height)
    can_be = 0 < view.width <= MOST_SIDE and 0 < view.height <= MOST_SIDE and view.width * view.height <= MOST_PIXELS
    if not same or not can_be:
        _fail(f"a view of {view.width}x{view.height} pixels")


def _check_view_numbers(numbers: Sequence[int], views: int) -> None:
    for number in numbers:
        if number >= views:
            _fail(f"a channel of view {number} of {views}")


def _check_delivery(opened: control_pb2.StreamOpened, asked: int) -> None:
    delivery = opened.resolved.delivery
    known = delivery != control_pb2.DELIVERY_UNSPECIFIED and delivery in control_pb2.Delivery.values()
    if not known or asked not in (control_pb2.DELIVERY_UNSPECIFIED, delivery):
        _fail(f"delivery {delivery}")
    if delivery == control_pb2.DELIVERY_BROADCAST and not opened.topics:
        _fail("a broadcast without topics")


def _fail(what: str) -> NoReturn:
    raise StreamFault(f"the server's reply to open_stream cannot be: {what}")
