// What the page offers, says and sends.
import assert from "node:assert";
import { test } from "node:test";

globalThis.document = { getElementById: () => ({ addEventListener() {} }) };
globalThis.addEventListener = () => {};
const { velocityOf } = await import("../../server/web/page/look_round.js");
const { lighterSetting, noticeOf } = await import("../../server/web/page/notice.js");
const { recordLineOf } = await import("../../server/web/page/record_line.js");
const { DEFAULTS, fromFragment, openStreamOf, withFirstScene, withScene } = await import("../../server/web/page/settings.js");
const { openingText } = await import("../../server/web/page/texts.js");

test("the command has each setting that changes events", () => {
  const settings = { ...DEFAULTS, scene: "cornell-box", motion: "shake", px: 0.3, size: "64x48", rate: 500, C: 0.15, bias: 0.01, duration: 2 };
  assert.strictEqual(recordLineOf(settings, 9), "saccade record cornell-box --motion shake:0.3px --size 64x48 --rate 500 " +
    "--duration 2 --threshold 0.15 --bias 0.01 -o events.h5");
  const preset = recordLineOf({ ...settings, scene: "it's one", motion: "right", preset: "davis346", duration: 0 }, 3.21049);
  assert.ok(preset.startsWith("saccade record 'it'\\''s one' --motion right "), preset);
  assert.ok(preset.includes("--duration 3.212 --preset davis346 --bias"), preset); // 1606 frames of 2 ms
});

test("frames have intervals that follow the motion, in the stream and in the command", () => {
  const { frameRateHz, intervalPx } = openStreamOf({ ...DEFAULTS, rate: 0 }).timing;
  assert.deepStrictEqual([frameRateHz, intervalPx], [100, 1]);
  const line = recordLineOf({ ...DEFAULTS, scene: "box", rate: 0 }, 3.21049);
  assert.ok(line.includes(" --min-rate 100 --duration 3.22 "), line); // 322 frames of 10 ms
  const whole = openStreamOf(fromFragment("#rate=500")).timing;
  assert.deepStrictEqual([whole.frameRateHz, whole.intervalPx], [500, undefined]);
});

test("the first scene is one that moves, before a camera that stands, and no other stands with its camera", () => {
  const trajectories = ["right", "still"];
  const box = { name: "box", trajectories, objects: [{ name: "block", motion: "" }] };
  const table = { name: "table", trajectories, objects: [{ name: "disc", motion: "spin:60" }] };
  const scenes = [box, table], first = withFirstScene(DEFAULTS, scenes);
  assert.deepStrictEqual([first.scene, first.motion], ["table", "still"]);
  assert.strictEqual(withFirstScene({ ...DEFAULTS, motion: "orbit" }, scenes).motion, "orbit");
  assert.deepStrictEqual(withFirstScene(DEFAULTS, [box]), { ...DEFAULTS, scene: "box" });
  assert.strictEqual(withFirstScene(DEFAULTS, []).scene, "");
  assert.deepStrictEqual(withScene({ ...first, object: "disc" }, scenes, "box"), { ...DEFAULTS, scene: "box" });
  assert.strictEqual(withScene({ ...first, motion: "right" }, scenes, "box").motion, "right");
  assert.strictEqual(withScene({ ...first, motion: "arc" }, scenes, "table").motion, DEFAULTS.motion);
});

test("an object moves as the page says, in the stream and in the command", () => {
  const settings = { ...DEFAULTS, scene: "cornell-bunny", object: "bunny", path: "spin:-45" };
  assert.deepStrictEqual(openStreamOf(settings).objects,
    [{ name: "bunny", path: { motion: { kind: "OBJECT_MOTION_KIND_SPIN", speed: -45 } } }]);
  assert.deepStrictEqual(openStreamOf({ ...settings, path: "still" }).objects, [{ name: "bunny", path: { still: {} } }]);
  assert.strictEqual(openStreamOf(DEFAULTS).objects, undefined);
  assert.ok(recordLineOf({ ...settings, duration: 1 }, 0).includes(" --object 'bunny=spin:-45' "));
  assert.strictEqual(fromFragment("#object=bunny&path=spin:90").path, "spin:90");
  assert.strictEqual(fromFragment("#object=bunny&path=fly").path, DEFAULTS.path);
});

test("an animation of the scene plays alone, in the stream and in the command", () => {
  const fox = { name: "fox", animations: ["Run", "Walk fast"] };
  const settings = { ...DEFAULTS, scene: "fox", animation: "Walk fast" };
  assert.strictEqual(openStreamOf(settings).animation, "Walk fast");
  assert.ok(!("animation" in openStreamOf(DEFAULTS)));
  assert.ok(recordLineOf({ ...settings, duration: 1 }, 0).includes(" --animation 'Walk fast' "));
  assert.strictEqual(withScene(settings, [fox], "fox").animation, "Walk fast");
  assert.strictEqual(withScene(settings, [fox, { name: "box" }], "box").animation, "");
});

test("a page may be slowed down, and its own stream can be steered", () => {
  const { timing } = openStreamOf({ ...DEFAULTS, look: 1 });
  assert.deepStrictEqual([timing.minSpeed, timing.steerable], [1 / 256, true]);
  assert.strictEqual(openStreamOf(DEFAULTS).timing.steerable, false);
  assert.strictEqual(openStreamOf({ ...DEFAULTS, speed: 0.002 }).timing.minSpeed, 0.002);
});

test("what would keep the pace is a smaller picture, or a lower frame rate", () => {
  assert.deepStrictEqual(lighterSetting({ size: "160x120", rate: 200 }, 0.5), { size: "64x48" });
  assert.deepStrictEqual(lighterSetting({ size: "346x260", rate: 200 }, 0.5), { size: "240x180" });
  assert.deepStrictEqual(lighterSetting({ size: "64x48", rate: 200 }, 0.5), { rate: 100 });
  assert.strictEqual(lighterSetting({ size: "64x48", rate: 25 }, 0.5), null);
});

test("a notice says why playback is slow, and nothing where all is well", () => {
  const settings = { ...DEFAULTS, speed: 0.25 };
  assert.strictEqual(noticeOf(settings, 0.25, 0), null);
  assert.strictEqual(noticeOf(settings, null, 0), null); // a broadcast, or nothing yet
  const slow = noticeOf(settings, 1 / 16, 0);
  assert.ok(slow.text.startsWith("Playback is 1/16 of real time:"), slow.text);
  assert.deepStrictEqual(slow.offer, { size: "64x48" });
  const late = noticeOf(settings, 0.25, 3200);
  assert.ok(late.text.includes("3.2 s behind"), late.text);
  assert.deepStrictEqual(late.offer, { speed: 0.125 });
});

test("an opening says what it waits for", () => {
  assert.strictEqual(openingText("a", { doing: "loading the scene", done: 0.4 }, 2.04), "Opening a: loading the scene (40 %), 2.0 s");
  assert.strictEqual(openingText("a", undefined, 0), "Opening a: asking, 0.0 s");
});

// Camera axes: x right, y down, z forward. About y, z turns towards x.
test("keys and the pointer give velocities of stream time", () => {
  const { linear, angular } = velocityOf(new Set(["w", "a", "ArrowUp"]), { x: 0, y: 0 }, { walk: 2, speed: 0.25, rate: 200 });
  assert.deepStrictEqual(linear, { x: -8, y: 0, z: 8 });
  assert.deepStrictEqual([angular.x > 0, angular.y], [true, 0]);
  const pulled = velocityOf(new Set(), { x: 0.5, y: 0.5 }, { walk: 2, speed: 1, rate: 200 }).angular;
  assert.deepStrictEqual([pulled.y > 0, pulled.x < 0], [true, true]);
  const slow = velocityOf(new Set(["d"]), { x: 0, y: 0 }, { walk: 2, speed: 0.01, rate: 200 }).linear; // 2 frames a second
  assert.strictEqual(slow.x / 200, 2 / 20); // of each of them
});
