// The page's reader of packets, on the packets that all readers are tested with. It leaves to others what it would
// have to look at events for.
import assert from "node:assert";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { Kind, fieldsOf, readPacket } from "../../server/web/page/packet.js";

const folder = new URL("../wire/data/", import.meta.url);
const names = readdirSync(folder).filter((name) => name.endsWith(".bin"));
const NAMES = { t0_ns: "t0Ns", t1_ns: "t1Ns", first_event_index: "firstEventIndex", dt_unit_ns: "dtUnitNs",
  dropped_before: "droppedBefore", end_reason: "endReason", lag_ms: "lagMs" };
const REFUSED = new Set(["bad_layout", "bad_size", "bad_zstd", "bad_zstd_size", "zstd"]); // it takes no compressed events

function vector(name) {
  const bytes = readFileSync(new URL(name, folder));
  return { buffer: bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length),
    meaning: JSON.parse(readFileSync(new URL(name.replace(".bin", ".json"), folder))) };
}

// The events as [t_ns, x, y, p], from the offsets that the page gives to the GPU.
function eventsOf({ payload, count, t0Ns, dtUnitNs }) {
  const view = new DataView(payload.buffer, payload.byteOffset, payload.byteLength);
  return Array.from({ length: count }, (_, i) => [t0Ns + view.getUint32(4 * i, true) * dtUnitNs,
    view.getUint16(4 * count + 2 * i, true), view.getUint16(6 * count + 2 * i, true), view.getUint8(8 * count + i)]);
}

test("vectors are there", () => assert.ok(names.length >= 17));

for (const file of names) {
  const name = file.replace(".bin", "");
  const { buffer, meaning } = vector(file);
  if (REFUSED.has(name)) {
    test(`${name} is refused`, () => assert.throws(() => readPacket(buffer), RangeError));
    continue;
  }
  test(`${name} is read`, () => {
    const packet = readPacket(buffer);
    for (const [field, value] of Object.entries(meaning.header))
      if (field !== "crc32") assert.strictEqual(packet[NAMES[field] ?? field], value, field);
    if (meaning.valid && packet.kind === Kind.EVENTS) assert.deepStrictEqual(eventsOf(packet), meaning.events_t_ns_x_y_p);
  });
}

test("every cut of a packet is read or refused", () => {
  const { buffer } = vector("three_events.bin");
  for (let size = 0; size < buffer.byteLength; ++size) assert.throws(() => readPacket(buffer.slice(0, size)), RangeError);
});

test("numbers of all sizes", () => {
  assert.strictEqual(fieldsOf(Uint8Array.of(0x08, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x0f)).get(1), 2 ** 53 - 1);
  assert.strictEqual(fieldsOf(Uint8Array.of(0x11, 1, 0, 0, 0, 0, 0, 0, 0x80)).get(2), 2n ** 63n + 1n);
  assert.throws(() => fieldsOf(new Uint8Array(12).fill(0xff)), RangeError);
  assert.throws(() => fieldsOf(Uint8Array.of(0x0b)), RangeError); // a group
});
