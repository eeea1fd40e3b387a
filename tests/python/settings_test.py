"""Every setting of a stream, with values of every wrong kind: each answer names the setting, the value and what is valid."""
import fractions
import math
import unittest

import numpy as np

from saccade.protocol.request import make_request, make_sensor_change
from saccade.settings import SensorSettings, Settings

NEEDED = {"scene": "room", "size": (6, 4), "rate_hz": 100, "motion": "pan:5", "truth": "imu"}
NO_NUMBER = ["60", "", math.nan, math.inf, None, True, {}, b"6", 1j, 10**400, object(), np.zeros((2, 2))]
NO_WHOLE = [*NO_NUMBER, 1.5, 2.0, -1, 1 << 64]
NO_COUNT = [*NO_WHOLE, 0]
NO_FLAG = [0, 1, "yes", "", None, [], 1.0]
NO_TEXT = ["", 5, None, True, b"a", ["a"], math.nan]
NO_NAMES = [5, None, "leak_hz", [1], {"": "1"}, {5: 1}, True]
NO_PLACE = [None, 5, "1 2 3", (1, 2), (1, 2, math.nan), np.zeros((4, 4)), -np.eye(4), np.eye(3), (0,) * 7, [["a"] * 4] * 4]
NO_AMOUNTS = [*NO_NAMES, {"leak": 1}]

WRONG = {
    **dict.fromkeys(("interval_px", "max_rate_hz", "finest_px", "turn_s", "clearance", "duration_s", "fov_x_deg",
                     "max_artefact_odds", "bake_error", "budget_ms", "max_false_rate", "max_event_change", "metres_per_unit"), [*NO_NUMBER, [], [1.0]]),
    **dict.fromkeys(("rate_hz", "speed", "imu_rate_hz"), [*NO_NUMBER, 0, -1]),
    **dict.fromkeys(("threshold", "threshold_off", "bias", "refractory_s", "cutoff_hz"),
                    [*NO_NUMBER, [], [0.1, "0.2"], [0.1, None], (math.nan,), [[0.1]]]),
    **dict.fromkeys(("seed", "motion_seed", "bounces"), NO_WHOLE),
    **dict.fromkeys(("spp", "max_events_per_pixel_frame", "max_events_per_frame"), NO_COUNT),
    **dict.fromkeys(("pushed", "steerable", "packet_per_frame", "until_path_ends", "labels", "object_ids",
                     "jitter", "monochrome"),
                    NO_FLAG),
    **dict.fromkeys(("scene", "animation", "motion", "preset", "method"), NO_TEXT),
    **dict.fromkeys(("clock", "delivery", "codec", "model", "start_level", "reconstruction"), [*NO_TEXT, "slow", "unspecified"]),
    "size": [60, (60,), (60.5, 45), "60x45", "60", None, (1, 2, 3), (-60, 45), (0, 5), (math.nan, 1), ("6", "4"), {}],
    "noise": [*NO_AMOUNTS, {"leak_hz": "1"}, {"leak_hz": math.nan}, {"leak_hz": None}],
    "imu_noise": [*NO_AMOUNTS, {"gyroscope_noise": "1"}, {"gyroscope_walk": True}],
    "params": [*NO_NAMES[:5], {"alpha": "1"}, {"alpha": math.inf}],
    "intrinsics": [5, None, "1,2,3,4", (1, 2, 3), (1, 2, 3, "4"), (1, 2, 3, math.nan), (1, 2, 3, 4, 5), [None] * 4],
    "start": [5, None, "1,2,3", (1, 2), (1, 2, math.nan), (0,) * 6, ("0", 0, 0)],
    "gravity": [5, None, "down", (0, 9.81), (0, 0, math.nan), (0, 0, 0, 0), ("0", 0, 0)],
    "distortion": ["radtan", None, 5, ("radtan",), ("radtan", 5), ("radtan", [1, 2]), ("equidistant", [0] * 5),
                   ("thin_prism", [0] * 4), ("radtan", ["a"] * 4), ("radtan", [math.nan] * 4), ([], [])],
    "T_body_camera": NO_PLACE,
    "further_views": [None, 5, "1 2 3", (1, 2, 3), *([place] for place in NO_PLACE)],
    "calibration": [5, None, True, {}, ["cam.yaml"]],
    "trajectory": [5, None, True, [], {}, [[0] * 7], np.zeros((0, 8)), [["a"] * 8], np.full((2, 8), np.nan)],
    "objects": [5, None, True, "bunny", ["bunny"], {5: "spin:90"}, {"": "spin:90"},
                *({"bunny": path} for path in (5, None, "", "spin", "fly:1", "spin:fast", "spin:nan", [], [[0] * 7]))],
    "truth": [5, None, True, "", [5], [None], ("depth", 0), [("depth", 1.5)], [("depth", "2")], [("depth", -1)],
              [("depth", 1, 2)], ("depth", None), [["depth"]], {"depth": 1}],
    "disable": [5, None, "masks", [5], [""], {"masks": 1}],
}


class EverySetting(unittest.TestCase):
    def test_wrong_kinds_are_refused_in_words(self):
        self.assertEqual(WRONG.keys(), Settings.__required_keys__ | Settings.__optional_keys__)
        for name, values in WRONG.items():
            others = {key: value for key, value in NEEDED.items() if not (name == "trajectory" and key == "motion")}
            if name == "calibration":
                others.pop("size")
            for value in values:
                with self.subTest(setting=name, value=value):
                    with self.assertRaisesRegex(ValueError, rf"^{name}[.\w]*: .+ is not .{{5}}") as caught:
                        make_request({**others, name: value})
                    self.assertLess(len(str(caught.exception)), 400)

    def test_wrong_kinds_of_a_change_are_refused_in_words(self):
        wrong = {**{name: WRONG[name] for name in ("threshold", "threshold_off", "bias", "noise")}, "time_s": NO_NUMBER}
        self.assertEqual(wrong.keys(), SensorSettings.__optional_keys__)
        for name, values in wrong.items():
            for value in values:
                with self.subTest(setting=name, value=value), self.assertRaisesRegex(ValueError, f"^{name}.*: .+ is not "):
                    make_sensor_change({name: value})
        with self.assertRaisesRegex(TypeError, "a change of a sensor has no setting 'treshold'; did you mean 'threshold'"):
            make_sensor_change({"treshold": 1})

    def test_numbers_of_other_types_are_taken(self):
        made = make_request({**NEEDED, "rate_hz": np.float32(100), "spp": np.int16(3), "jitter": np.True_,
                             "threshold": np.array([0.25, 0.5]), "bias": fractions.Fraction(1, 4), "seed": (1 << 64) - 1,
                             "size": np.array([6, 4]), "distortion": ["radtan", np.zeros(5)]})
        self.assertEqual((made.timing.frame_rate_hz, made.method.spp, made.quality.jitter, made.seed),
                         (100, 3, True, (1 << 64) - 1))
        self.assertEqual([(sensor.threshold, sensor.bias) for sensor in made.sensors], [(0.25, 0.25), (0.5, 0.25)])

    def test_the_part_at_fault_is_named(self):
        for text, wrong in (("noise.leak_hz: nan is not a finite number", {"noise": {"leak_hz": math.nan}}),
                            ("noise: 'leak' is not one of mismatch, ", {"noise": {"leak": 1}}),
                            ("threshold: '0.2' is not a finite number, or a list", {"threshold": [0.1, "0.2"]}),
                            ("clock: 'slow' is not one of fast, paced, lockstep", {"clock": "slow"}),
                            (r"size: \(60.5, 45\) is not \(width, height\)", {"size": (60.5, 45)}),
                            ("T_body_camera: .* no rotation with a translation", {"T_body_camera": np.zeros((4, 4))})):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                make_request({**NEEDED, **wrong})


if __name__ == "__main__":
    unittest.main()
