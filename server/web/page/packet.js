// Reads the packets of a stream: u32 header size | PacketHeader | payload. The schema is events.proto.

export const Kind = { EVENTS: 1, HEARTBEAT: 2, END: 3, ERROR: 4, SNAPSHOT: 5 };
export const EndReason = { 1: "finished", 2: "closed", 3: "abandoned", 4: "the server stops" };

const EVENT_BYTES = 9; // of LAYOUT_COLUMNS: u32 dt | u16 x | u16 y | u8 p
const MAX_EVENTS = 32768;
const LAYOUT_COLUMNS = 1;
const CODEC_NONE = 1;

// The fields of a protobuf message by number: numbers, BigInt for 64 fixed bits, Uint8Array for bytes and texts.
// A number beyond 2^53 loses its last bits. Throws RangeError for bytes that are no message.
export function fieldsOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const fields = new Map();
  let at = 0;
  const varint = () => {
    let value = 0;
    for (let scale = 1; scale < 2 ** 70; scale *= 128) {
      const byte = view.getUint8(at++);
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
    throw new RangeError("a varint of more than 10 bytes");
  };
  const skip = (size) => {
    if (at + size > bytes.length) throw new RangeError("a field ends after its message");
    at += size;
    return at - size;
  };
  const read = {
    0: varint,
    1: () => view.getBigUint64(skip(8), true),
    2: () => {
      const size = varint();
      return bytes.subarray(skip(size), at);
    },
    5: () => view.getUint32(skip(4), true),
  };
  while (at < bytes.length) {
    const key = varint();
    const reader = read[key % 8];
    if (!reader) throw new RangeError("unknown wire type " + (key % 8));
    fields.set(Math.floor(key / 8), reader());
  }
  return fields;
}

const unzigzag = (n) => (n % 2 ? -(n + 1) / 2 : n / 2);
const text = (bytes) => new TextDecoder().decode(bytes);

// A packet with its payload, which stays where it is. Throws RangeError for one that cannot be drawn. The CRC and the
// events are not checked: TCP keeps them whole, and no event is read outside of the GPU.
export function readPacket(buffer) {
  const size = new DataView(buffer).getUint32(0, true);
  if (4 + size > buffer.byteLength) throw new RangeError("the header is longer than its frame");
  const fields = fieldsOf(new Uint8Array(buffer, 4, size));
  const number = (field) => fields.get(field) ?? 0;
  const packet = {
    streamId: text(fields.get(1) ?? new Uint8Array()),
    sensor: number(3),
    seq: number(4),
    firstEventIndex: number(5),
    t0Ns: unzigzag(number(6)),
    t1Ns: unzigzag(number(7)),
    count: number(8),
    dtUnitNs: number(9),
    layout: number(10),
    codec: number(11),
    droppedBefore: number(13),
    suppressed: number(14),
    kind: number(15),
    width: number(16),
    height: number(17),
    frame: number(18),
    endReason: number(19),
    lagMs: number(20),
    payload: new Uint8Array(buffer, 4 + size),
  };
  if (packet.kind === Kind.EVENTS) checkColumns(packet);
  return packet;
}

function checkColumns(packet) {
  if (packet.layout !== LAYOUT_COLUMNS || packet.codec !== CODEC_NONE)
    throw new RangeError("events are not in plain columns");
  if (packet.count > MAX_EVENTS || packet.payload.length !== EVENT_BYTES * packet.count)
    throw new RangeError("the payload has another size than its events");
}

export const messageOf = (packet) => text(packet.payload); // of KIND_ERROR
