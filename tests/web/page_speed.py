"""Prints how many events per second the viewer's page draws in this machine's Chromium, without a server's work.

Usage: page_speed.py SACCADED. Packets are made in the page, for 346 x 260 pixels, at 30 pictures per second."""
import sys

import chromium
from viewed_server import ViewedServer

# Draws a second of events at each rate; returns rate and pictures per second. Reading a pixel waits for the GPU.
MEASURE = """
const [rates] = arguments, { view } = saccade, PICTURES = 30, PACKETS = 7;
view.resize(346, 260);
view.decayS = 0.03;
const packet = (count) => {
  const payload = new Uint8Array(9 * count), columns = new DataView(payload.buffer);
  for (let i = 0; i < count; ++i) {
    columns.setUint32(4 * i, Math.floor((5000 * i) / count), true);
    columns.setUint16(4 * count + 2 * i, Math.random() * 346, true);
    columns.setUint16(6 * count + 2 * i, Math.random() * 260, true);
    payload[8 * count + i] = Math.random() < 0.5;
  }
  return { payload, count, t0Ns: 0, t1Ns: 5e6, dtUnitNs: 1000 };
};
const colours = { none: [0, 0, 0], on: [1, 0, 0], off: [0, 0, 1] }, pixel = new Uint8Array(4);
return rates.map((rate) => {
  const packets = Array(PACKETS).fill(packet(Math.round(rate / PICTURES / PACKETS)));
  const begin = performance.now();
  for (let picture = 0; picture < PICTURES; ++picture) {
    view.add(packets);
    view.show(colours);
    view.gl.readPixels(0, 0, 1, 1, view.gl.RGBA, view.gl.UNSIGNED_BYTE, pixel);
  }
  return [rate, (1000 * PICTURES) / (performance.now() - begin)];
});
"""

browser, server = chromium.start(), ViewedServer(sys.argv[1])
try:
    browser.set_script_timeout(120)
    browser.get(server.url + "#scene=none")
    browser.execute_script(MEASURE, [1e5])  # the programs of the GPU are compiled now
    for rate, pictures in browser.execute_script(MEASURE, [1e5, 1e6, 2e6, 5e6, 1e7]):
        print(f"{rate / 1e6:5.1f} million events/s: {pictures:6.1f} pictures/s")
finally:
    browser.quit()
    server.stop()
