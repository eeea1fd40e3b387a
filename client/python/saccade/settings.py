"""The settings of a stream: the keyword arguments of Client.open()."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Literal, TypedDict, Union

import numpy as np
from numpy.typing import NDArray

from saccade.camera import Camera

PerSensor = Union[float, Sequence[float]]
Place = Union[NDArray[np.float64], Sequence[float], Sequence[Sequence[float]]]


class SensorSettings(TypedDict, total=False):
    """Settings that Stream.change_sensor() changes; unset ones stay. time_s: stream time, 0 for as soon as possible.

    noise: all amounts by name from then on; those left out are as the stream was opened.
    """

    time_s: float
    threshold: float
    threshold_off: float
    bias: float
    noise: Mapping[str, float]


class Settings(TypedDict, total=False):
    """All settings. Unset ones take the server's default; proto/PROTOCOL.md gives defaults, ranges and meaning.

    scene: one of Client.scenes(). Or pushed: the stream gets its frames from Stream.push(), and has only sensors, size,
        rate_hz, duration_s, delivery, codec, seed and truth.

    Of a scene, one of these two says how the camera moves:
    trajectory: a name from Client.scenes(), the path of a file of poses (a Path, or a str that ends in .csv or
        .txt), or poses, float (n, 8): time in seconds, position x y z, quaternion x y z w of T_world_camera.
    motion: "KIND:SPEED" such as "pan:-15", "KIND:SPEEDpx" in pixels per frame, or a name such as "right".
        turn_s: seconds after which it turns back, 0 for never. motion_seed: of the motions shake, random and
        roam. clearance: the least distance of roam to all surfaces, scene units.
        start: x y z, or x y z qx qy qz qw, of T_world_camera at its start; unset parts are those of the scene's camera.

    objects: what moves in the scene, by name: {"bunny": "spin:90"}. A path is "KIND:SPEED", with KIND one of spin,
        orbit (degrees per second), slide and swing (scene units per second); or a file of poses, or poses, as of
        trajectory, but of T_world_object: where the centre of the box around it lies, and how it has turned.
        "own" moves it as the scene says, which is so without it; "still" stops it.
    animation: the name of an animation of a glTF scene, from Client.scenes(), that plays alone. Without it, that of
        motion.toml plays, or all that do not move the same.

    The camera:
    size: width and height in pixels. It is needed, but with a calibration.
    fov_x_deg: horizontal field of view in degrees, without the distortion. Or intrinsics: fx, fy, cx, cy in pixels,
        where the centre of the top left pixel is (0, 0).
    distortion: of the lens, ("radtan", (k1, k2, p1, p2)), with k3 or not, or ("equidistant", (k1, k2, k3, k4)).
    calibration: gives size, intrinsics, distortion and T_body_camera: a saccade.Camera, or the path of a file that
        saccade.read_calibration() reads. Of a camchain it is cam0.
    T_body_camera: the place of the camera on the body that follows the trajectory and carries the IMU, in scene units:
        a matrix (4, 4), or x y z, or x y z qx qy qz qw. It takes points from the camera's axes to the body's.
    further_views: more cameras on the same body: the place of each, likewise, in the axes of the first. Each has
        sensors of its own, which are numbered after those of the camera before, and the truth channels.

    rate_hz: frames per second of stream time, each of which is rendered once. Without it the picture is rendered whenever
        it has moved by interval_px, by default 1 pixel, but not more often per second than max_rate_hz, by default 1000.
        Truth and poses then come at 100 Hz. Pixels that change in between are rendered down to finest_px of motion, by
        default a sixteenth. With interval_px, rate_hz is the rate of truth, poses and Stream.step(), and the least one.
        "lockstep", motions in pixels per frame, budgets and truth of flow need a rate_hz.
    duration_s: stream time; without it, or with 0, the stream goes on until it is closed.
    clock: "fast" renders as fast as it can, "paced" keeps to the wall clock times speed, "lockstep" renders a frame
        for each Stream.step().
    steerable: Stream.steer() may be called; with "lockstep" it always may.
    until_path_ends: instead of duration_s, the stream ends with the last pose of a `trajectory` of the client.
    packet_per_frame: each frame ends its packet; with "lockstep" it always does.
    delivery: "lossless" waits for a slow client, "live" drops and counts, "broadcast" loses and shows the gap.
    codec: "none", or "zstd", which needs the module zstandard.

    Sensors: a sequence stands for one sensor per item, and a single number for all of them.
    threshold, threshold_off: contrast threshold of ON and OFF events, natural log units. With a preset, one alone gives
        the other in the proportion of the preset's.
    bias: scene luminance. refractory_s: seconds. cutoff_hz: Hz. seed: of the stream.
    start_level: "random" starts each pixel between its thresholds, "zero" at its reference, as ESIM and v2e do.
    max_events_per_pixel_frame, max_events_per_frame: further events are withheld and counted.
    labels: Events.source and Events.artefact tell where each event comes from.
    object_ids: Events.object tells which object the pixel of each event shows; id_names of the stream names them.
    max_artefact_odds: events with higher odds to be an error of rendering are withheld and counted.
    preset: the sensor of a known camera, by name. noise: amounts by name, such as {"leak_hz": 0.1}, of all sensors.

    truth: a truth channel, or a list of them: each a name of Client.info().truth, or a pair of it and n for every n-th
    frame. Stream.samples() gives their samples.
    Of the channel imu: imu_rate_hz, 200 by default. metres_per_unit: of the scene, 1 by default. gravity: x y z in
    m/s^2 in world axes, (0, -9.81, 0) by default; (0, 0, -9.81) where z is up. imu_noise: amounts by name, 0 by
    default, as Kalibr's imu.yaml has them: accelerometer_noise (m/s^2/sqrt(Hz)), gyroscope_noise (rad/s/sqrt(Hz)),
    accelerometer_walk (m/s^3/sqrt(Hz)), gyroscope_walk (rad/s^2/sqrt(Hz)).

    Rendering: method, spp, params (by name), bounces, jitter, monochrome, bake_error, disable (scene features), or a
    budget instead: budget_ms, max_false_rate; or max_event_change, a share from 0 to 1.
    """

    scene: str
    pushed: bool
    trajectory: str | os.PathLike[str] | NDArray[np.float64]
    motion: str
    turn_s: float
    motion_seed: int
    clearance: float
    start: Sequence[float]
    objects: Mapping[str, str | os.PathLike[str] | NDArray[np.float64]]
    animation: str
    rate_hz: float
    interval_px: float
    max_rate_hz: float
    finest_px: float
    duration_s: float
    size: tuple[int, int]
    fov_x_deg: float
    intrinsics: tuple[float, float, float, float]
    distortion: tuple[Literal["radtan", "equidistant"], Sequence[float]]
    calibration: str | os.PathLike[str] | Camera
    T_body_camera: Place
    further_views: Sequence[Place]
    clock: Literal["fast", "paced", "lockstep"]
    speed: float
    steerable: bool
    packet_per_frame: bool
    until_path_ends: bool
    delivery: Literal["lossless", "live", "broadcast"]
    codec: Literal["none", "zstd"]
    seed: int
    threshold: PerSensor
    threshold_off: PerSensor
    bias: PerSensor
    refractory_s: PerSensor
    cutoff_hz: PerSensor
    model: Literal["accumulating", "probabilistic", "stochastic"]
    start_level: Literal["random", "zero"]
    reconstruction: Literal["direct", "complementary", "kalman"]
    max_events_per_pixel_frame: int
    max_events_per_frame: int
    labels: bool
    object_ids: bool
    max_artefact_odds: float
    preset: str
    noise: Mapping[str, float]
    truth: str | Sequence[str | tuple[str, int]]
    imu_rate_hz: float
    metres_per_unit: float
    gravity: Sequence[float]
    imu_noise: Mapping[str, float]
    method: str
    spp: int
    params: Mapping[str, float]
    bounces: int
    jitter: bool
    monochrome: bool
    bake_error: float
    disable: Sequence[str]
    budget_ms: float
    max_false_rate: float
    max_event_change: float
