// Prints what @mcap/core finds in a file, as JSON: read_mcap.cjs FILE [BEGIN_NS END_NS]. Messages are read by the
// index, and once more from the front to the end without it.
const fs = require("fs");
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");
const { parse } = require("@foxglove/rosmsg");
const { MessageReader } = require("@foxglove/rosmsg2-serialization");

function decode(message, reader) {
  const packet = reader.readMessage(message.data);
  return { ...packet, events: Buffer.from(packet.events).toString("base64"), sequence: message.sequence,
           log_ns: message.logTime, publish_ns: message.publishTime };
}

function readerOf(schema) {
  return new MessageReader(parse(new TextDecoder().decode(schema.data), { ros2: true }));
}

function streamed(bytes) {
  const reader = new McapStreamReader({ validateCrcs: true });
  const schemas = new Map(), messages = [], kinds = [];
  reader.append(bytes);
  for (let record; (record = reader.nextRecord());) {
    kinds.push(record.type);
    if (record.type === "Schema") schemas.set(record.id, readerOf(record));
    if (record.type === "Message") messages.push(decode(record, schemas.get(1)));
  }
  return { messages, kinds, done: reader.done() };
}

async function indexed(bytes, args) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
  };
  const file = await McapIndexedReader.Initialize({ readable });
  const messages = [];
  for await (const message of file.readMessages({ ...args, validateCrcs: true })) {
    const channel = file.channelsById.get(message.channelId);
    messages.push(decode(message, readerOf(file.schemasById.get(channel.schemaId))));
  }
  const channels = [...file.channelsById.values()].map((c) => ({ ...c, metadata: Object.fromEntries(c.metadata) }));
  const schemas = [...file.schemasById.values()].map(({ name, encoding }) => ({ name, encoding }));
  const { channelMessageCounts, ...statistics } = file.statistics;
  const groups = [...file.summaryOffsetsByOpcode.values()].map((offset) => ({
    op: offset.groupOpcode, opThere: bytes[Number(offset.groupStart)], begin: offset.groupStart,
    end: offset.groupStart + offset.groupLength }));
  return { messages, channels, schemas, statistics, counts: [...channelMessageCounts], profile: file.header.profile,
           chunks: file.chunkIndexes.length, groups };
}

async function main() {
  const [path, begin, end] = process.argv.slice(2);
  const bytes = new Uint8Array(fs.readFileSync(path));
  const args = begin ? { startTime: BigInt(begin), endTime: BigInt(end) } : {};
  const found = { indexed: await indexed(bytes, args), streamed: streamed(bytes) };
  process.stdout.write(JSON.stringify(found, (_, value) => (typeof value === "bigint" ? Number(value) : value)));
}

main();
