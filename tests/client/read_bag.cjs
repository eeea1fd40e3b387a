// Prints the messages that @foxglove/rosbag finds in a bag, as JSON: read_bag.cjs FILE.
const { Bag } = require("@foxglove/rosbag");
const { FileReader } = require("@foxglove/rosbag/node");
const { parse } = require("@foxglove/rosmsg");
const { MessageReader } = require("@foxglove/rosmsg-serialization");

const us = (time) => time.sec * 1e6 + time.nsec / 1e3;

async function main() {
  const bag = new Bag(new FileReader(process.argv[2]));
  await bag.open();
  const [connection] = bag.connections.values();
  const reader = new MessageReader(parse(connection.messageDefinition));
  const messages = [];
  await bag.readMessages({}, ({ topic, timestamp, data }) => {
    const { events, header } = reader.readMessage(data);
    messages.push({ topic, time_us: us(timestamp), stamp_us: us(header.stamp),
                    events: events.map((e) => [us(e.ts), e.x, e.y, Number(e.polarity)]) });
  });
  process.stdout.write(JSON.stringify({ md5sum: connection.md5sum, type: connection.type, messages }));
}

main();
