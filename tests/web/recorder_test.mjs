// The page's recorder and the files that it writes, on packets with a shape of their own.
import assert from "node:assert";
import { test } from "node:test";
import { FILE_FORMATS } from "../../server/web/page/file_formats.js";
import { MOST_BYTES, Recorder } from "../../server/web/page/recorder.js";

// Events [dt in us, x, y, p] in the columns of a packet, whose payload begins at an odd byte.
function packet(seq, events, t0Ns = 0) {
  const count = events.length, payload = new Uint8Array(9 * count + 1).subarray(1);
  const view = new DataView(payload.buffer, payload.byteOffset);
  events.forEach(([dt, x, y, p], i) => {
    view.setUint32(4 * i, dt, true);
    view.setUint16(4 * count + 2 * i, x, true);
    view.setUint16(6 * count + 2 * i, y, true);
    view.setUint8(8 * count + i, p);
  });
  return { seq, count, t0Ns, t1Ns: t0Ns + 5e6, dtUnitNs: 1000, width: 160, height: 120, payload };
}

function recorded(...packets) {
  const recorder = new Recorder();
  recorder.start();
  packets.forEach((one) => recorder.add(one));
  recorder.stop();
  return recorder;
}

const bytesOf = async (parts) => new Uint8Array(await new Blob(parts).arrayBuffer());

test("events become whole microseconds of the stream, in columns", () => {
  const { t, x, y, p, count } = recorded(packet(0, [[1, 2, 3, 1]], 5e6), packet(1, [[0, 159, 119, 0], [4999, 0, 0, 1]], 10e6)).recording();
  assert.deepStrictEqual([count, [...t], [...x], [...y], [...p]], [3, [5001, 10000, 14999], [2, 159, 0], [3, 119, 0], [1, 0, 1]]);
});

test("nothing is kept before Record and after Stop, and losses are counted", () => {
  const recorder = new Recorder();
  recorder.add(packet(0, [[0, 0, 0, 0]]));
  recorder.start();
  recorder.add(packet(3, [[0, 0, 0, 0]]));
  recorder.add(packet(7, [[0, 0, 0, 0]]));
  recorder.stop();
  recorder.add(packet(8, [[0, 0, 0, 0]]));
  assert.deepStrictEqual([recorder.events, recorder.lost, recorder.running], [2, 3, false]);
});

test("what is kept is bounded", () => {
  const recorder = new Recorder();
  recorder.start();
  const large = { ...packet(0, []), payload: new Uint8Array(9 * 32768), count: 32768 };
  for (let seq = 0; recorder.running; ++seq) recorder.add({ ...large, seq });
  assert.ok(recorder.bytes <= MOST_BYTES && recorder.full);
});

test("a CSV has the heading of saccade", async () => {
  const text = new TextDecoder().decode(await bytesOf(FILE_FORMATS.csv(recorded(packet(0, [[7, 2, 3, 1], [9, 4, 5, 0]])).recording())));
  assert.strictEqual(text, "t,x,y,p\n7,2,3,1\n9,4,5,0\n");
});

// docs.prophesee.ai, "EVT 2.0 Format"
test("EVT2 has a word for the upper bits of the time, and one for an event", async () => {
  const bytes = await bytesOf(FILE_FORMATS.raw(recorded(packet(0, [[1, 2, 3, 1], [64 * 5 + 2, 1, 1, 0]])).recording()));
  const begin = new TextDecoder().decode(bytes).indexOf("% end\n") + 6;
  const words = [...new Uint32Array(bytes.slice(begin).buffer)];
  assert.deepStrictEqual(words, [0x80000000, 0x10401003, 0x80000005, 0x00800801]);
});

test("the time of EVT2 wraps where its 34 bits end", async () => {
  const recording = { ...recorded(packet(0, [[0, 0, 0, 0]])).recording(), t: Float64Array.of(2 ** 34 + 64) };
  const bytes = await bytesOf(FILE_FORMATS.raw(recording));
  const words = [...new Uint32Array(bytes.slice(-20).buffer)];
  assert.deepStrictEqual(words, [0x80000000, 0x8fffffff, 0x80000000, 0x80000001, 0]);
});
