// Prints the messages of truth that @mcap/core finds in a file by its index, by topic, as JSON: read_truth_mcap.cjs FILE.
const fs = require("fs");
const { McapIndexedReader } = require("@mcap/core");
const { parse } = require("@foxglove/rosmsg");
const { MessageReader } = require("@foxglove/rosmsg2-serialization");

const xyz = (v) => [v.x, v.y, v.z];

// In the order of the channel's planes.
function numbers(message) {
  if (message.pose) return [...xyz(message.pose.position), ...xyz(message.pose.orientation), message.pose.orientation.w];
  if (message.twist) return [...xyz(message.twist.linear), ...xyz(message.twist.angular)];
  if (message.angular_velocity) return [...xyz(message.linear_acceleration), ...xyz(message.angular_velocity)];
  return undefined;
}

function contentOf(message) {
  const { height, width, encoding, step, data } = message;
  const stamp_us = message.header.stamp.sec * 1e6 + message.header.stamp.nanosec / 1e3;
  const { distortion_model, d, k, r, p } = message;
  const camera = d && { distortion_model, d: [...d], k: [...k], r: [...r], p: [...p] };
  return { camera, stamp_us, numbers: numbers(message), height, width, encoding, step,
           events: message.events && Buffer.from(message.events).toString("base64"),
           data: data && Buffer.from(data.buffer, data.byteOffset, data.byteLength).toString("hex") };
}

async function main() {
  const bytes = new Uint8Array(fs.readFileSync(process.argv[2]));
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
  };
  const file = await McapIndexedReader.Initialize({ readable });
  const messages = {}, counts = {};
  for (const channel of file.channelsById.values()) {
    messages[channel.topic] = [];
    counts[channel.topic] = Number(file.statistics.channelMessageCounts.get(channel.id));
  }
  for await (const message of file.readMessages({ validateCrcs: true })) {
    const channel = file.channelsById.get(message.channelId);
    const schema = file.schemasById.get(channel.schemaId);
    const reader = new MessageReader(parse(new TextDecoder().decode(schema.data), { ros2: true }));
    messages[channel.topic].push({ ...contentOf(reader.readMessage(message.data)), log_us: Number(message.logTime) / 1e3 });
  }
  process.stdout.write(JSON.stringify({ messages, counts }));
}

main();
