#include "saccade/wire/columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace saccade {
namespace {

v1::PacketHeader headerOf(std::uint32_t count, std::int64_t t0_ns, std::int64_t t1_ns) {
  v1::PacketHeader header;
  header.set_layout(v1::LAYOUT_COLUMNS);
  header.set_count(count);
  header.set_t0_ns(t0_ns);
  header.set_t1_ns(t1_ns);
  header.set_dt_unit_ns(1000);
  header.set_width(400);
  header.set_height(300);
  return header;
}

// Two events at t0 + 258 us and t0 + 1 s: 258 = 0x102, 1000000 = 0xf4240, 399 = 0x18f, 299 = 0x12b.
const std::string kBytes("\x02\x01\x00\x00\x40\x42\x0f\x00\x8f\x01\x05\x00\x00\x00\x2b\x01\x01\x00", 18);
const Events kEvents{{5'258'000, 399, 0, 1}, {1'005'000'000, 5, 299, 0}};

TEST(Columns, EncodeAsSpelledOutByHand) {
  EXPECT_EQ(encodeColumns(kEvents, 5'000'000), kBytes);
}

TEST(Columns, DecodeAsSpelledOutByHand) {
  Events out;
  EXPECT_EQ(decodeColumns(headerOf(2, 5'000'000, 1'005'001'000), kBytes, out), "");
  EXPECT_EQ(out, kEvents);
}

// The same events with labels: noise, and odds of 127/255.
TEST(Columns, LabelsStandBehindTheColumns) {
  Events labelled = kEvents;
  labelled[1].source = v1::EVENT_SOURCE_NOISE;
  labelled[0].artefact = 127;
  const std::string bytes = kBytes + std::string("\0\1\x7f\0", 4);
  EXPECT_EQ(encodeColumns(labelled, 5'000'000, v1::LAYOUT_LABELLED_COLUMNS), bytes);
  v1::PacketHeader header = headerOf(2, 5'000'000, 1'005'001'000);
  header.set_layout(v1::LAYOUT_LABELLED_COLUMNS);
  Events out;
  EXPECT_EQ(decodeColumns(header, bytes, out), "");
  EXPECT_EQ(out, labelled);
  std::string strange = bytes;
  strange[19] = 9;
  EXPECT_NE(decodeColumns(header, strange, out), "");
  EXPECT_NE(decodeColumns(header, kBytes, out), "");
}

// 13 or 15 bytes: the objects 7 and 0x00020304 stand last.
TEST(Columns, ObjectsStandBehindAllOthers) {
  Events events = kEvents;
  events[0].object = 7, events[1].object = 0x00020304;
  const std::string objects("\x07\x00\x00\x00\x04\x03\x02\x00", 8), labels("\x01\x00\x7f\x00", 4);
  EXPECT_EQ(encodeColumns(events, 5'000'000, v1::LAYOUT_OBJECT_COLUMNS), kBytes + objects);
  v1::PacketHeader header = headerOf(2, 5'000'000, 1'005'001'000);
  Events out;
  header.set_layout(v1::LAYOUT_OBJECT_COLUMNS);
  EXPECT_EQ(decodeColumns(header, kBytes + objects, out), "");
  EXPECT_EQ(out, events);
  EXPECT_NE(decodeColumns(header, kBytes + objects.substr(1), out), "");
  EXPECT_EQ(decodeColumns(header, kBytes + objects.substr(0, 7) + '\x10', out), "an object beyond 1048575");
  events[0].source = 1, events[0].artefact = 127;
  header.set_layout(v1::LAYOUT_LABELLED_OBJECT_COLUMNS);
  EXPECT_EQ(encodeColumns(events, 5'000'000, header.layout()), kBytes + labels + objects);
  EXPECT_EQ(decodeColumns(header, kBytes + labels + objects, out), "");
  EXPECT_EQ(out, events);
}

TEST(Columns, EncodeRefusesTimesItCannotExpress) {
  EXPECT_THROW(encodeColumns(kEvents, 5'258'001), std::out_of_range);
  const Events late{{(std::int64_t{1} << 32) * 1000, 0, 0, 0}};
  EXPECT_THROW(encodeColumns(late, 0), std::out_of_range);
  EXPECT_NO_THROW(encodeColumns(late, 1000));
}

struct Hostile {
  const char* what;
  v1::PacketHeader header;
  std::string payload;
};

TEST(Columns, DecodeSaysWhatIsWrong) {
  const auto good = headerOf(2, 5'000'000, 1'005'001'000);
  auto narrow = good, low = good, huge = good;
  narrow.set_width(399);
  low.set_height(299);
  huge.set_count(0xffffffff);
  std::string swapped = kBytes, odd = kBytes;
  std::swap_ranges(swapped.begin(), swapped.begin() + 4, swapped.begin() + 4);
  odd[17] = 2;
  const Hostile cases[] = {
      {"size", good, kBytes.substr(1)},
      {"size", good, {}},
      {"size", huge, kBytes},
      {"pixel", narrow, kBytes},
      {"pixel", low, kBytes},
      {"polarity", good, odd},
      {"times that run backwards", good, swapped},
      {"outside the packet's interval", headerOf(2, 5'000'000, 1'005'000'000), kBytes},
      {"outside the packet's interval", headerOf(2, 5'000'000, 5'000'000), kBytes},
      {"interval that runs backwards", headerOf(2, 5'000'000, 4'999'000), kBytes},
      {"interval that runs backwards", headerOf(2, INT64_MIN, INT64_MAX), kBytes},
      {"outside the packet's interval", headerOf(2, INT64_MAX - 1000, INT64_MAX), kBytes},
  };
  for (const Hostile& hostile : cases) {
    Events out = kEvents;
    const std::string fault = decodeColumns(hostile.header, hostile.payload, out);
    EXPECT_NE(fault.find(hostile.what), std::string::npos) << hostile.what << ", said: " << fault;
  }
}

TEST(Columns, AnyBytesAreRefusedOrInRange) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    std::string bytes(random() % 40, '\0');
    for (char& c : bytes) c = static_cast<char>(random() % 3);
    auto header = headerOf(random() % 5, random() % 3 * 1000, random() % 5'000'000);
    header.set_dt_unit_ns(random() % 2 ? 1000 : random());
    Events out;
    if (!decodeColumns(header, bytes, out).empty()) continue;
    EXPECT_EQ(out.size(), header.count());
    for (const Event& e : out) {
      EXPECT_TRUE(e.x < 400 && e.y < 300 && e.p <= 1 && e.t_ns >= header.t0_ns());
      EXPECT_LE(e.t_ns, header.t1_ns());
    }
  }
}

}  // namespace
}  // namespace saccade
