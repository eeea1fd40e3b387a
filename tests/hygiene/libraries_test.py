"""A program loads OpenImageIO, and all that it brings, with its first picture: libraries_test.py PROGRAM..."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAMS = sys.argv[1:]
MODULE = "libsaccade_pictures.so"


def libraries(program):
    """The shared libraries that are loaded when the program starts."""
    listed = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    return [line.split()[0] for line in listed.splitlines()]


class Libraries(unittest.TestCase):
    def test_programs_start_without_those_of_pictures(self):
        for program in PROGRAMS:
            found = libraries(program)
            self.assertTrue(any("libprotobuf" in name for name in found), found)
            self.assertFalse([n for n in found if "OpenImageIO" in n or "opencv" in n or "pictures" in n], program)
            self.assertLess(len(found), 70, program)

    def test_a_farm_has_no_sockets(self):
        self.assertFalse([n for n in libraries(PROGRAMS[2]) if "zmq" in n or "microhttpd" in n])

    def test_a_program_without_its_module_names_it(self):
        with tempfile.TemporaryDirectory() as folder:
            program = shutil.copy(PROGRAMS[0], folder)
            frames = [pathlib.Path(folder, f"{i}.png") for i in range(2)]
            for frame in frames:
                frame.touch()
            run = subprocess.run([program, "events", *frames, "--rate", "1", "-o", f"{folder}/a.csv"],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, f"not loaded: .*/{MODULE}: cannot open")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
