// Packets written by make_golden.py from values computed by hand: what any client may rely on.
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "saccade/wire/packet.h"

namespace saccade {
namespace {

std::string readFile(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

google::protobuf::Struct readMeaning(const std::filesystem::path& path) {
  google::protobuf::Struct meaning;
  EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(readFile(path), &meaning).ok()) << path;
  return meaning;
}

Events eventsOf(const google::protobuf::Value& list) {
  Events events;
  for (const auto& row : list.list_value().values()) {
    const auto at = [&](int i) { return row.list_value().values(i).number_value(); };
    events.push_back({static_cast<std::int64_t>(at(0)), static_cast<std::uint16_t>(at(1)),
                      static_cast<std::uint16_t>(at(2)), static_cast<std::uint8_t>(at(3))});
  }
  return events;
}

PixelState pixelsOf(const google::protobuf::Value& list) {
  PixelState pixels;
  for (const auto& row : list.list_value().values()) {
    const auto at = [&](int i) { return static_cast<float>(row.list_value().values(i).number_value()); };
    pixels.brightness.push_back(at(0));
    pixels.reference.push_back(at(1));
  }
  return pixels;
}

v1::PacketHeader headerOf(const google::protobuf::Value& fields) {
  std::string json;
  v1::PacketHeader header;
  EXPECT_TRUE(google::protobuf::util::MessageToJsonString(fields, &json).ok());
  EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(json, &header).ok()) << json;
  header.set_stream_id("golden");
  header.set_epoch(7);
  return header;
}

void checkVector(const std::filesystem::path& path) {
  SCOPED_TRACE(path.filename());
  const auto meaning = readMeaning(std::filesystem::path(path).replace_extension(".json")).fields();
  const std::string data = readFile(path);
  std::uint32_t size;
  ASSERT_GE(data.size(), sizeof(size));
  std::memcpy(&size, data.data(), sizeof(size));
  v1::PacketHeader header, expected = headerOf(meaning.at("header"));
  ASSERT_TRUE(header.ParseFromString(data.substr(4, size)));
  if (expected.crc32() == 0) expected.set_crc32(header.crc32());
  EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(header, expected));
  PacketContent content;
  const std::string fault = decodePacket(header, data.substr(4 + size), content);
  EXPECT_EQ(fault.empty(), meaning.at("valid").bool_value()) << fault;
  if (fault.empty()) {
    EXPECT_EQ(content.events, eventsOf(meaning.at("events_t_ns_x_y_p")));
    EXPECT_EQ(content.pixels, pixelsOf(meaning.at("pixels")));
  }
}

TEST(GoldenPackets, AreReadAsWritten) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SACCADE_SOURCE_DIR "/tests/wire/data")) {
    if (entry.path().extension() != ".bin") continue;
    checkVector(entry.path());
    ++count;
  }
  EXPECT_GE(count, 17);
}

}  // namespace
}  // namespace saccade
