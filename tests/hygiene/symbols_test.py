"""Code for a wider instruction set defines only what no other code may call: else the linker could choose its
version of an inline function for all, and the program would fail on a processor without these instructions.

symbols_test.py OBJECT...: object files; those named *avx512* are read."""
import re
import subprocess
import sys
import unittest

OWN = re.compile(r"Avx512|<16>|<16,|, 16>|_VecBltnBtmsk<64>|^DW\.ref\.")
OBJECTS = [path for path in sys.argv[1:] if "avx512" in path]


class Symbols(unittest.TestCase):
    def test_objects_are_given(self):
        self.assertTrue(OBJECTS, "no object file of a wider instruction set is among the arguments")

    def test_wide_code_defines_nothing_that_others_use(self):
        for path in OBJECTS:
            lines = subprocess.run(["nm", "-C", "--defined-only", "--extern-only", path], check=True,
                                   capture_output=True, text=True).stdout.splitlines()
            names = [line.split(maxsplit=2)[2] for line in lines if line]
            self.assertTrue(names, path)
            self.assertEqual([name for name in names if not OWN.search(name)], [], path)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
