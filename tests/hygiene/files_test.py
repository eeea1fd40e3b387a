"""Every test is built, every source is formatted, and no file names a path of a developer's machine."""
import re
import shutil
import subprocess
import unittest

import house

PRINTS = re.compile(r"\b(f?printf|fputs|puts|cout|cerr) ?[(<]")
MACHINE_FOLDERS = ["home", "Users", "root", "work", "mnt"]
MACHINE_PATH = re.compile(r"(?<![\w.)}])/(?:%s)/\w" % "|".join(MACHINE_FOLDERS))


def clang_format_version():
    return subprocess.check_output(["clang-format", "--version"], text=True) if shutil.which("clang-format") else ""


class Files(unittest.TestCase):
    def test_every_source_is_listed(self):
        lists = {p.parent: house.text(p) for p in house.files({".txt"}) if p.name == "CMakeLists.txt"}
        for path in house.files({".cpp"}):
            names = [(path.relative_to(f).as_posix(), f) for f in path.parents if f in lists]
            names += [("${PROJECT_SOURCE_DIR}/" + path.as_posix(), f) for f in lists]
            listed = any(re.search(rf"(?<![\w/]){re.escape(name)}\b", lists[f]) for name, f in names)
            self.assertTrue(listed, f"{path} stands in no CMakeLists.txt, and so is never built")

    def test_every_test_folder_has_a_list(self):
        folders = {p.parent for p in house.files({".cpp"}) if p.name.endswith("_test.cpp")}
        self.assertTrue(folders)
        for folder in folders:
            self.assertTrue((house.ROOT / folder / "CMakeLists.txt").exists(), folder)

    @unittest.skipUnless(" 14." in clang_format_version(), "clang-format 14 is not installed; others format otherwise")
    def test_sources_are_formatted(self):
        sources = [str(p) for p in house.files(house.SOURCES)]
        check = subprocess.run(["clang-format", "--dry-run", "-Werror", *sources], cwd=house.ROOT,
                               capture_output=True, text=True, check=False)
        unformatted = {line.split(":")[0] for line in check.stderr.splitlines() if ": error:" in line}
        self.assertEqual(unformatted, set(), "run clang-format -i on them")
        self.assertEqual(check.returncode, 0, check.stderr)

    def test_the_client_prints_through_its_console(self):
        """Texts of servers and files have no control characters there."""
        self.assertTrue(PRINTS.search('  std::printf("%s", name)'))
        self.assertFalse(PRINTS.search("  std::snprintf(text, sizeof text)"))
        sources = [p for p in house.files({".cpp"}) if p.parts[0] == "client" and "example" not in p.parts]
        printing = {p.name for p in sources if PRINTS.search(house.text(p))}
        self.assertEqual(printing, {"console.cpp", "progress.cpp"})

    def test_no_path_of_a_developers_machine(self):
        self.assertTrue(MACHINE_PATH.search('open("/' + 'home/me/a.txt")'))
        self.assertFalse(MACHINE_PATH.search("tests/" + "work/a.txt"))
        for path in house.files(house.TEXTS):
            found = MACHINE_PATH.search(house.text(path))
            self.assertFalse(found, f"{path}: {found}")


if __name__ == "__main__":
    unittest.main()
