"""The pages name what is there: links, flags, rooms and libraries."""
import re
import unittest

import house
import includes_test
import prose

LINK = re.compile(r"\]\(([^)\s]+)\)")
FLAG = re.compile(r"(?<![\w-])--[a-z][a-z-]+[a-z]")
FLAGS_OF_OTHERS = {"--build", "--component", "--from-file", "--install", "--no-build-isolation", "--no-deps", "--no-index", "--now", "--prefix", "--preset", "--python", "--ros-args", "--runtime", "--system-site-packages", "--tests"}  # cmake, kubectl, pip, protoc, ros2, systemctl, scripts


def anchors(page):
    """The anchors of a page's headings, as GitHub makes them."""
    titles = re.findall(r"^#+ +(.+)$", prose.without_code(house.text(page)), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def fault(page, target):
    """What is wrong with a link on this page, or None."""
    path, _, anchor = target.partition("#")
    file = (house.ROOT / page).parent / path if path else house.ROOT / page
    if not file.exists():
        return f"{page}: {target} leads nowhere"
    if anchor and anchor not in anchors(file.relative_to(house.ROOT) if not path else file):
        return f"{page}: {target} names no heading"
    return None


class Pages(unittest.TestCase):
    def test_the_rule_itself(self):
        self.assertIsNone(fault("README.md", "proto/PROTOCOL.md#limits"))
        self.assertIsNotNone(fault("README.md", "proto/PROTOCOL.md#no-such-heading"))
        self.assertIsNotNone(fault("README.md", "no/such/file.md"))

    def test_links_lead_somewhere(self):
        links = [(page, target) for page in prose.pages() for target in LINK.findall(house.text(page))]
        faults = [fault(page, target) for page, target in links if "://" not in target]
        self.assertTrue(faults)
        self.assertEqual([f for f in faults if f], [])

    def test_flags_exist(self):
        sources = "\n".join(house.text(p) for p in house.files({".cpp", ".h"}) if p.parts[0] in {"server", "client"})
        limits = house.text("server/app/admission/limits.h")
        known = FLAGS_OF_OTHERS | set(FLAG.findall(sources)) | {"--limit-" + name for name in re.findall(r'"([a-z-]+)"', limits)}
        told = {flag for page in prose.pages() for flag in FLAG.findall(house.text(page))}
        self.assertGreater(len(told), 30)
        self.assertEqual(told - known, set())

    def test_the_first_page_fits_on_two_screens(self):
        self.assertLessEqual(len(house.text("README.md").splitlines()), 110)

    def test_the_contributors_page_shows_the_rooms_as_they_are_checked(self):
        rows = re.findall(r"^\| \[([\w/]+)\]\([^)]*\) \|.*\| ?([^|]*?) \|$", house.text("server/README.md"), re.MULTILINE)
        told = {room.strip("/"): set(includes.split(", ")) for room, includes in rows}
        for room, includes in includes_test.ROOMS.items():
            if room not in {"wire", "app", "farm", "eval"}:  # told in words
                self.assertEqual(told[room], set(includes.split() or [""]), room)

    def test_the_contributors_page_names_every_library_the_build_looks_for(self):
        for library in re.findall(r"find_package\((\w+)", house.text("CMakeLists.txt")):
            if library != "Threads":
                self.assertIn(library.lower(), house.text("server/README.md").lower())


if __name__ == "__main__":
    unittest.main()
