// What the page computes: its link, its counts, and what it skips.
import assert from "node:assert";
import { test } from "node:test";
import { DrawQueue } from "../../server/web/page/draw_queue.js";
import { Meters } from "../../server/web/page/meters.js";
import { Kind } from "../../server/web/page/packet.js";
import { DEFAULTS, fromFragment, openStreamOf, toFragment } from "../../server/web/page/settings.js";

const packet = (seq, options = {}) => ({ kind: Kind.EVENTS, seq, count: 100, suppressed: 0, lagMs: 0,
  t0Ns: seq * 5e6, t1Ns: (seq + 1) * 5e6, ...options });

test("a link holds what is not a default", () => {
  const settings = { ...DEFAULTS, scene: "cornell box&", preset: "imx636", C: 0.15, decay: 0, colours: "white-black" };
  assert.deepStrictEqual(fromFragment(toFragment(settings)), settings);
  assert.strictEqual(toFragment({ ...DEFAULTS, scene: "a" }), "#scene=a");
});

test("a link that is wrong has defaults", () => {
  assert.deepStrictEqual(fromFragment("#C=x&bias=&size=9&rate=Infinity&nothing=1&__proto__=2"), DEFAULTS);
});

test("a request says a kind of motion, or the name of a trajectory", () => {
  assert.deepStrictEqual(openStreamOf({ ...DEFAULTS, motion: "shake", px: 0.3 }).trajectory,
    { motion: { kind: "MOTION_KIND_SHAKE", pxPerFrame: 0.3 } });
  assert.deepStrictEqual(openStreamOf({ ...DEFAULTS, motion: "right" }).trajectory, { name: "right" });
  assert.deepStrictEqual(openStreamOf({ ...DEFAULTS, size: "64x48" }).view, { width: 64, height: 48 });
});

test("a preset takes the place of the threshold", () => {
  assert.deepStrictEqual(openStreamOf({ ...DEFAULTS, C: 0.3, bias: 0.1 }).sensors, [{ threshold: 0.3, bias: 0.1 }]);
  assert.deepStrictEqual(openStreamOf({ ...DEFAULTS, C: 0.3, bias: 0.1, preset: "davis346" }).sensors,
    [{ preset: "davis346", bias: 0.1 }]);
});

test("a gap of seq is lost, wherever the stream was joined", () => {
  const meters = new Meters();
  for (const seq of [7, 8, 11, 12]) meters.take(packet(seq), 0);
  meters.take({ kind: Kind.HEARTBEAT, seq: 0, count: 0, lagMs: 0 }, 0);
  meters.take(packet(14, { suppressed: 5 }), 0);
  assert.deepStrictEqual([meters.lost, meters.withheld, meters.events], [3, 5, 500]);
});

test("rates are of stream time and of the wall, delays against the earliest packet", () => {
  const meters = new Meters();
  meters.reset(0.5); // a packet of 5 ms takes 10 ms
  for (let seq = 0; seq < 100; ++seq) meters.take(packet(seq), 1000 + 10 * seq + (seq % 2 ? 6 : 0));
  const { rate, received, delayMs } = meters.read(2000);
  assert.ok(Math.abs(rate - 20000) < 1);
  assert.strictEqual(received, 5000); // of two seconds, one of which had none
  assert.ok(Math.abs(delayMs - 3) < 0.1);
});

test("a slow page skips the oldest, and gets faster or slower", () => {
  let skipped = 0;
  const queue = new DrawQueue((events) => (skipped += events));
  const fill = (count) => { for (let seq = 0; seq < 10; ++seq) queue.add(packet(seq, { count })); };
  fill(30000);
  assert.strictEqual(queue.take(0).length, 10);
  fill(30000);
  const drawn = queue.take(100); // a picture took 100 ms
  assert.deepStrictEqual(drawn.map(({ seq }) => seq), [3, 4, 5, 6, 7, 8, 9]);
  assert.strictEqual(skipped, 90000);
  const budget = queue.budget;
  fill(30000);
  queue.take(116);
  assert.ok(queue.budget > budget);
});

test("a hidden page keeps a bounded number of events", () => {
  let skipped = 0;
  const queue = new DrawQueue((events) => (skipped += events));
  for (let seq = 0; seq < 1000; ++seq) queue.add(packet(seq, { count: 32768 }));
  assert.ok(queue.events <= 1.5e6);
  assert.strictEqual(queue.events + skipped, 1000 * 32768);
});
