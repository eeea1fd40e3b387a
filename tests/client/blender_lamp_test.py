"""The power of area lamps in the add-on of Blender, with the properties that Blender has since 4.5."""
import importlib.util
import pathlib
import sys
import types
import unittest
from unittest import mock

EXPORT = pathlib.Path(__file__).resolve().parents[2] / "client/blender/saccade_export.py"


def load_add_on():
    """Without Blender: its modules are empty."""
    bpy = mock.MagicMock()
    bpy.types.Operator = type("Operator", (), {})
    extras = types.SimpleNamespace(ExportHelper=type("ExportHelper", (), {}))
    modules = {"bpy": bpy, "bpy_extras": mock.MagicMock(), "bpy_extras.io_utils": extras,
               "mathutils": mock.MagicMock(), "numpy": mock.MagicMock()}
    with mock.patch.dict(sys.modules, modules):
        spec = importlib.util.spec_from_file_location("saccade_export", EXPORT)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    return module


class LampPower(unittest.TestCase):
    def power(self, **more):
        lamp = types.SimpleNamespace(energy=100, color=(1, 0.5, 0.25), **more)
        return load_add_on().lamp_power(lamp, area=3)

    def test_is_energy_times_colour_before_4_5(self):
        self.assertEqual(self.power(), [100, 50, 25])

    def test_doubles_with_each_stop_of_exposure(self):
        self.assertEqual(self.power(exposure=2.0), [400, 200, 100])

    def test_takes_the_colour_of_a_temperature_that_is_used(self):
        warm = dict(temperature=2700, temperature_color=(1, 0.5, 0))
        self.assertEqual(self.power(use_temperature=True, **warm), [100, 25, 0])
        self.assertEqual(self.power(use_temperature=False, **warm), [100, 50, 25])

    # Its radiance is then the same for all areas: P / 4.
    def test_grows_with_the_area_where_it_is_not_normalized(self):
        self.assertEqual(self.power(normalize=False), [300, 150, 75])
        self.assertEqual(self.power(normalize=True), [100, 50, 25])


if __name__ == "__main__":
    unittest.main()
