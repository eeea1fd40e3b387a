"""client/API.md is what client/api_page makes of the headers and docstrings."""
import subprocess
import unittest

import house


class Api(unittest.TestCase):
    def test_the_page_is_up_to_date(self):
        made = subprocess.run([house.ROOT / "client/api_page", "--check"], capture_output=True, text=True)
        self.assertEqual((made.returncode, made.stderr), (0, ""))

    def test_the_page_shows_both_libraries(self):
        page = house.text("client/API.md")
        for name in ["class Subscription {", "class ControlClient {", "### connect", "### Events", "decodePacket("]:
            self.assertIn(name, page)
        self.assertNotIn("private:", page)


if __name__ == "__main__":
    unittest.main()
