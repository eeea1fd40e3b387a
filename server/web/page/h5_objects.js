// The parts of an HDF5 file of version 0: groups of at most 8 members, and arrays in one piece. The numbers are those of
// the HDF5 File Format Specification, version 1.

const LEAF_K = 4, NODE_K = 16; // half of the members of a node of names, and of a tree
const UNDEFINED = 0xffffffffffffffffn;
const SUPERBLOCK_BYTES = 96;

const encode = (text) => [...new TextEncoder().encode(text)];
const bytesOf = (size, value) => Array.from({ length: size }, (_, i) => Number((BigInt(value) >> BigInt(8 * i)) & 255n));
const u16 = (value) => bytesOf(2, value);
const u32 = (value) => bytesOf(4, value);
const u64 = (value) => bytesOf(8, value);
const padded = (bytes, size = 8 * Math.ceil(bytes.length / 8)) => [...bytes, ...Array(size - bytes.length).fill(0)];

const message = (type, data) => [...u16(type), ...u16(padded(data).length), 0, 0, 0, 0, ...padded(data)];
const objectHeader = (...messages) =>
  [1, 0, ...u16(messages.length), ...u32(1), ...u32(messages.flat().length), ...u32(0), ...messages.flat()];

const dataspace = (sizes) => [1, sizes.length, 0, 0, ...u32(0), ...sizes.flatMap(u64)];
const whole = (bytes, signed = false) => [0x10, signed ? 8 : 0, 0, 0, ...u32(bytes), ...u16(0), ...u16(8 * bytes)];
const attribute = (name, value) => [1, 0, ...u16(name.length + 1), ...u16(12), ...u16(8), ...padded([...encode(name), 0]),
  ...padded(whole(8, true)), ...dataspace([]), ...u64(value)];

export class H5File {
  constructor() {
    this.pieces = [new Uint8Array(SUPERBLOCK_BYTES)];
    this.at = SUPERBLOCK_BYTES;
  }

  // Returns the address of the bytes.
  put(bytes) {
    const address = this.at;
    const piece = new Uint8Array(8 * Math.ceil(bytes.length / 8));
    piece.set(bytes);
    this.pieces.push(piece);
    this.at += piece.length;
    return address;
  }

  // Returns the address of an object: an array of whole numbers without a sign, or one number.
  array(values) {
    return this.dataset(values, [values.length], whole(values.BYTES_PER_ELEMENT));
  }

  number(value) {
    return this.dataset(BigInt64Array.of(BigInt(value)), [], whole(8, true));
  }

  dataset(values, sizes, type) {
    const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
    const data = bytes.length ? this.put(bytes) : UNDEFINED;
    return this.put(objectHeader(message(0x1, dataspace(sizes)), message(0x3, type), message(0x5, [2, 1, 0, 0]),
      message(0x8, [3, 1, ...u64(data), ...u64(bytes.length)])));
  }

  // `members`: addresses by name; `attributes`: whole numbers by name.
  group(members, attributes = {}) {
    const names = Object.keys(members).sort();
    const offsets = [];
    const heap = [...u64(0)]; // the empty name
    for (const name of names) {
      offsets.push(heap.length);
      heap.push(...padded([...encode(name), 0]));
    }
    const entries = names.flatMap((name, i) => [...u64(offsets[i]), ...u64(members[name]), ...u64(0), ...u64(0), ...u64(0)]);
    const node = this.put(padded([...encode("SNOD"), 1, 0, ...u16(names.length), ...entries], 8 + 2 * LEAF_K * 40));
    const tree = this.put(padded([...encode("TREE"), 0, 0, ...u16(1), ...u64(UNDEFINED), ...u64(UNDEFINED), ...u64(0),
      ...u64(node), ...u64(offsets.at(-1))], 24 + 8 * (4 * NODE_K + 1)));
    const text = this.put(heap);
    const local = this.put([...encode("HEAP"), 0, 0, 0, 0, ...u64(heap.length), ...u64(1), ...u64(text)]);
    const said = Object.entries(attributes).map(([name, value]) => message(0xc, attribute(name, value)));
    return this.put(objectHeader(message(0x11, [...u64(tree), ...u64(local)]), ...said));
  }

  // The parts of a Blob.
  parts(root) {
    this.pieces[0].set([0x89, ...encode("HDF"), 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 0, 0, 8, 8, 0, ...u16(LEAF_K), ...u16(NODE_K),
      ...u32(0), ...u64(0), ...u64(UNDEFINED), ...u64(this.at), ...u64(UNDEFINED), ...u64(0), ...u64(root)]);
    return this.pieces;
  }
}
