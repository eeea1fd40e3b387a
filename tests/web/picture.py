"""Makes deploy/viewer.webp: the viewer with cornell-turntable, before a camera that stands.

Usage: picture.py SACCADED [SECONDS [WIDTH HEIGHT dark|light FILE [FRAGMENT]]]. Takes the picture after SECONDS."""
import base64
import pathlib
import sys
import time

import chromium
from viewed_server import ViewedServer

OUT = pathlib.Path(__file__).resolve().parents[2] / "deploy/viewer.webp"
SHOWN = "scene=cornell-turntable&motion=still&size=240x180&rate=500&speed=0.00390625"
seconds, width, height, theme, file, fragment = (sys.argv[2:] + ["10", "1120", "780", "dark", OUT, SHOWN][len(sys.argv) - 2:])

browser, server = chromium.start(int(width), int(height)), ViewedServer(sys.argv[1], "--threads", "2")
try:
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": theme}]})
    browser.get(server.url + "#" + fragment)
    time.sleep(float(seconds))
    image = browser.execute_cdp_cmd("Page.captureScreenshot", {"format": "webp", "quality": 75})
    pathlib.Path(file).write_bytes(base64.b64decode(image["data"]))
finally:
    browser.quit()
    server.stop()
