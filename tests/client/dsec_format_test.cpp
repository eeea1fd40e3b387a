// .h5 files by our own writer and reader. dsec_files_test.py compares both with other programs.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "client/recording/recording_file.h"
#include "file_size_limit.h"
#include "format_test.h"
#include "random_events.h"

// HDF5's library forgets memory when it refuses a damaged file.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libhdf5";
}

namespace saccade::client {
namespace {

const WriterInfo& kDsecWriter = writerFor("a.h5", "dsec");
const WriterInfo& kDsecBloscWriter = writerFor("a.h5", "dsec-blosc");
const ReaderInfo& kDsecReader = readerFor("a.h5");

namespace fs = std::filesystem;

constexpr std::int64_t kLastNs = 4'294'967'295'000;  // the largest time in 32 bits of microseconds
constexpr std::size_t kChunk = 131072;               // events

class DsecFormatTest : public FormatTest {
 protected:
  const std::string file_ = at("a.h5");

  Events read() const { return readBack(*kDsecReader.make(file_)); }
  std::string faultOf() const { return FormatTest::faultOf(kDsecReader, file_); }
  // Replaces bytes of the file.
  void damage(std::size_t at, const std::string& bytes) const {
    std::fstream file(file_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(at)) << bytes;
  }
};

TEST_F(DsecFormatTest, EventsAndSizeComeBack) {
  const Events events{{0, 0, 0, 1}, {0, 1279, 719, 0}, {999'000, 5, 6, 1}, {kLastNs, 7, 8, 0}};
  write(kDsecWriter, file_, {events}, kLastNs + 1000, aboutOf(1280, 720));
  const auto reader = kDsecReader.make(file_);
  EXPECT_EQ(reader->size().width, 1280u);
  EXPECT_EQ(reader->size().height, 720u);
  EXPECT_EQ(readBack(*reader), events);
}

TEST_F(DsecFormatTest, AFileMayHaveNoEvents) {
  write(kDsecWriter, file_, {}, 5'000'000, aboutOf(4, 3));
  EXPECT_TRUE(read().empty());
  write(kDsecWriter, file_, {}, 0, aboutOf(4, 3));
  EXPECT_TRUE(read().empty());
}

TEST_F(DsecFormatTest, LabelsComeBack) {
  Events events = randomEvents(kChunk + 77, 640, 480);
  for (std::size_t i = 0; i < events.size(); ++i)
    events[i].source = i % 3 == 0, events[i].artefact = static_cast<std::uint8_t>(i % 256);
  v1::Recording about = aboutOf(640, 480);
  write(kDsecWriter, file_, {events}, 0, about);
  EXPECT_FALSE(kDsecReader.make(file_)->labels());
  about.set_labels(true);
  write(kDsecWriter, file_, {events}, 0, about);
  EXPECT_TRUE(kDsecReader.make(file_)->labels());
  EXPECT_EQ(kDsecReader.make(file_)->leftOut(), "");
  EXPECT_EQ(read(), events);
}

TEST_F(DsecFormatTest, BatchesOfAnySizeJoin) {
  const Events events = randomEvents(2 * kChunk + 77, 640, 480);
  std::vector<Events> batches;
  for (std::size_t begin = 0, size = 1; begin < events.size(); begin += size, size = size * 3 + 1) {
    const auto end = std::min(begin + size, events.size());
    batches.emplace_back(events.begin() + begin, events.begin() + end);
  }
  for (const WriterInfo* format : {&kDsecWriter, &kDsecBloscWriter}) {
    try {
      write(*format, file_, batches, events.back().t_ns + 1000, aboutOf(640, 480));
    } catch (const std::invalid_argument& error) {
      GTEST_SKIP() << error.what();
    }
    EXPECT_EQ(read(), events) << format->name;
  }
}

TEST_F(DsecFormatTest, TimesFromAnEpochGetAnOffset) {
  const std::int64_t day_ns = 1'700'000'000'123'456'000;
  const Events events{{day_ns, 1, 2, 1}, {day_ns + kLastNs - 456'000, 3, 0, 0}};
  write(kDsecWriter, file_, {events}, events.back().t_ns + 1000, aboutOf(4, 3));
  EXPECT_EQ(read(), events);
}

TEST_F(DsecFormatTest, TimesThatDoNotFitAreRefused) {
  const auto writer = kDsecWriter.make(file_, aboutOf(4, 3));
  writer->write({{0, 1, 2, 1}}, kLastNs);
  EXPECT_THROW(writer->write({{kLastNs, 1, 1, 1}, {kLastNs + 1000, 1, 2, 1}}, 2 * kLastNs), std::range_error);
  writer->finish();
  EXPECT_EQ(read(), (Events{{0, 1, 2, 1}}));
  EXPECT_THROW(kDsecWriter.make(file_, aboutOf(4, 3))->write({{-1000, 1, 2, 1}}, 0), std::range_error);
  v1::Recording about = aboutOf(4, 3);
  about.mutable_request()->mutable_timing()->set_duration_s(4294.9);
  kDsecWriter.make(file_, about);
  about.mutable_request()->mutable_timing()->set_duration_s(4295);
  EXPECT_THROW(kDsecWriter.make(file_, about), std::invalid_argument);
}

TEST_F(DsecFormatTest, AKilledWriterLeavesWholeChunks) {
  const Events events = randomEvents(3 * kChunk, 640, 480);
  const auto writer = kDsecWriter.make(at("b.h5"), aboutOf(640, 480));
  const auto copied = [&] {
    fs::copy_file(at("b.h5"), file_, fs::copy_options::overwrite_existing);
    return read();
  };
  EXPECT_TRUE(copied().empty());
  for (std::size_t done = 0; done < events.size(); done += kChunk / 2) {
    writer->write({events.begin() + done, events.begin() + done + kChunk / 2}, events[done].t_ns);
    const std::size_t whole = (done + kChunk / 2) / kChunk * kChunk;
    EXPECT_EQ(copied(), Events(events.begin(), events.begin() + whole)) << done;
  }
}

TEST_F(DsecFormatTest, AFullDiskKeepsAsManyEventsAsItSays) {
  const Events events = randomEvents(kChunk, 640, 480);
  const auto writer = kDsecWriter.make(file_, aboutOf(640, 480));
  {
    const FileSizeLimit limit(2'000'000);
    try {
      while (true) writer->write(events, events.back().t_ns);
    } catch (const std::system_error& error) {
      EXPECT_EQ(error.code().value(), EFBIG);
      EXPECT_EQ(std::string(error.what()).find(file_ + ": "), 0u) << error.what();
    }
    writer->finish();
  }
  const Events kept = read();
  EXPECT_GT(kept.size(), 0u);
  EXPECT_EQ(kept.size() % kChunk, 0u);
  EXPECT_EQ(writer->kept(5), kept.size());
}

TEST_F(DsecFormatTest, AFullDiskAtTheEndIsToldToo) {
  const auto writer = kDsecWriter.make(file_, aboutOf(640, 480));
  writer->write(randomEvents(kChunk - 1, 640, 480), 0);
  const FileSizeLimit limit(100'000);
  EXPECT_THROW(writer->finish(), std::system_error);
  EXPECT_TRUE(read().empty());
  EXPECT_EQ(writer->kept(5), 0u);
}

TEST_F(DsecFormatTest, AnInterruptedRecordingCanBeRead) {
  const Events events = randomEvents(1000, 640, 480);
  {
    RecordingFile recording(file_, kDsecWriter, {aboutOf(640, 480)});
    recording.sensor(0).write(events, 0, events.back().t_ns + 1000);
  }
  fs::rename(file_ + ".partial", file_);
  EXPECT_EQ(read(), events);
}

TEST_F(DsecFormatTest, DamagedFilesAreRefused) {
  write(kDsecWriter, file_, {randomEvents(kChunk, 640, 480)}, 0, aboutOf(640, 480));
  const auto size = fs::file_size(file_);
  damage(size / 2, std::string(1000, 'x'));  // within a chunk
  EXPECT_NE(faultOf().find(file_ + ": events/"), std::string::npos) << faultOf();
  EXPECT_NE(faultOf().find(" cannot be read from event 1 on: "), std::string::npos) << faultOf();
  fs::resize_file(file_, size - 1);
  EXPECT_NE(faultOf().find("is not a whole file of HDF5"), std::string::npos) << faultOf();
  fs::resize_file(file_, 0);
  EXPECT_NE(faultOf().find("is not a whole file of HDF5"), std::string::npos) << faultOf();
  fs::remove(file_);
  EXPECT_THROW(read(), std::system_error);
}

// Of our own code: libFuzzer would find faults of HDF5's library, whose parser is not ours to mend.
TEST_F(DsecFormatTest, EventsOfDamagedFilesAreReadOrRefused) {
  write(kDsecWriter, file_, {randomEvents(100, 640, 480)}, 0, aboutOf(640, 480));
  const auto size = fs::file_size(file_);
  std::string bytes(size, '\0');
  std::ifstream(file_, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(size));
  int refused = 0;
  for (std::size_t at = 0; at < size; at += 43) {
    damage(at, std::string(1, static_cast<char>(~bytes[at])));
    refused += faultOf() != "none";
    damage(at, bytes.substr(at, 1));
  }
  EXPECT_GT(refused, 10);
  EXPECT_EQ(faultOf(), "none");
}

TEST_F(DsecFormatTest, AFolderThatIsNotThereIsNamed) {
  try {
    kDsecWriter.make(at("none/a.h5"), aboutOf(4, 3));
    FAIL() << "there is no folder";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("none/a.h5"), std::string::npos);
  }
}

TEST_F(DsecFormatTest, SeveralSensorsShareAFile) {
  const Writers writers = kDsecWriter.makeJoint(file_, {aboutOf(640, 480), aboutOf(4, 3), aboutOf(4, 3)});
  const Events first = randomEvents(kChunk + 5, 640, 480), last{{7000, 3, 2, 1}, {9000, 0, 0, 0}};
  writers[0]->write(first, 0);
  writers[2]->write(last, 10'000);
  for (const auto& writer : writers) writer->finish();
  EXPECT_EQ(read(), first);
  EXPECT_EQ(readBack(*openReader(file_, {.sensor = 1})), Events());
  const auto reader = openReader(file_, {.sensor = 2});
  EXPECT_EQ(reader->sensor(), 2u);
  EXPECT_EQ(reader->size().width, 4u);
  EXPECT_EQ(reader->leftOut(), "sensor 0 (--sensor 0), sensor 1 (--sensor 1)");
  EXPECT_EQ(readBack(*reader), last);
  EXPECT_THROW(openReader(file_, {.sensor = 3}), std::invalid_argument);
  EXPECT_THROW(openReader(file_, {.topic = "/dvs/events"}), std::invalid_argument);
}

TEST_F(DsecFormatTest, AFullDiskLeavesWholeChunksOfEachSensor) {
  const Writers writers = kDsecWriter.makeJoint(file_, {aboutOf(640, 480), aboutOf(640, 480)});
  {
    const FileSizeLimit limit(2'000'000);
    const auto fill = [&] {
      for (std::size_t i = 0;; ++i) writers[i % 2]->write(randomEvents(kChunk / 2, 640, 480), 0);
    };
    EXPECT_THROW(fill(), std::system_error);
    for (const auto& writer : writers) writer->finish();
  }
  for (std::uint32_t sensor : {0, 1}) {
    const auto kept = writers[sensor]->kept(5);
    EXPECT_GT(kept, 0u);
    EXPECT_EQ(readBack(*openReader(file_, {.sensor = sensor})).size(), kept);
  }
}

TEST_F(DsecFormatTest, SeveralFilesMayGrowAtOnce) {
  const auto a = kDsecWriter.make(file_, aboutOf(4, 3)), b = kDsecWriter.make(at("b.h5"), aboutOf(4, 3));
  a->write({{1000, 1, 1, 1}}, 2000);
  b->write({{3000, 2, 2, 0}}, 4000);
  b->finish();
  a->finish();
  EXPECT_EQ(read(), (Events{{1000, 1, 1, 1}}));
  EXPECT_EQ(readBack(*kDsecReader.make(at("b.h5"))), (Events{{3000, 2, 2, 0}}));
}

}  // namespace
}  // namespace saccade::client
