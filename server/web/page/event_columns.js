// The events of packets, in columns for files.

const BYTES = 9; // of an event in a packet: u32 dt | u16 x | u16 y | u8 p

// t: whole microseconds of the stream.
export function columnsOf(packets) {
  const count = packets.reduce((sum, packet) => sum + packet.count, 0);
  const pixels = () => new Uint16Array(count);
  const columns = { count, t: new Float64Array(count), x: pixels(), y: pixels(), p: new Uint8Array(count) };
  let at = 0;
  for (const packet of packets) {
    append(columns, at, packet);
    at += packet.count;
  }
  return columns;
}

function append({ t, x, y, p }, at, { payload, count, t0Ns, dtUnitNs }) {
  const { buffer } = payload.slice(0, BYTES * count); // a payload may begin at an odd byte
  new Uint32Array(buffer, 0, count).forEach((dt, i) => (t[at + i] = Math.floor((t0Ns + dt * dtUnitNs) / 1000)));
  x.set(new Uint16Array(buffer, 4 * count, count), at);
  y.set(new Uint16Array(buffer, 6 * count, count), at);
  p.set(new Uint8Array(buffer, 8 * count, count), at);
}
