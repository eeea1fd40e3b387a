#include "saccade/wire/packet.h"

#include <gtest/gtest.h>

#include <set>

#include "saccade/wire/codec_table.h"

namespace saccade {
namespace {

v1::PacketHeader eventsHeader() {
  v1::PacketHeader header;
  header.set_kind(v1::KIND_EVENTS);
  header.set_layout(v1::LAYOUT_COLUMNS);
  header.set_codec(v1::CODEC_NONE);
  header.set_dt_unit_ns(1000);
  header.set_t1_ns(1000);
  return header;
}

// The check value that the definition of CRC-32/ISO-HDLC gives for these nine digits.
TEST(Packet, Crc32IsThatOfZlib) {
  EXPECT_EQ(crc32Of("123456789"), 0xcbf43926u);
  EXPECT_EQ(crc32Of({}), 0u);
}

TEST(Packet, CheckSaysWhatIsWrong) {
  auto kind = eventsHeader(), layout = eventsHeader(), codec = eventsHeader(), count = eventsHeader(),
       unit = eventsHeader(), crc = eventsHeader();
  kind.set_kind(static_cast<v1::Kind>(99));
  layout.set_layout(static_cast<v1::Layout>(99));
  codec.set_codec(static_cast<v1::Codec>(99));
  count.set_count(kMaxPacketEvents + 1);
  unit.set_dt_unit_ns(0);
  crc.set_crc32(1);
  EXPECT_EQ(checkPacket(eventsHeader(), {}), "");
  EXPECT_EQ(checkPacket(kind, {}), "kind 99 is unknown");
  EXPECT_EQ(checkPacket(layout, {}), "layout 99 instead of 1");
  EXPECT_EQ(checkPacket(codec, {}), "codec 99 is unknown");
  EXPECT_EQ(checkPacket(count, {}), "count is above 32768");
  EXPECT_EQ(checkPacket(unit, {}), "dt_unit_ns is 0");
  EXPECT_EQ(checkPacket(crc, {}), "crc32 does not match the payload");
}

TEST(Packet, EndCarriesNothing) {
  v1::PacketHeader header;
  header.set_kind(v1::KIND_END);
  EXPECT_EQ(checkPacket(header, {}), "");
  EXPECT_NE(checkPacket(header, "x"), "");
}

TEST(Packet, ErrorCarriesItsMessage) {
  const Packet packet = makeErrorPacket("s1", "the scene is gone");
  EXPECT_EQ(packet.header.kind(), v1::KIND_ERROR);
  EXPECT_EQ(packet.header.stream_id(), "s1");
  EXPECT_EQ(*packet.payload, "the scene is gone");
  PacketContent none;
  EXPECT_EQ(decodePacket(packet.header, *packet.payload, none), "");
  EXPECT_TRUE(none.events.empty());
}

TEST(CodecTable, NamesAndIdsAreUniqueAndRowsInvertThemselves) {
  std::set<std::string> names;
  std::set<v1::Codec> ids;
  const std::string raw("\0some bytes\xff", 12);
  for (const CodecInfo* codec : codecTable()) {
    EXPECT_TRUE(names.insert(codec->name).second && ids.insert(codec->id).second) << codec->name;
    EXPECT_EQ(findCodec(codec->id), codec);
    EXPECT_EQ(codec->decode(codec->encode(raw), raw.size()), raw);
    EXPECT_EQ(codec->decode(codec->encode(raw), raw.size() + 1), std::nullopt);
  }
}

}  // namespace
}  // namespace saccade
