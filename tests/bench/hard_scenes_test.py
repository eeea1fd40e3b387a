"""The figures of hard scenes are read from tables and texts, and told with what is asked."""
import unittest

import hard_scenes

TABLE = """# cpu="A" size=64x48
scene,method,spp,dL_share,dL_error
room,event_svgf,2,0.2,0.4
room,svgf,2,0.1,0.8
room,irradiance_cache,2,0.25,0.5
room,irradiance_cache,8,0.5,0.4
"""


class Kept:
    """A bench that has measured already."""

    def cell(self, scene, method, spp, column):
        return {"one": 1, "ten": 2}.get(scene, 1) * hard_scenes.cell_of(TABLE, method, spp, column)

    def noise(self, scene, truth):
        return {"night": 0.125, "day": 0.5}[scene] + (0 if truth == "night" else 9)


class HardScenes(unittest.TestCase):
    def value(self, figure):
        return figure[1](Kept())

    def test_reads_a_row_of_a_table(self):
        self.assertEqual(hard_scenes.cell_of(TABLE, "irradiance_cache", 8, "dL_error"), 0.4)
        with self.assertRaisesRegex(ValueError, "svgf@4"):
            hard_scenes.cell_of(TABLE, "svgf", 4, "dL_error")

    def test_reads_the_noise(self):
        self.assertEqual(hard_scenes.noise_of("blocks within 25 %: 9 %\nrelative noise: 0.125\n"), 0.125)

    def test_figures_are_ratios_to_what_they_name(self):
        self.assertEqual(self.value(hard_scenes.share("room")), 0.25)
        self.assertEqual(self.value(hard_scenes.over_svgf("room", "dL_share")), 2.5)
        self.assertEqual(self.value(hard_scenes.over_rivals("room", "dL_error")), 1.25)
        self.assertEqual(self.value(hard_scenes.over_scene("ten", "one", "dL_error")), 2)
        self.assertEqual(self.value(hard_scenes.over_two_paths("room", 8)), 0.8)
        self.assertEqual(self.value(hard_scenes.over_noise("day", "night")), 4)

    def test_tells_where_a_figure_is_short(self):
        self.assertIn("short", hard_scenes.line("a", 0.5, ">=", 0.9))
        self.assertNotIn("short", hard_scenes.line("a", 0.95, ">=", 0.9))
        self.assertIn("short", hard_scenes.line("a", 1.5, "<=", 1.2))


if __name__ == "__main__":
    unittest.main()
