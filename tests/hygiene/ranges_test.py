"""The schema and PROTOCOL.md give each number the range that proto/saccade/wire/ranges.h gives it."""
import re
import unittest

import house

NUMBER = r"-?[0-9.]+(?:e-?[0-9]+)?"
ROW = re.compile(rf"Range<\w+> k\w+\{{({NUMBER}), ({NUMBER})\}};\s*// ([\w., ]+?):")
IN_WORDS = re.compile(rf"({NUMBER}) to ({NUMBER})")         # 1e-3 to 10
IN_BRACKETS = re.compile(rf"\[({NUMBER}), ({NUMBER})\]")    # [1e-3, 10]


def table():
    """(message, field): (min, max) of every row of ranges.h."""
    rows = ROW.findall(house.text("proto/saccade/wire/ranges.h"))
    return {tuple(name.split(".")): (float(low), float(high)) for low, high, names in rows for name in names.split(", ")}


def ranges_in(pattern, text):
    return [(float(low), float(high)) for low, high in pattern.findall(text)]


def comments_of(schema, message, field):
    """What the schema says of a field: behind it, and in the lines of comment right before it."""
    lines = re.search(rf"^message {message} {{\n(.*?)^}}", schema, re.M | re.S).group(1).splitlines()
    at = next(i for i, line in enumerate(lines) if re.search(rf"\b{field} = \d+;", line.split("//")[0]))
    first = at
    while first > 0 and lines[first - 1].strip().startswith("//"):
        first -= 1
    return " ".join(line.partition("//")[2] for line in lines[first:at + 1])


def rows_of(document, field):
    """The rows of PROTOCOL.md's tables whose first cell names a field."""
    rows = [line for line in document.splitlines() if line.startswith("|")]
    return [row for row in rows if re.search(rf"[`.]{field}`", row.split("|")[1])]


class Ranges(unittest.TestCase):
    def test_the_table_is_read(self):
        lines = [line for line in house.text("proto/saccade/wire/ranges.h").splitlines() if "Range<" in line]
        self.assertEqual(len(lines), len(ROW.findall("\n".join(lines))))
        self.assertEqual(table()["Sensor", "threshold_off"], (1e-3, 10))

    def test_the_schema_says_the_same(self):
        schema = "\n".join(house.text(f"proto/saccade/v1/{name}.proto") for name in ("control", "truth", "noise"))
        for (message, field), valid in table().items():
            if (message, field) in {("View", "height"), ("Motion", "turn_s"), ("Timing", "duration_s")}:
                continue  # said with another field, or in other words
            with self.subTest(field=f"{message}.{field}"):
                self.assertIn(valid, ranges_in(IN_WORDS, comments_of(schema, message, field)))

    def test_the_protocol_page_says_the_same(self):
        document = house.text("proto/PROTOCOL.md")
        said = set()
        for (message, field), valid in table().items():
            for row in rows_of(document, field):
                for found in ranges_in(IN_BRACKETS, row):
                    said.add(field)
                    self.assertEqual(found, valid, row)
        self.assertLessEqual({"threshold", "bias", "refractory_s", "spp", "bounces", "frame_rate_hz"}, said)


if __name__ == "__main__":
    unittest.main()
