"""Makes the OpenStream message from the settings of a stream."""
from __future__ import annotations

import difflib
from collections.abc import Collection, Mapping
from typing import Any

from saccade.protocol.objects import make_objects
from saccade.protocol.setting_checks import CHANGES, OF_SENSORS, checked
from saccade.protocol.trajectory import make_trajectory
from saccade.protocol.truth_request import make_truth
from saccade.protocol.views import make_further_views, make_view, with_calibration
from saccade.settings import SensorSettings, Settings
from saccade.v1 import control_pb2 as c
from saccade.v1 import noise_pb2

OF_ALL_SENSORS = ("max_events_per_pixel_frame", "max_events_per_frame", "preset", "labels", "object_ids", "max_artefact_odds",
                  "model", "start_level", "reconstruction")
OF_SCENES = ("scene", "trajectory", "motion", "turn_s", "motion_seed", "clearance", "start", "objects", "animation", "method", "spp",
             "params", "disable", "calibration", "fov_x_deg", "intrinsics", "distortion", "T_body_camera", "further_views")
OF_QUALITY = ("bounces", "monochrome", "budget_ms", "max_false_rate", "max_event_change", "jitter", "bake_error")


def make_request(settings: Settings) -> c.OpenStream:
    """Raises TypeError for an unknown or missing setting, and ValueError or OSError for a faulty one.

    The server checks ranges: it answers with saccade.InvalidArgument.
    """
    _check_names(settings, Settings.__required_keys__ | Settings.__optional_keys__, "a stream")
    s: Mapping[str, Any] = checked(settings)
    pushed = s.get("pushed", False)
    if pushed:
        _check_pushed(s)
    s = with_calibration(s)
    for name in ("size", "rate_hz" if pushed else "scene"):
        if name not in s:
            raise TypeError(f"the setting '{name}' is missing")
    return c.OpenStream(
        view=make_view(s), further_views=make_further_views(s), sensors=_sensors(s), truth=make_truth(s),
        timing=c.Timing(**({"frame_rate_hz": s["rate_hz"]} if "rate_hz" in s else {}),
                        **_some(s, "clock", "duration_s", "speed", "steerable", "packet_per_frame", "until_path_ends",
                                "interval_px", "max_rate_hz"),
                        **({"refinement": c.Refinement(finest_px=s["finest_px"])} if "finest_px" in s else {})),
        **({"pushed": True} if pushed else _scene(s)), **_some(s, "delivery", "codec", "seed"))


def make_sensor_change(change: SensorSettings) -> c.SensorChange:
    """Raises TypeError for an unknown setting, and ValueError for a faulty one."""
    _check_names(change, CHANGES, "a change of a sensor")
    return c.SensorChange(**checked(change, CHANGES))


def _check_names(settings: Mapping[str, Any], known: Collection[str], what: str) -> None:
    for name in settings.keys() - set(known):
        near = difflib.get_close_matches(name, known, 1)
        raise TypeError(f"{what} has no setting '{name}'" + (f"; did you mean '{near[0]}'?" if near else ""))


def _check_pushed(settings: Mapping[str, Any]) -> None:
    for name in OF_SCENES + OF_QUALITY:
        if name in settings:
            raise TypeError(f"a pushed stream has no setting '{name}'")


def _scene(s: Mapping[str, Any]) -> dict[str, Any]:
    """What is rendered, and how."""
    return {"scene": s["scene"], "trajectory": make_trajectory(s), "objects": make_objects(s), **_some(s, "animation"),
            "method": c.Method(name=s.get("method", ""), **_some(s, "spp", "params")),
            "quality": c.Quality(disabled_features=s.get("disable", ()), **_some(s, *OF_QUALITY))}


def _some(settings: Mapping[str, Any], *names: str) -> dict[str, Any]:
    return {name: settings[name] for name in names if name in settings}


def _sensors(s: Mapping[str, Any]) -> list[c.Sensor]:
    columns = _some(s, *OF_SENSORS)
    lists = {name: value for name, value in columns.items() if isinstance(value, list)}
    count = max(map(len, lists.values()), default=1)
    for name, values in lists.items():
        if len(values) != count:
            raise ValueError(f"{name} has {len(values)} values for {count} sensors")
    common = _some(s, *OF_ALL_SENSORS)
    if "noise" in s:
        common["noise"] = noise_pb2.Noise(**s["noise"])
    own = [{name: value[i] if isinstance(value, list) else value for name, value in columns.items()}
           for i in range(count)]
    return [c.Sensor(view=view, **common, **settings_of_one)
            for view in range(1 + len(s.get("further_views", ()))) for settings_of_one in own]
