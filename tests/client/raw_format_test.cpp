#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "client/recording/recording_file.h"
#include "file_size_limit.h"
#include "format_test.h"

namespace saccade::client {
namespace {

const WriterInfo& kEvt2Writer = writerFor("a.raw", "evt2");
const WriterInfo& kEvt3Writer = writerFor("a.raw", "evt3");
const ReaderInfo& kRawReader = readerFor("a.raw");

namespace fs = std::filesystem;

constexpr std::int64_t kUs = 1000;
constexpr const char* kHeader = "% evt 3.0\n% format EVT3;height=720;width=1280\n% end\n";

// `word` bytes of each number, the lowest first.
std::string bytesOf(const std::vector<std::uint32_t>& words, int word) {
  std::string bytes;
  for (const std::uint32_t number : words) {
    for (int i = 0; i < word; ++i) bytes += static_cast<char>(number >> 8 * i);
  }
  return bytes;
}

class RawFormatTest : public FormatTest {
 protected:
  std::string fileOf(const std::string& bytes) const {
    std::ofstream(at("a.raw"), std::ios::binary) << bytes;
    return at("a.raw");
  }
  Events eventsOf(const std::string& bytes) const { return readBack(*kRawReader.make(fileOf(bytes))); }
  std::string faultOf(const std::string& bytes) const {
    return FormatTest::faultOf(kRawReader, fileOf(bytes));
  }
  std::string bodyOf(const std::string& file) const {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    const std::string end = "% end\n";
    return text.str().substr(text.str().find(end) + end.size());
  }
};

TEST_F(RawFormatTest, Evt3IsTheFormatOfItsExtension) {
  EXPECT_EQ(&writerFor("a.raw"), &kEvt3Writer);
  EXPECT_EQ(&writerFor("a.raw", "evt2"), &kEvt2Writer);
}

// The words by hand, from the tables of docs.prophesee.ai.
TEST_F(RawFormatTest, Evt3HasTheBytesOfItsDescription) {
  const Events events{{5 * kUs, 1, 2, 1},    {4101 * kUs, 0, 2, 0},  {4101 * kUs, 1, 2, 0},
                      {4101 * kUs, 2, 2, 0}, {4101 * kUs, 12, 2, 0}, {4101 * kUs, 31, 2, 0}};
  write(kEvt3Writer, at("a.raw"), {events}, 8192 * kUs, aboutOf(346, 260));
  EXPECT_EQ(bodyOf(at("a.raw")), bytesOf({0x8000, 0x6005, 0x0002, 0x2801, 0x8001, 0x6005, 0x0002, 0x3000,
                                          0x4007, 0x4001, 0x5080, 0x8002},
                                         2));
}

TEST_F(RawFormatTest, Evt2HasTheBytesOfItsDescription) {
  write(kEvt2Writer, at("a.raw"), {{{5 * kUs, 1, 2, 1}, {129 * kUs, 345, 259, 0}}}, 192 * kUs,
        aboutOf(346, 260));
  EXPECT_EQ(bodyOf(at("a.raw")), bytesOf({0x80000000, 0x11400802, 0x80000002, 0x004AC903, 0x80000003}, 4));
}

TEST_F(RawFormatTest, BothGiveTheirEventsAndSizeBack) {
  Events events;
  for (std::int64_t i = 0; i < 300'000; ++i)
    events.push_back({i * i % 7 == 0 ? i * 300 * kUs : i / 50 * 15'000 * kUs,
                      static_cast<std::uint16_t>(i * 7 % 1280), static_cast<std::uint16_t>(i / 9 % 720),
                      static_cast<std::uint8_t>(i / 3 % 2)});
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.t_ns < b.t_ns; });
  for (const WriterInfo* format : {&kEvt3Writer, &kEvt2Writer}) {
    write(*format, at("a.raw"),
          {{events.begin(), events.begin() + 100'001}, {events.begin() + 100'001, events.end()}},
          events.back().t_ns + 60'000'000 * kUs, aboutOf(1280, 720));
    const auto reader = kRawReader.make(at("a.raw"));
    EXPECT_EQ(reader->size().width, 1280u);
    EXPECT_EQ(reader->size().height, 720u);
    EXPECT_EQ(readBack(*reader), events) << format->name;
  }
}

TEST_F(RawFormatTest, AFileWithoutEventsHasNone) {
  for (const WriterInfo* format : {&kEvt3Writer, &kEvt2Writer}) {
    write(*format, at("a.raw"), {}, 0, aboutOf(1, 1));
    EXPECT_EQ(readBack(*kRawReader.make(at("a.raw"))), Events());
  }
  EXPECT_EQ(eventsOf("% evt 3.0\n% end\n"), Events());
  EXPECT_EQ(eventsOf("% evt 3.0\n"), Events());
}

TEST_F(RawFormatTest, TheHeaderMayNameTheEncodingInOtherWays) {
  const std::string word = bytesOf({0x8000, 0x6005, 0x0002, 0x2801}, 2);
  const Events events{{5 * kUs, 1, 2, 1}};
  for (const char* header :
       {"% evt 3.0 \r\n% end\r\n", "% format EVT3\n% end\n", "% format evt3;x=y\n% end\n",
        "% Date now\n% evt 3.0\n% geometry 4x3\n% end\n"}) {
    EXPECT_EQ(eventsOf(header + word), events) << header;
  }
  EXPECT_EQ(kRawReader.make(fileOf("% evt 3.0\n% geometry 4x3\n% end\n"))->size().height, 3u);
  EXPECT_EQ(kRawReader.make(fileOf("% evt 3.0\n"))->size().width, 0u);
}

TEST_F(RawFormatTest, OtherFilesAreRefusedByName) {
  EXPECT_EQ(faultOf("% evt 2.1\n% end\n"), at("a.raw") + ": holds EVT21; only EVT3 and EVT2 can be read");
  EXPECT_NE(faultOf("% format EVT21;width=4;height=3\n").find("holds EVT21;"), std::string::npos);
  EXPECT_NE(faultOf("% format HISTO3D\n").find("holds HISTO3D;"), std::string::npos);
  EXPECT_NE(faultOf("% evt 4.0\n").find("holds EVT4;"), std::string::npos);
  for (const char* header : {"", "% end\n", "%evt 3.0\n", "\x89PNG", "% "})
    EXPECT_NE(faultOf(header).find("no header of Prophesee"), std::string::npos) << header;
}

TEST_F(RawFormatTest, AFaultNamesItsPlace) {
  const auto wordFault = [&](std::uint32_t word) {
    return faultOf(kHeader + bytesOf({0x8000, 0x0001, 0x6001, word, 0x4001}, 2));
  };
  const std::string place = "the word at byte " + std::to_string(std::string(kHeader).size() + 6);
  for (const std::uint32_t type : {0x1000, 0x9000, 0xB000, 0xC000})
    EXPECT_EQ(wordFault(type), at("a.raw") + ": " + place + " has a type that EVT3 does not know");
  std::vector<std::uint32_t> vectors{0x8000, 0x0001, 0x37FF, 0x4001, 0x4001};
  EXPECT_NE(faultOf(kHeader + bytesOf(vectors, 2)).find("is a vector beyond column 2047"), std::string::npos);
  EXPECT_NE(faultOf("% evt 2.0\n" + bytesOf({0x80000000, 0x20000000}, 4)).find("EVT2 does not know"),
            std::string::npos);
  std::vector<std::uint32_t> wraps(2'000'000);
  for (std::size_t i = 0; i < wraps.size(); ++i) wraps[i] = i % 2 ? 0x80000000 : 0x8FFFFFFF;
  EXPECT_NE(faultOf("% evt 2.0\n" + bytesOf(wraps, 4)).find("is later than 292 years"), std::string::npos);
  for (const char* header :
       {"% evt 3.0\n% geometry 4\n", "% evt 3.0\n% geometry 4x\n", "% evt 3.0\n% geometry 0x3\n",
        "% format EVT3;width=-1;height=3\n", "% format EVT3;width=99999999999;height=3\n"})
    EXPECT_NE(faultOf(header).find("its header has the size"), std::string::npos) << header;
  EXPECT_NE(faultOf("% evt 2.0\n% format EVT3\n").find("two encodings, EVT2 and EVT3"), std::string::npos);
  EXPECT_NE(faultOf("% evt " + std::string(5000, '3')).find("does not end"), std::string::npos);
}

TEST_F(RawFormatTest, AFileOfAProgramThatWasKilledIsReadUpToItsLastWholeWord) {
  const Events one{{5 * kUs, 1, 2, 1}};
  EXPECT_EQ(eventsOf(kHeader + bytesOf({0x8000, 0x6005, 0x0002, 0x2801, 0x2802}, 2).substr(0, 9)), one);
  EXPECT_EQ(eventsOf("% evt 2.0\n" + bytesOf({0x80000000, 0x11400802, 0x11400802}, 4).substr(0, 11)), one);
}

TEST_F(RawFormatTest, WithoutAnEndWhatWasWrittenIsRead) {
  for (const WriterInfo* format : {&kEvt3Writer, &kEvt2Writer}) {
    {
      RecordingFile(at("a.raw"), *format, {aboutOf(4, 3)}).sensor(0).write({{5 * kUs, 1, 2, 1}}, 0, 2 * kUs);
    }
    EXPECT_EQ(readBack(*kRawReader.make(at("a.raw.partial"))), (Events{{5 * kUs, 1, 2, 1}}));
  }
}

TEST_F(RawFormatTest, AFullDiskLeavesWholeBatches) {
  Events batch;
  for (std::uint16_t x = 0; x < 300; x += 2) batch.push_back({5 * kUs, x, 2, 1});
  for (const WriterInfo* format : {&kEvt3Writer, &kEvt2Writer}) {
    const auto writer = format->make(at("a.raw"), aboutOf(346, 260));
    std::size_t batches = 0;
    try {
      const FileSizeLimit limit(10'001);
      for (;; ++batches) writer->write(batch, 5 * kUs);
    } catch (const std::system_error& fault) {
      EXPECT_NE(std::string(fault.what()).find(at("a.raw")), std::string::npos);
    }
    writer->finish();
    EXPECT_GT(batches, 5u);
    EXPECT_EQ(readBack(*kRawReader.make(at("a.raw"))).size(), batches * batch.size()) << format->name;
  }
}

TEST_F(RawFormatTest, WhatDoesNotFitIsRefusedBeforeItIsWritten) {
  for (const WriterInfo* format : {&kEvt3Writer, &kEvt2Writer}) {
    EXPECT_THROW(format->make(at("a.raw"), aboutOf(2049, 3)), std::invalid_argument);
    EXPECT_THROW(format->make(at("a.raw"), aboutOf(3, 2049)), std::invalid_argument);
    EXPECT_FALSE(fs::exists(at("a.raw")));
    const auto writer = format->make(at("b.raw"), aboutOf(2048, 2048));
    EXPECT_THROW(writer->write({{-5 * kUs, 1, 2, 1}, {0, 1, 2, 1}}, 0), std::range_error);
  }
  const auto writer = kEvt3Writer.make(at("b.raw"), aboutOf(4, 3));
  const std::int64_t day = 86'400'000'000 * kUs;
  writer->write({}, day);
  EXPECT_THROW(writer->write({}, 2 * day + 8192 * kUs), std::range_error);
  writer->finish();
  EXPECT_EQ(bodyOf(at("b.raw")).size(), 2 * (86'400'000'000 / 4096 + 1));
}

}  // namespace
}  // namespace saccade::client
