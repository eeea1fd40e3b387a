#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "client/formats/aedat4/packet_file.h"
#include "client/formats/aedat4/packet_table.h"
#include "client/recording/recording_file.h"
#include "file_size_limit.h"
#include "format_test.h"

namespace saccade::client {
namespace {

const WriterInfo& kAedat4Writer = writerFor("a.aedat4", "aedat4");
const ReaderInfo& kAedat4Reader = readerFor("a.aedat4");

namespace fs = std::filesystem;
using namespace aedat4;

constexpr std::int64_t kMs = 1'000'000;

// Two events per millisecond.
Events eventsOf(int milliseconds) {
  Events events;
  for (int i = 0; i < milliseconds; ++i) {
    const auto x = static_cast<std::uint16_t>(i % 640);
    events.push_back({i * kMs, x, 0, 1});
    events.push_back({i * kMs + 999'000, 639, 479, 0});
  }
  return events;
}

std::string infoOf(const std::string& streams) {
  return R"(<dv version="2.0"><node name="outInfo" path="/">)" + streams + "</node></dv>";
}

std::string streamOf(const std::string& id, const std::string& type, const std::string& size_x = "640") {
  return "<node name=\"" + id + R"("><attr key="typeIdentifier" type="string">)" + type +
         R"(</attr><node name="info"><attr key="sizeX" type="int">)" + size_x +
         R"(</attr><attr key="sizeY" type="int">480</attr></node></node>)";
}

class Aedat4Test : public FormatTest {
 protected:
  std::string bytesOf(const std::string& name) const {
    std::ifstream file(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string fileOf(const std::string& name, const std::string& bytes) const {
    std::ofstream(at(name), std::ios::binary) << bytes;
    return at(name);
  }
  // Of one packet of `events`, without a table.
  static std::string contentOf(const Events& events, const std::string& info = infoOf(streamOf("0", "EVTS")),
                               Compression compression = Compression::kLz4) {
    std::string bytes = std::string(kMagic) + encodeHeader({compression, kNoTable, info});
    PacketEncoder(compression == Compression::kNone ? compression : Compression::kLz4).append(bytes, events);
    return bytes;
  }
  // The events up to the end, or to a fault.
  struct Outcome {
    Events events;
    std::string fault = "none";
  };
  Outcome read(const std::string& bytes) const {
    Outcome outcome;
    try {
      const auto reader = kAedat4Reader.make(fileOf("read.aedat4", bytes));
      for (Events batch; reader->read(batch);)
        outcome.events.insert(outcome.events.end(), batch.begin(), batch.end());
    } catch (const FileFault& fault) {
      outcome.fault = std::string(fault.what()).substr(at("read.aedat4: ").size());
    }
    return outcome;
  }
  std::string faultOf(const std::string& bytes) const { return read(bytes).fault; }
};

TEST_F(Aedat4Test, GivesItsEventsAndSizeBack) {
  const Events events{{0, 0, 0, 1},
                      {1000, 1279, 719, 0},
                      {72LL * 60 * 1000 * kMs, 1279, 0, 1},
                      {100LL * 3600 * 1000 * kMs + 1000, 0, 719, 0}};
  write(kAedat4Writer, at("a.aedat4"), {events}, 0, aboutOf(1280, 720));
  const auto reader = kAedat4Reader.make(at("a.aedat4"));
  EXPECT_EQ(reader->size().width, 1280u);
  EXPECT_EQ(reader->size().height, 720u);
  EXPECT_EQ(reader->leftOut(), "");
  EXPECT_EQ(readBack(*reader), events);
}

TEST_F(Aedat4Test, TimesMayLieBeforeZero) {
  const Events events{{-12 * kMs, 1, 2, 1}, {-10 * kMs, 3, 4, 0}, {-5 * kMs, 5, 6, 1}, {0, 7, 8, 0}};
  write(kAedat4Writer, at("a.aedat4"), {events}, kMs, aboutOf(640, 480));
  EXPECT_EQ(readBack(*kAedat4Reader.make(at("a.aedat4"))), events);
}

TEST_F(Aedat4Test, MayHaveNoEventAndThenNoPacket) {
  write(kAedat4Writer, at("a.aedat4"), {}, kMs, aboutOf(4, 3));
  const auto reader = kAedat4Reader.make(at("a.aedat4"));
  EXPECT_EQ(reader->size().width, 4u);
  EXPECT_TRUE(readBack(*reader).empty());
  EXPECT_FALSE(PacketFile(at("a.aedat4")).next());
}

TEST_F(Aedat4Test, TheBatchesOfTheEventsDoNotMatter) {
  const Events events = eventsOf(100);
  write(kAedat4Writer, at("a.aedat4"), {events}, 100 * kMs, aboutOf(640, 480));
  std::vector<Events> batches;
  for (std::size_t i = 0; i < events.size(); i += 7)
    batches.emplace_back(events.begin() + i, events.begin() + std::min(i + 7, events.size()));
  write(kAedat4Writer, at("b.aedat4"), batches, 100 * kMs, aboutOf(640, 480));
  EXPECT_EQ(bytesOf("a.aedat4"), bytesOf("b.aedat4"));
}

TEST_F(Aedat4Test, APacketHoldsFiveMillisecondsOr65536Events) {
  Events events = eventsOf(10);
  events.insert(events.end(), 100'000, Event{9'999'000, 1, 2, 1});
  write(kAedat4Writer, at("a.aedat4"), {events}, 10 * kMs, aboutOf(640, 480));
  PacketFile file(at("a.aedat4"));
  std::vector<std::size_t> sizes;
  while (const auto packet = file.next()) {
    Events held;
    appendEvents(held, file.content(*packet));
    sizes.push_back(held.size());
  }
  EXPECT_EQ(sizes, (std::vector<std::size_t>{10, 65536, 100'010 - 65536}));
}

TEST_F(Aedat4Test, WithoutAnEndEachBatchOfWholePacketsIsThere) {
  const Events events = eventsOf(12);
  const auto writer = kAedat4Writer.make(at("a.aedat4"), aboutOf(640, 480));
  writer->write({events.begin(), events.begin() + 10}, 5 * kMs);
  EXPECT_EQ(read(bytesOf("a.aedat4")).events, (Events{events.begin(), events.begin() + 10}));
  writer->write({events.begin() + 10, events.end()}, 12 * kMs);
  EXPECT_EQ(read(bytesOf("a.aedat4")).events, (Events{events.begin(), events.begin() + 20}));
  writer->finish();
  EXPECT_EQ(read(bytesOf("a.aedat4")).events, events);
}

TEST_F(Aedat4Test, AFileThatWasNotFinishedIsReadToItsLastWholePacket) {
  const Events events = eventsOf(5);
  std::string whole = contentOf(events);
  const std::size_t first = whole.size();
  PacketEncoder(Compression::kLz4).append(whole, events);
  for (std::size_t size = first; size < whole.size(); ++size) {
    const Outcome cut = read(whole.substr(0, size));
    EXPECT_EQ(cut.fault, "none") << size;
    EXPECT_EQ(cut.events, events) << size;
  }
  EXPECT_EQ(read(whole).events.size(), 2 * events.size());
}

TEST_F(Aedat4Test, AFinishedFileThatIsCutIsAFault) {
  const Events events = eventsOf(5);
  write(kAedat4Writer, at("a.aedat4"), {events, eventsOf(0)}, 5 * kMs, aboutOf(640, 480));
  const std::string whole = bytesOf("a.aedat4");
  const Outcome cut = read(whole.substr(0, whole.size() / 2 + 400));
  EXPECT_NE(cut.fault.find("does not end before the end of the file, which should reach"), std::string::npos)
      << cut.fault;
}

// There is room again when the file is finished, but not for what was refused.
TEST_F(Aedat4Test, AFullDiskLeavesAsManyEventsAsAreTold) {
  std::uint64_t told = 0;
  {
    RecordingFile file(at("a.aedat4"), kAedat4Writer, {aboutOf(640, 480)});
    try {
      const FileSizeLimit limit(20'001);
      for (std::int64_t t_ns = 0;; t_ns += 3 * kMs) {
        Events later = eventsOf(3);
        for (Event& event : later) event.t_ns += t_ns;
        file.sensor(0).write(later, t_ns, t_ns + 3 * kMs);
      }
    } catch (const std::system_error& fault) {
      EXPECT_NE(std::string(fault.what()).find("a.aedat4.partial"), std::string::npos);
    }
    told = file.sensor(0).about().events();
  }
  EXPECT_GT(told, 1000u);
  EXPECT_EQ(read(bytesOf("a.aedat4.partial")).events.size(), told);
}

// Three packets of another stream stand before the events as holes of the file.
TEST_F(Aedat4Test, PacketsMayStandBeyondFourGigabytes) {
  constexpr std::uint32_t kHole = INT32_MAX;
  const std::string file = at("a.aedat4");
  const std::string header =
      std::string(kMagic) +
      encodeHeader({Compression::kLz4, kNoTable, infoOf(streamOf("1", "FRME") + streamOf("0", "EVTS"))});
  std::string events;
  PacketEncoder(Compression::kLz4).append(events, eventsOf(5));
  std::ofstream out(file, std::ios::binary);
  out << header;
  for (int i = 0; i < 3; ++i) {
    const PacketHeader hole{1, kHole};
    out.write(reinterpret_cast<const char*>(&hole), sizeof hole).seekp(kHole, std::ios::cur);
  }
  out << events;
  out.close();
  ASSERT_GT(fs::file_size(file), 6ull << 30);
  const auto reader = kAedat4Reader.make(file);
  EXPECT_EQ(reader->leftOut(), "stream 1 (FRME)");
  EXPECT_EQ(readBack(*reader), eventsOf(5));
}

// The first bytes of the file example/davis.aedat4 of the repository aestream/aestream, which DV has
// recorded.
TEST(Aedat4Bytes, AreThoseOfDv) {
  constexpr std::string_view kHeader(
      "\x24\x0c\0\0\x18\0\0\0IOHE\0\0\0\0\0\0\x0a\0\x18\0\x04\0\x0c\0\x08\0\x0a\0\0\0\x01\0\0\0"
      "\x10\0\0\0\xaf\x28\x12\0\0\0\0\0\0\0\0\0\xed\x0b\0\0",
      56);
  constexpr std::string_view kEvents(
      "\x1c\x6c\x02\0\x10\0\0\0EVTS\0\0\x06\0\x08\0\x04\0\x06\0\0\0\x04\0\0\0\xc0\x26\0\0", 32);
  constexpr std::string_view kFrame("\x04\x22\x4d\x18\x40\x40\xc0", 7);
  const std::string header = encodeHeader({Compression::kLz4, 1190063, std::string(0xbed, 'x')});
  EXPECT_EQ(header.substr(0, kHeader.size()), kHeader);
  EXPECT_EQ(header.size(), 4u + 0xc24);
  const Events events(9920, Event{0, 1, 2, 1});
  std::string plain, packed;
  PacketEncoder(Compression::kNone).append(plain, events);
  PacketEncoder(Compression::kLz4).append(packed, events);
  EXPECT_EQ(plain.substr(sizeof(PacketHeader), kEvents.size()), kEvents);
  EXPECT_EQ(packed.substr(sizeof(PacketHeader), kFrame.size()), kFrame);
}

TEST_F(Aedat4Test, ANodeThatIsNoStreamIsPassedOver) {
  const std::string settings =
      R"(<node name="jAERConfigSnapshot"><attr key="a" type="string">b</attr></node>)";
  EXPECT_EQ(read(contentOf(eventsOf(5), infoOf(settings + streamOf("0", "EVTS")))).events, eventsOf(5));
}

TEST_F(Aedat4Test, AnImageBeyondSixteenBitsIsRefused) {
  EXPECT_NO_THROW(kAedat4Writer.make(at("a.aedat4"), aboutOf(32767, 32767)));
  EXPECT_THROW(kAedat4Writer.make(at("b.aedat4"), aboutOf(4, 32768)), std::invalid_argument);
}

TEST_F(Aedat4Test, AFaultNamesItsPlace) {
  const Events events = eventsOf(5);
  const IoHeader header{Compression::kNone, kNoTable, infoOf(streamOf("0", "EVTS"))};
  const std::string good = contentOf(events, header.info_node, header.compression);
  const std::size_t start = kMagic.size() + encodeHeader(header).size();  // of the packet
  const auto changed = [&](std::size_t place, const std::string& bytes) {
    std::string file = good;
    return file.replace(place, bytes.size(), bytes);
  };
  ASSERT_EQ(read(good).events, events);
  const std::string place = "the packet at byte " + std::to_string(start) + " ";
  EXPECT_EQ(faultOf(""), "does not begin as AEDAT 4 does");
  EXPECT_EQ(faultOf(changed(11, "5")), "does not begin as AEDAT 4 does");
  EXPECT_EQ(faultOf(changed(14, "\xff\xff\xff\xff")),
            "the header has 4294967295 bytes, more than the file or than 16 MiB");
  EXPECT_EQ(faultOf(changed(22, "IOHX")), "the header is not of the format IOHE");
  EXPECT_EQ(faultOf(changed(start, "\x07")), place + "is of the unknown stream 7");
  EXPECT_EQ(faultOf(changed(start + 7, "\xff")),
            place + "has the size " +
                std::to_string(static_cast<std::int32_t>(good.size() - start - 8) | INT32_MIN >> 7));
  EXPECT_EQ(faultOf(changed(start + 16, "EVTX")), place + "is not of the format EVTS");
  std::string late = good;
  PacketEncoder(Compression::kNone).append(late, {&events[0], 1}, INT64_MAX / 1000 + 1);
  EXPECT_EQ(read(late).events, events);
  EXPECT_EQ(faultOf(late), "the packet at byte " + std::to_string(good.size()) +
                               " has the time 9223372036854776 us, which is out of range");
  EXPECT_EQ(faultOf(contentOf(events, "<dv")).find("the header is not XML: "), 0u);
  EXPECT_EQ(faultOf(contentOf(events, "<dv/>")), "the header has no node outInfo");
  EXPECT_EQ(faultOf(contentOf(events, infoOf(streamOf("0", "FRME")))), "has no stream of events (EVTS)");
  EXPECT_EQ(faultOf(contentOf(events, infoOf(streamOf("a", "EVTS")))),
            "the header names a stream 'a', which is not a number");
  EXPECT_EQ(faultOf(contentOf(events, infoOf(streamOf("0", "EVTS", "40000")))),
            "the header has the sizeX '40000', which is not a number from 1 to 32768");
  EXPECT_EQ(faultOf(contentOf(events, infoOf(streamOf("0", "EVTS")), Compression(5))),
            "the header has the unknown compression 5");
}

TEST(Aedat4Compression, RefusesMoreThanItMayHoldAndWhatIsNotWhole) {
  std::string packed, expanded;
  Compressor(Compression::kLz4).append(packed, std::string(1 << 20, 'a'));
  expand(expanded, packed, Compression::kLz4, 1 << 20);
  EXPECT_EQ(expanded, std::string(1 << 20, 'a'));
  EXPECT_THROW(expand(expanded, packed, Compression::kLz4, 1 << 19), std::runtime_error);
  EXPECT_THROW(expand(expanded, packed.substr(0, packed.size() - 1), Compression::kLz4, 1 << 20),
               std::runtime_error);
  EXPECT_THROW(expand(expanded, packed + "a", Compression::kLz4, 1 << 20), std::runtime_error);
  EXPECT_THROW(expand(expanded, packed, Compression::kZstd, 1 << 20), std::runtime_error);
  EXPECT_THROW(expand(expanded, "", Compression::kLz4, 1 << 20), std::runtime_error);
  EXPECT_THROW(expand(expanded, "", Compression::kZstd, 1 << 20), std::runtime_error);
}

TEST(Aedat4Table, IsLeftOutWhereReadersWouldRefuseIt) {
  PacketTable table;
  for (std::size_t i = 0; i < PacketTable::kMostPackets; ++i) table.add({});
  EXPECT_TRUE(table.whole());
  table.add({});
  EXPECT_FALSE(table.whole());
}

}  // namespace
}  // namespace saccade::client
