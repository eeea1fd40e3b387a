"""README.md shows what is there."""
import re
import unittest

import house

README = house.text("README.md")


class Readme(unittest.TestCase):
    def test_links_lead_somewhere(self):
        targets = [t for t in re.findall(r"\]\(([^)#]+)\)", README) if "://" not in t]
        self.assertTrue(targets)
        for target in targets:
            self.assertTrue((house.ROOT / target).exists(), target)

    def test_names_every_library_the_build_looks_for(self):
        for library in re.findall(r"find_package\((\w+)", house.text("CMakeLists.txt")):
            if library != "Threads":
                self.assertIn(library.lower(), README.lower())


if __name__ == "__main__":
    unittest.main()
