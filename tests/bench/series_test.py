"""The series of speeds reads tables, and sees a loss of 5 %."""
import unittest
import xml.etree.ElementTree as xml

import series

TABLE = """scene            set       one ray   stages    ratio
cornell-box      avx2        140.6     59.4     2.37
cornell-box      avx512      140.6     53.5     2.63
"""


def row(value, cpu="a", figure="paths"):
    return {"cpu": cpu, "figure": figure, "value": str(value)}


class Series(unittest.TestCase):
    def test_reads_a_column_of_a_row(self):
        self.assertEqual(series.column(TABLE, "cornell-box avx512", -1), 2.63)
        with self.assertRaisesRegex(ValueError, "cornell-dragon"):
            series.column(TABLE, "cornell-dragon avx2", -1)

    def test_sees_a_loss_on_the_same_cpu(self):
        before = [row(2.0), row(2.02), row(1.98)]
        self.assertEqual(list(series.losses(before, "a", {"paths": 2.09})), [])
        self.assertIn("6 % worse", next(series.losses(before, "a", {"paths": 2.12})))
        self.assertEqual(list(series.losses(before, "b", {"paths": 9.0})), [])

    def test_compares_with_the_last_runs(self):
        before = [row(1.0)] * 20 + [row(2.0)] * series.KEPT
        self.assertEqual(list(series.losses(before, "a", {"paths": 2.0})), [])

    def test_draws_a_chart_for_each_figure(self):
        drawn = xml.fromstring(series.picture([row(2.0), row(2.2), row(1.0, figure="noise")]))
        self.assertEqual(len(drawn.findall("{*}polyline")), 2)


if __name__ == "__main__":
    unittest.main()
