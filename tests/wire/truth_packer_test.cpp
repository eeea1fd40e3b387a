#include "saccade/wire/truth_packer.h"

#include <gtest/gtest.h>

#include <cstring>

#include "saccade/wire/packet_cutter.h"

namespace saccade {
namespace {

const PacketSource kSource{"s1", 9, 2, 3, 2, &kCodecNone};
const TruthPacker::Format kRowFormat{v1::LAYOUT_ROWS, v1::ELEMENT_F64, 1};
const TruthPacker::Format kPictureFormat{v1::LAYOUT_PICTURE, v1::ELEMENT_U16, 2};

TruthSample row(std::int64_t t_ns, double value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return {t_ns, bytes};
}

TruthSample picture(std::int64_t t_ns) {
  return {t_ns, std::string(3 * 2 * 2 * 2, static_cast<char>(t_ns / 1000)), t_ns - 2000, t_ns - 1000};
}

// The rules that hold for all packets of a channel from t = 0 on. Returns the samples.
TruthSamples checkTiling(const std::vector<Packet>& packets) {
  TruthSamples all;
  std::int64_t t = 0;
  std::uint64_t seq = 0;
  for (const Packet& packet : packets) {
    PacketContent part;
    EXPECT_EQ(decodePacket(packet.header, *packet.payload, part), "");
    EXPECT_EQ(packet.header.t0_ns(), t);
    EXPECT_EQ(packet.header.seq(), seq++);
    EXPECT_EQ(packet.header.first_event_index(), all.size());
    EXPECT_EQ(packet.header.count(), part.truth.size());
    t = packet.header.t1_ns();
    all.insert(all.end(), part.truth.begin(), part.truth.end());
  }
  return all;
}

void append(std::vector<Packet>& to, std::vector<Packet> packets) {
  for (Packet& packet : packets) to.push_back(std::move(packet));
}

TEST(TruthPacker, RowsShareAPacketUpToItsTime) {
  TruthPacker packer(kSource, kRowFormat, 0);
  EXPECT_TRUE(packer.add({row(0, 1), row(2'000'000, 2)}, 2'000'000, 1).empty());
  auto packets = packer.add({row(5'000'000, 3)}, 5'000'000, 2);
  ASSERT_EQ(packets.size(), 1u);
  append(packets, packer.add({row(6'000'000, 4)}, 6'000'000, 3));
  append(packets, packer.end(v1::END_REASON_FINISHED));
  ASSERT_EQ(packets.size(), 3u);
  EXPECT_EQ(packets.back().header.kind(), v1::KIND_END);
  EXPECT_EQ(packets.back().header.t1_ns(), 6'000'000);
  EXPECT_EQ(checkTiling(packets),
            (TruthSamples{row(0, 1), row(2'000'000, 2), row(5'000'000, 3), row(6'000'000, 4)}));
}

TEST(TruthPacker, APictureHasAPacketOfItsOwn) {
  TruthPacker packer(kSource, kPictureFormat, 0);
  auto packets = packer.add({picture(0), picture(2'000'000)}, 2'000'000, 1);
  ASSERT_EQ(packets.size(), 2u);
  append(packets, packer.add({}, 4'000'000, 2));  // no picture is wanted
  EXPECT_EQ(packets.size(), 2u);
  append(packets, packer.end(v1::END_REASON_FINISHED));
  EXPECT_EQ(packets.back().header.t0_ns(), 4'000'000);
  EXPECT_EQ(checkTiling(packets), (TruthSamples{picture(0), picture(2'000'000)}));
}

TEST(TruthPacker, ManyRowsTakeSeveralPackets) {
  TruthPacker packer(kSource, kRowFormat, 0);
  TruthSamples rows;
  for (std::uint32_t i = 0; i <= 2 * kMaxPacketRows; ++i) rows.push_back(row(i * 1000, i));
  const auto packets = packer.add(rows, 100'000'000, 1);
  EXPECT_EQ(packets.size(), 3u);
  EXPECT_EQ(checkTiling(packets), rows);
}

TEST(TruthPacker, ZstdGivesTheSameSamples) {
  PacketSource source = kSource;
  source.codec = findCodec(v1::CODEC_ZSTD);
  TruthPacker packer(source, kPictureFormat, 0);
  EXPECT_EQ(checkTiling(packer.add({picture(2'000'000)}, 2'000'000, 1)), TruthSamples{picture(2'000'000)});
}

struct Broken {
  const char* name;
  void (*change)(v1::PacketHeader& header);
};

class BrokenTruth : public testing::TestWithParam<Broken> {};

TEST_P(BrokenTruth, IsRefused) {
  TruthPacker packer(kSource, kRowFormat, 0);
  Packet packet = packer.add({row(1000, 1), row(2000, 2)}, 5'000'000, 1).front();
  GetParam().change(packet.header);
  PacketContent content;
  EXPECT_NE(decodePacket(packet.header, *packet.payload, content), "");
}

using Header = v1::PacketHeader;
INSTANTIATE_TEST_SUITE_P(
    Headers, BrokenTruth,
    testing::Values(Broken{"Element", [](Header& h) { h.set_element(v1::ELEMENT_UNSPECIFIED); }},
                    Broken{"NoPlanes", [](Header& h) { h.set_planes(0); }},
                    Broken{"ManyPlanes", [](Header& h) { h.set_planes(1 << 30); }},
                    Broken{"Layout", [](Header& h) { h.set_layout(v1::LAYOUT_COLUMNS); }},
                    Broken{"Count", [](Header& h) { h.set_count(3); }},
                    Broken{"HugeCount", [](Header& h) { h.set_count(UINT32_MAX); }},
                    Broken{"Codec", [](Header& h) { h.set_codec(v1::CODEC_UNSPECIFIED); }},
                    Broken{"Interval", [](Header& h) { h.set_t1_ns(1000); }},
                    Broken{"Backwards", [](Header& h) { h.set_t0_ns(6'000'000); }},
                    Broken{"Unit", [](Header& h) { h.set_dt_unit_ns(0); }},
                    Broken{"Picture",
                           [](Header& h) {
                             h.set_layout(v1::LAYOUT_PICTURE);
                             h.set_count(1);
                             h.set_width(UINT32_MAX);
                           }}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace saccade
