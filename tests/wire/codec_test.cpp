// Encoding and decoding give the same bytes back, and nothing else decodes.
#include <gtest/gtest.h>

#include <random>

#include "saccade/wire/codec_table.h"
#include "saccade/wire/packet_cutter.h"

namespace saccade {
namespace {

class Codec : public testing::TestWithParam<const CodecInfo*> {
 protected:
  PacketCutter cutter() const {
    return PacketCutter({.stream_id = "s", .width = 40, .height = 30, .codec = GetParam()});
  }
};

std::string noise(std::size_t bytes) {
  std::mt19937 random(1);
  std::string text(bytes, 0);
  for (char& c : text) c = static_cast<char>(random());
  return text;
}

TEST_P(Codec, BytesComeBack) {
  for (const std::string& raw :
       {std::string(), std::string(1, 'a'), std::string(1 << 20, 'a'), noise(300'000)}) {
    EXPECT_EQ(GetParam()->decode(GetParam()->encode(raw), raw.size()), raw) << raw.size();
  }
}

TEST_P(Codec, OnlyTheRightSizeComesBack) {
  for (const std::size_t size : {0u, 1u, 999u, 1001u, 1u << 20}) {
    EXPECT_EQ(GetParam()->decode(GetParam()->encode(std::string(1000, 'a')), size), std::nullopt) << size;
  }
}

TEST_P(Codec, ATruncatedPayloadIsNotDecoded) {
  const std::string raw = noise(1000), coded = GetParam()->encode(raw);
  for (std::size_t size = 0; size < coded.size(); size += 37) {
    EXPECT_EQ(GetParam()->decode(coded.substr(0, size), raw.size()), std::nullopt) << size;
  }
}

TEST_P(Codec, EventsComeBackFromTheirPackets) {
  Events events;
  for (int i = 0; i < 50'000; ++i) {
    events.push_back({i * 100 / 1000 * 1000, static_cast<std::uint16_t>(i % 40),
                      static_cast<std::uint16_t>(i % 30), static_cast<std::uint8_t>(i % 2)});
  }
  Events received;
  for (const Packet& packet : cutter().cut(events, {.t0_ns = 0, .t1_ns = 5'000'000})) {
    PacketContent content;
    ASSERT_EQ(packet.header.codec(), GetParam()->id);
    ASSERT_EQ(decodePacket(packet.header, *packet.payload, content), "");
    received.insert(received.end(), content.events.begin(), content.events.end());
  }
  EXPECT_EQ(received, events);
}

TEST_P(Codec, PixelsComeBackFromTheirSnapshot) {
  PixelState pixels;
  for (int i = 0; i < 40 * 30; ++i) {
    pixels.brightness.push_back(0.01f * static_cast<float>(i)), pixels.reference.push_back(-1.f / (i + 1.f));
  }
  const Packet packet = cutter().snapshot(7000, 3, encodePlanes(pixels));
  PacketContent content;
  ASSERT_EQ(decodePacket(packet.header, *packet.payload, content), "");
  EXPECT_EQ(content.pixels, pixels);
}

INSTANTIATE_TEST_SUITE_P(, Codec, testing::ValuesIn(codecTable()),
                         [](const auto& row) { return std::string(row.param->name); });

TEST(Zstd, MakesRepetitionShort) {
  EXPECT_LT(kCodecZstd.encode(std::string(100'000, 'a')).size(), 1000u);
}

}  // namespace
}  // namespace saccade
