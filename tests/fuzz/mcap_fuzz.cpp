#include "client/formats/aedat4/compression.h"
#include "client/formats/common/reader.h"
#include "client/formats/ros/cdr.h"
#include "client/formats/ros/event_packet.h"
#include "client/formats/ros/mcap_record.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/memory_file.h"

namespace saccade {
namespace {

const client::ReaderInfo& kMcapReader = client::readerFor("a.mcap");

using namespace client;
using namespace std::string_literals;

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);

std::string packet() {
  CdrMessage message;
  message.number<std::int32_t>(0), message.number<std::uint32_t>(4097000);
  message.text("cam");
  message.number<std::uint32_t>(3), message.number<std::uint32_t>(4);
  message.number<std::uint64_t>(0), message.number<std::uint64_t>(0);
  message.text("evt3");
  message.number<std::uint8_t>(0);
  message.octets("\1\x80\1\x60\2\0\1\x28\2\x20"s);  // TIME_HIGH, TIME_LOW, row, two events
  return message.bytes();
}

std::string recordsOf() {
  McapFields schema, channel, message;
  schema.number<std::uint16_t>(1).sized(kEventPacket2).sized("ros2msg").sized("");
  channel.number<std::uint16_t>(1).number<std::uint16_t>(1).sized("/e").sized("cdr").sized("");
  message.number<std::uint16_t>(1).number<std::uint32_t>(0).number<std::uint64_t>(1).number<std::uint64_t>(1);
  std::string records = mcapRecord(McapOp::kSchema, schema) + mcapRecord(McapOp::kChannel, channel);
  appendRecord(records, McapOp::kMessage, {message.bytes(), packet()});
  return records;
}

std::string seed(const std::string& compression, bool finished) {
  std::string content = recordsOf(), chunk = content;
  if (compression == "lz4") {
    chunk.clear();
    aedat4::Compressor(aedat4::Compression::kLz4).append(chunk, content);
  }
  McapFields head;
  head.number<std::uint64_t>(1).number<std::uint64_t>(1).number<std::uint64_t>(content.size());
  head.number<std::uint32_t>(0).sized(compression).number<std::uint64_t>(chunk.size());
  std::string bytes(kMagic);
  appendRecord(bytes, McapOp::kChunk, {head.bytes(), chunk});
  if (!finished) return bytes;
  const McapFields footer =
      McapFields().number<std::uint64_t>(0).number<std::uint64_t>(0).number<std::uint32_t>(0);
  return bytes + mcapRecord(McapOp::kDataEnd, McapFields().number<std::uint32_t>(0)) +
         mcapRecord(McapOp::kFooter, footer) + std::string(kMagic);
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {seed("", false), seed("", true), seed("lz4", true), std::string(kMagic) + recordsOf()},
      {"cdr", "evt3", "lz4", "zstd", "\xff\xff\xff\xff", "\0\0\0\0"s, std::string(8, '\xff'), "\1\x80"s,
       "\xff\x37"s, "\xff\x4f"s, "\x04\x22\x4d\x18", "\x28\xb5\x2f\xfd", "\5"s, "\6"s},
      [](std::string_view bytes) {
        const MemoryFile file(bytes);
        return accepts<FileFault>([&] {
          const auto reader = kMcapReader.make(file.path());
          reader->size(), reader->leftOut();
          for (Events events; reader->read(events);) SACCADE_CHECK(events.size() <= 12 << 15);
        });
      },
      nullptr,
      20000};
  return target;
}

}  // namespace saccade
