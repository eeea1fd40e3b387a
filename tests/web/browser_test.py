"""The page in a real browser: what it draws and records, against what `saccade record` writes for the same request.

Usage: browser_test.py SACCADED SACCADE. Exit code 77: the browser, or a module, is absent."""
import base64
import csv
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from collections import Counter

import chromium
from selenium.webdriver.support.ui import WebDriverWait
from viewed_server import Page, ViewedServer

SACCADED, SACCADE = sys.argv[1], sys.argv[2]
PATIENCE_S = 60
TINY = "scene=cornell-box&motion=right&size=32x24&rate=500&C=0.1&speed=1"


def recorded(server, *options):
    """Events of `saccade record` by (x, y, p)."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "events.csv"
        subprocess.run([SACCADE, "record", "cornell-box", "--control", server.control, "--trajectory", "right", "--size",
                        "32x24", "--rate", "500", *options, "-o", str(file)], check=True, capture_output=True)
        with file.open() as rows:
            return Counter((int(row["x"]), int(row["y"]), int(row["p"])) for row in csv.DictReader(rows))


def rows_of(file):
    """Events of a CSV as (t, x, y, p)."""
    with file.open() as rows:
        next(rows)  # the heading
        return [tuple(map(int, row)) for row in csv.reader(rows)]


def plain(value):
    """JSON of a message: with names as in the schema, numbers as such, and without what has its default."""
    if isinstance(value, dict):
        named = {re.sub("[A-Z]", lambda c: "_" + c[0].lower(), key): plain(one) for key, one in value.items()}
        return {key: one for key, one in named.items() if one}
    if isinstance(value, list):
        return [plain(one) for one in value]
    return float(value) if re.fullmatch(r"-?\d+(\.\d+)?", str(value)) else value


# Gives the command, and the files of the recording by their ending.
SAVED = """
const done = arguments[0], { recorder, form } = saccade;
Promise.all(["record_line", "file_formats"].map((name) => import(`/${name}.js`))).then(async ([line, { FILE_FORMATS }]) => {
  const files = {};
  for (const [ending, write] of Object.entries(FILE_FORMATS)) {
    const bytes = new Uint8Array(await new Blob(write(recorder.recording())).arrayBuffer());
    files[ending] = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  }
  done([line.recordLineOf(form.settings, recorder.span[1]), recorder.span, files]);
});
"""


class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = chromium.start()
        cls.server = ViewedServer(SACCADED)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        assert cls.server.stop() == 0

    def open(self, fragment):
        self.browser.get("about:blank")
        self.browser.get(self.server.url + "#" + fragment)

    def run_js(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def wait_for(self, script):
        return WebDriverWait(self.browser, PATIENCE_S, 0.05).until(lambda _: self.run_js("return " + script))

    def state(self):
        return self.run_js("return document.getElementById('state').textContent")

    def tearDown(self):
        severe = [entry["message"] for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]
        self.assertEqual(severe, [])  # such as a break of the Content-Security-Policy

    def drawn(self):
        """Events on the GPU by (x, y, p), where nothing decays."""
        self.assertEqual(self.run_js("return saccade.meters.lost + saccade.meters.notDrawn"), 0)
        sums, width = self.run_js("return [Array.from(saccade.view.sumsOf()), saccade.view.width]")
        hits = Counter()
        for pixel in range(len(sums) // 4):
            hits[pixel % width, pixel // width, 1] = sums[4 * pixel]
            hits[pixel % width, pixel // width, 0] = sums[4 * pixel + 1]
        return +hits

    def test_it_draws_each_event_where_it_is(self):
        expected = recorded(self.server, "--threshold", "0.1", "--duration", "0.1")
        self.open(TINY + "&decay=0&duration=0.1")
        self.wait_for("document.getElementById('state').textContent.includes('finished')")
        self.wait_for("saccade.view.nowNs === 1e8")  # all is drawn
        self.assertGreater(sum(expected.values()), 1000)
        self.assertEqual(self.drawn(), expected)

    def test_brightness_and_its_change_are_shown(self):
        self.open(TINY)
        self.wait_for("document.getElementById('brightness').width === 32")
        colours = "new Set(new Uint32Array(document.getElementById(arguments[0]).getContext('2d').getImageData(0, 0, 32, 24)"\
                  ".data.buffer)).size"
        for picture in ("frame", "brightness", "change"):
            self.assertGreater(self.run_js("return " + colours, picture), 10)

    def test_a_slider_opens_another_stream_and_closes_the_old_one(self):
        self.open(TINY)
        first = self.wait_for("saccade.meters.events > 0 && saccade.watch.stream.id")
        self.run_js("const c = document.forms[0].C; c.value = Math.log(0.4); c.dispatchEvent(new Event('input', {bubbles: true}))")
        self.wait_for("saccade.watch.stream?.resolved?.sensors[0].threshold === 0.4 && saccade.meters.events > 0")
        self.assertIn("C=0.4", self.browser.current_url)
        page = Page(self.server)
        WebDriverWait(self.browser, 10, 0.05).until(lambda _: first not in page.streams())
        page.socket.close()

    def test_a_preset_is_a_sensor_of_the_same_feed(self):
        self.open(TINY)
        feed = self.wait_for("saccade.meters.events > 0 && saccade.watch.stream.feed")
        self.assertIn("davis346", self.run_js("return [...document.forms[0].preset.options].map(({value}) => value)"))
        self.run_js("const p = document.forms[0].preset; p.value = 'davis346';"
                    "p.dispatchEvent(new Event('input', {bubbles: true}))")
        sensor = self.wait_for("saccade.watch.stream?.resolved?.sensors[0].preset === 'davis346' && saccade.meters.events > 0"
                               " && saccade.watch.stream.resolved.sensors[0]")
        self.assertAlmostEqual(sensor["thresholdOff"], 0.2029)
        self.assertGreater(sensor["noise"]["leakHz"], 0)
        self.assertEqual(self.run_js("return saccade.watch.stream.feed"), feed)
        self.assertTrue(self.run_js("return document.forms[0].C.parentElement.hidden"))
        self.assertIn("preset=davis346", self.browser.current_url)

    def key(self, kind, key):
        self.run_js("document.body.dispatchEvent(new KeyboardEvent(...arguments))", kind, {"key": key, "bubbles": True})

    def test_it_records_the_events_that_its_command_gives(self):
        for rate in ("rate=500", "rate=0"):  # 0: with intervals that follow the motion
            with self.subTest(rate):
                self.check_recording(TINY.replace("rate=500", rate))

    def check_recording(self, fragment):
        self.open(fragment)
        self.wait_for("saccade.meters.events > 0")
        self.run_js("document.getElementById('record').click()")
        self.wait_for("saccade.recorder.events > 1000")
        self.run_js("document.getElementById('record').click()")
        self.assertEqual(len(self.run_js("return [...document.querySelectorAll('#files button')]")), 4)
        line, (begin, end), files = self.browser.execute_async_script(SAVED)
        request = self.run_js("return saccade.watch.stream.resolved")
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            words = shlex.split(line)
            self.assertEqual(words[0], "saccade")
            words[words.index("-o") + 1] = str(folder / "all.csv")
            subprocess.run([SACCADE, *words[1:], "--control", self.server.control], check=True, capture_output=True)
            kept = [row for row in rows_of(folder / "all.csv") if begin * 1e6 <= row[0] < end * 1e6]
            said, asked = plain(json.loads((folder / "all.csv.json").read_text())["request"]), plain(request)
            self.assertEqual(said["timing"].pop("frame_rate_hz"), asked["timing"].pop("frame_rate_hz"))
            for of_the_events in ("interval_px", "max_rate_hz", "refinement"):
                self.assertEqual(said["timing"].get(of_the_events), asked["timing"].get(of_the_events))
            for of_the_clock in ("timing", "delivery"):
                said.pop(of_the_clock, None), asked.pop(of_the_clock, None)
            self.assertEqual(said, asked)
            self.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(folder)})
            self.run_js("document.querySelector('#files button').click()")
            saved = folder / "cornell-box-32x24.csv"
            WebDriverWait(self.browser, 20, 0.05).until(lambda _: saved.exists())
            self.assertEqual(saved.read_bytes(), base64.b64decode(files["csv"]))
            for ending, text in files.items():
                file, table = folder / f"page.{ending}", folder / f"{ending}.csv"
                file.write_bytes(base64.b64decode(text))
                if ending == "csv":
                    table = file
                else:
                    subprocess.run([SACCADE, "convert", str(file), str(table)], check=True, capture_output=True)
                self.assertEqual(rows_of(table), kept, ending)

    def test_a_camera_of_ones_own_stands_until_a_key_turns_it(self):
        self.open(TINY)
        self.wait_for("saccade.meters.events > 0")
        self.run_js("document.getElementById('look').click()")
        self.wait_for("saccade.watch.stream?.resolved?.timing.steerable && saccade.meters.read(performance.now()).rate === 0")
        before = self.run_js("return saccade.meters.events")
        self.key("keydown", "ArrowRight")
        self.wait_for(f"saccade.meters.events > {before} + 100")
        self.key("keyup", "ArrowRight")
        self.wait_for("saccade.meters.read(performance.now()).rate === 0")
        self.assertIn("look=1", self.browser.current_url)
        self.assertTrue(self.run_js("return document.getElementById('line').disabled"))

    def test_a_click_enlarges_a_picture_and_another_makes_it_small(self):
        self.open(TINY)
        self.wait_for("document.getElementById('frame').width === 32")
        large = "return document.querySelector('.large canvas')?.id"
        self.run_js("document.getElementById('frame').click()")
        self.assertEqual(self.run_js(large), "frame")
        self.run_js("document.getElementById('frame').click()")
        self.assertIsNone(self.run_js(large))

    def test_motions_are_listed_once_and_what_a_refractory_period_withholds_is_normal(self):
        self.open(TINY + "&preset=davis346")
        self.wait_for("saccade.meters.events > 0")
        motions = self.run_js("return [...document.forms[0].motion.options].map(({value}) => value)")
        self.assertEqual(len(motions), len(set(motions)))
        self.assertIn("right", motions)
        self.run_js("saccade.meters.withheld += 7")
        self.wait_for("document.getElementById('m-withheld').textContent !== '0'")
        self.assertFalse(self.run_js("return document.getElementById('m-withheld').classList.contains('bad')"))

    def test_it_watches_a_broadcast_of_others(self):
        page = Page(self.server)
        stream = page.open("DELIVERY_BROADCAST")
        self.open("stream=" + stream["streamId"])
        self.wait_for("saccade.meters.events > 1000")
        self.assertEqual(self.state(), "Live")
        self.assertEqual(self.run_js("return document.forms[0].source.value"), "stream:" + stream["streamId"])
        page.socket.close()

    def test_it_comes_back_with_the_server(self):
        first = ViewedServer(SACCADED)
        self.browser.get(first.url + "#" + TINY)
        self.wait_for("saccade.meters.events > 0")
        self.assertEqual(first.stop(), 0)
        self.wait_for("document.getElementById('state').textContent.includes('No server')")
        second = ViewedServer(SACCADED, http=first.http)
        self.wait_for("document.getElementById('state').textContent === 'Live'")
        self.browser.get("about:blank")
        self.browser.get_log("browser")  # of connections that were refused
        self.assertEqual(second.stop(), 0)

    def test_a_refusal_is_told(self):
        self.open("scene=no-such-scene")
        self.wait_for("document.getElementById('state').className === 'fault'")
        self.assertIn("no-such-scene", self.state())

    def test_the_keyboard_pauses_and_changes_colours(self):
        self.open(TINY)
        self.wait_for("saccade.meters.events > 0")
        for key in (" ", "c"):
            self.run_js("document.body.dispatchEvent(new KeyboardEvent('keydown', {key: arguments[0], bubbles: true}))", key)
        self.assertEqual(self.run_js("return document.getElementById('pause').getAttribute('aria-pressed')"), "true")
        self.assertIn("colours=yellow-violet", self.browser.current_url)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
