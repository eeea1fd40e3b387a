// NumPy's .npz, without compression: arrays t (i64 microseconds), x, y (u16) and p (u8), numbers width and height.

const CRC = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) crc = CRC[(crc ^ byte) & 255] ^ (crc >>> 8);
  return ~crc >>> 0;
}

// An array with its header [numpy.lib.format, version 1.0].
function npy(descr, shape, values) {
  const text = `{'descr': '${descr}', 'fortran_order': False, 'shape': ${shape}, }`;
  const padded = text.padEnd(64 * Math.ceil((text.length + 11) / 64) - 11) + "\n";
  const head = [0x93, ...new TextEncoder().encode("NUMPY"), 1, 0, padded.length & 255, padded.length >> 8];
  const bytes = new Uint8Array(head.length + padded.length + values.byteLength);
  bytes.set(head);
  bytes.set(new TextEncoder().encode(padded), head.length);
  bytes.set(new Uint8Array(values.buffer, values.byteOffset, values.byteLength), head.length + padded.length);
  return bytes;
}

// Numbers of 2 and 4 bytes: [size, value], ...
function record(...numbers) {
  const view = new DataView(new ArrayBuffer(numbers.reduce((sum, [size]) => sum + size, 0)));
  let at = 0;
  for (const [size, value] of numbers) {
    if (size === 2) view.setUint16(at, value, true);
    else view.setUint32(at, value, true);
    at += size;
  }
  return new Uint8Array(view.buffer);
}

// What the local header and the directory say of a file [APPNOTE 4.3.7]; the date is 1 January 1980.
const facts = ({ name, bytes, crc }) => [[2, 20], [2, 0], [2, 0], [2, 0], [2, 33], [4, crc], [4, bytes.length],
  [4, bytes.length], [2, name.length], [2, 0]];

function zip(files) {
  const parts = [], directory = [];
  let at = 0;
  for (const file of files) {
    directory.push(record([4, 0x02014b50], [2, 20], ...facts(file), [2, 0], [2, 0], [2, 0], [4, 0], [4, at]), file.name);
    parts.push(record([4, 0x04034b50], ...facts(file)), file.name, file.bytes);
    at += 30 + file.name.length + file.bytes.length;
  }
  const size = directory.reduce((sum, part) => sum + part.length, 0);
  const end = record([4, 0x06054b50], [2, 0], [2, 0], [2, files.length], [2, files.length], [4, size], [4, at], [2, 0]);
  return [...parts, ...directory, end];
}

export function npzFile({ count, t, x, y, p, width, height }) {
  const whole = (value) => BigInt64Array.of(BigInt(value));
  const arrays = { t: npy("<i8", `(${count},)`, BigInt64Array.from(t, BigInt)), x: npy("<u2", `(${count},)`, x),
    y: npy("<u2", `(${count},)`, y), p: npy("|u1", `(${count},)`, p), width: npy("<i8", "()", whole(width)),
    height: npy("<i8", "()", whole(height)) };
  return zip(Object.entries(arrays).map(([name, bytes]) => ({ name: `${name}.npy`, bytes, crc: crc32(bytes) })));
}
