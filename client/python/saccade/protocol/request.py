"""Makes the OpenStream message from the settings of a stream."""
from __future__ import annotations

import difflib
import operator
from collections.abc import Mapping, Sequence
from typing import Any

from google.protobuf.internal.enum_type_wrapper import EnumTypeWrapper

from saccade.protocol.trajectory import make_trajectory
from saccade.settings import Settings
from saccade.v1 import control_pb2 as c
from saccade.v1 import events_pb2, noise_pb2
from saccade.v1.geometry_pb2 import Quaternion, RigidTransform, Vector3
from saccade.v1.truth_pb2 import Truth

PER_SENSOR = ("threshold", "threshold_off", "bias", "refractory_s", "cutoff_hz")
OF_ALL_SENSORS = ("max_events_per_pixel_frame", "max_events_per_frame", "preset", "labels", "max_artefact_odds")
OF_SCENES = ("scene", "trajectory", "motion", "turn_s", "motion_seed", "method", "spp", "params", "disable")
NEVER_ZERO = ("spp", "speed", "max_events_per_pixel_frame", "max_events_per_frame")
OF_QUALITY = ("bounces", "monochrome", "budget_ms", "max_false_rate", "max_event_change", "jitter", "bake_error")


def make_request(settings: Settings) -> c.OpenStream:
    """Raises TypeError for an unknown or missing setting, and ValueError or OSError for a faulty one.

    The server checks ranges: it answers with saccade.InvalidArgument.
    """
    _check_names(settings)
    s: Mapping[str, Any] = settings
    _check_numbers(s)
    return c.OpenStream(
        view=_view(s),
        timing=c.Timing(frame_rate_hz=s["rate_hz"], clock=_value(c.Clock, s, "clock"),
                        **_some(s, "duration_s", "speed", "steerable", "packet_per_frame")),
        sensors=_sensors(s),
        further_views=_further_views(s),
        delivery=_value(c.Delivery, s, "delivery"),
        codec=_value(events_pb2.Codec, s, "codec"),
        truth=_truths(s.get("truth", ())),
        **_picture_source(s), **_some(s, "seed"))


def _picture_source(settings: Mapping[str, Any]) -> dict[str, Any]:
    """What is rendered, and how; or that the client sends the frames."""
    if settings.get("pushed"):
        for name in OF_SCENES + OF_QUALITY:
            if name in settings:
                raise TypeError(f"a pushed stream has no setting '{name}'")
        return {"pushed": True}
    if "scene" not in settings:
        raise TypeError("the setting 'scene' is missing")
    return {"scene": settings["scene"], "trajectory": make_trajectory(settings),
            "method": c.Method(name=settings.get("method", ""), **_some(settings, "spp", "params")),
            "quality": c.Quality(disabled_features=settings.get("disable", ()), **_some(settings, *OF_QUALITY))}


def _check_names(settings: Mapping[str, Any]) -> None:
    known = Settings.__required_keys__ | Settings.__optional_keys__
    for name in settings.keys() - known:
        near = difflib.get_close_matches(name, known, 1)
        raise TypeError(f"a stream has no setting '{name}'" + (f"; did you mean '{near[0]}'?" if near else ""))
    for name in sorted(Settings.__required_keys__ - settings.keys()):
        raise TypeError(f"the setting '{name}' is missing")


def _check_numbers(settings: Mapping[str, Any]) -> None:
    """In the message 0 means that these are unset."""
    for name in NEVER_ZERO:
        if settings.get(name) == 0:
            raise ValueError(f"{name}: 0 is no value; leave it out for the default")


def _some(settings: Mapping[str, Any], *names: str) -> dict[str, Any]:
    return {name: settings[name] for name in names if name in settings}


def _value(enum: EnumTypeWrapper, settings: Mapping[str, Any], name: str) -> Any:
    """The enum's value for a text such as "paced"; 0, unspecified, where the setting is absent."""
    if name not in settings:
        return 0
    prefix = enum.Name(0).removesuffix("UNSPECIFIED")
    known = {key.removeprefix(prefix).lower(): value for key, value in enum.items() if value != 0}
    if settings[name] not in known:
        raise ValueError(f"{name}: '{settings[name]}' is not one of {', '.join(known)}")
    return known[settings[name]]


def _truths(channels: str | Sequence[str | tuple[str, int]]) -> list[Truth]:
    return [_truth(channel) for channel in ([channels] if isinstance(channels, str) else channels)]


def _truth(channel: str | tuple[str, int]) -> Truth:
    name, every = (channel, 1) if isinstance(channel, str) else channel
    if every < 1:
        raise ValueError(f"truth: {name} of every {every} frames: give at least 1")
    return Truth(name=name, every=every)


def _size(settings: Mapping[str, Any]) -> tuple[int, int]:
    try:
        width, height = map(operator.index, settings["size"])
    except (TypeError, ValueError):
        raise ValueError(f"size: {settings['size']!r} is not (width, height), whole numbers") from None
    return width, height


def _view(settings: Mapping[str, Any]) -> c.View:
    width, height = _size(settings)
    view = c.View(width=width, height=height, **_some(settings, "fov_x_deg"))
    if "intrinsics" in settings:
        fx, fy, cx, cy = settings["intrinsics"]
        view.intrinsics.CopyFrom(c.Intrinsics(fx=fx, fy=fy, cx=cx, cy=cy))
    if "distortion" in settings:
        model, coefficients = settings["distortion"]
        view.distortion.CopyFrom(c.Distortion(model=_value(c.DistortionModel, {"distortion": model}, "distortion"),
                                              coefficients=coefficients))
    return view


def _further_views(settings: Mapping[str, Any]) -> list[c.View]:
    """Views like the first, at other places on the body."""
    views = []
    for numbers in settings.get("further_views", ()):
        if len(numbers) not in (3, 7):
            raise ValueError("further_views: each is x y z, or x y z qx qy qz qw")
        place = RigidTransform(position=Vector3(**dict(zip("xyz", numbers))))
        if len(numbers) == 7:
            place.rotation.CopyFrom(Quaternion(**dict(zip("xyzw", numbers[3:]))))
        view = _view(settings)
        view.body_camera.CopyFrom(place)
        views.append(view)
    return views


def _sensors(settings: Mapping[str, Any]) -> list[c.Sensor]:
    columns = {name: settings[name] for name in PER_SENSOR if name in settings}
    lists = {name: list(value) for name, value in columns.items() if hasattr(value, "__len__")}
    count = max((len(values) for values in lists.values()), default=1)
    for name, values in lists.items():
        if len(values) != count:
            raise ValueError(f"{name} has {len(values)} values for {count} sensors")
    common = _some(settings, *OF_ALL_SENSORS)
    if "noise" in settings:
        common["noise"] = _noise(settings["noise"])
    common["model"] = _value(c.EventModel, settings, "model")
    common["reconstruction"] = _value(c.Reconstruction, settings, "reconstruction")
    own = [{name: lists[name][i] if name in lists else value for name, value in columns.items()} for i in range(count)]
    return [c.Sensor(view=view, **common, **settings_of_one)
            for view in range(1 + len(settings.get("further_views", ()))) for settings_of_one in own]


def _noise(amounts: Mapping[str, float]) -> noise_pb2.Noise:
    known = noise_pb2.Noise.DESCRIPTOR.fields_by_name
    for name in amounts:
        if name not in known:
            raise ValueError(f"noise: '{name}' is not one of {', '.join(known)}")
    return noise_pb2.Noise(**amounts)
