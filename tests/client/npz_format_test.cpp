// .npz files by our own writer and reader. npz_files_test.py compares both with NumPy.
#include <zip.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "client/formats/npz/npy_column.h"
#include "client/formats/npz/zip_archive.h"
#include "client/recording/recording_file.h"
#include "file_size_limit.h"
#include "format_test.h"
#include "random_events.h"

namespace saccade::client {
namespace {

const WriterInfo& kNpzWriter = writerFor("a.npz", "npz");
const ReaderInfo& kNpzReader = readerFor("a.npz");

namespace fs = std::filesystem;

constexpr std::size_t kBlock = 1 << 16;  // events

std::string bytesOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class NpzFormatTest : public FormatTest {
 protected:
  const std::string file_ = at("a.npz");

  Events read() const { return readBack(*kNpzReader.make(file_)); }
  std::string faultOf() const { return FormatTest::faultOf(kNpzReader, file_); }
};

TEST_F(NpzFormatTest, EventsAndSizeComeBack) {
  const Events events{{0, 0, 0, 1}, {0, 1279, 719, 0}, {1'700'000'000'123'456'000, 7, 8, 0}};
  write(kNpzWriter, file_, {events}, events.back().t_ns, aboutOf(1280, 720));
  const auto reader = kNpzReader.make(file_);
  EXPECT_EQ(reader->size().width, 1280u);
  EXPECT_EQ(reader->size().height, 720u);
  EXPECT_EQ(readBack(*reader), events);
}

TEST_F(NpzFormatTest, AFileMayHaveNoEvents) {
  write(kNpzWriter, file_, {}, 5'000'000, aboutOf(4, 3));
  EXPECT_TRUE(read().empty());
}

TEST_F(NpzFormatTest, LabelsAreArraysBesideTheSameEvents) {
  Events events = randomEvents(kBlock + 77, 640, 480);
  write(kNpzWriter, file_, {events}, 0, aboutOf(640, 480));
  EXPECT_FALSE(kNpzReader.make(file_)->labels());
  const std::string plain = bytesOf(file_);
  std::vector<std::int64_t> sources, odds, read_sources, read_odds;
  for (std::size_t i = 0; i < events.size(); ++i) {
    sources.push_back(events[i].source = i % 3 == 0);
    odds.push_back(events[i].artefact = i % 129);
  }
  v1::Recording about = aboutOf(640, 480);
  write(kNpzWriter, file_, {events}, 0, about);
  EXPECT_EQ(bytesOf(file_), plain);  // where they are not asked for
  about.set_labels(true);
  write(kNpzWriter, file_, {events}, 0, about);
  const ZipArchive archive = openZip(file_);
  NpyColumn(file_, archive, {"source"}).read(events.size(), read_sources);
  NpyColumn(file_, archive, {"artefact"}).read(events.size(), read_odds);
  EXPECT_EQ(read_sources, sources);
  EXPECT_EQ(read_odds, odds);
  EXPECT_TRUE(kNpzReader.make(file_)->labels());
  EXPECT_EQ(read(), events);
}

TEST_F(NpzFormatTest, BatchesOfAnySizeJoin) {
  const Events events = randomEvents(5 * kBlock + 77, 640, 480);
  std::vector<Events> batches;
  for (std::size_t begin = 0, size = 1; begin < events.size(); begin += size, size = size * 3 + 1) {
    const auto end = std::min(begin + size, events.size());
    batches.emplace_back(events.begin() + begin, events.begin() + end);
  }
  write(kNpzWriter, file_, batches, 0, aboutOf(640, 480));
  EXPECT_EQ(read(), events);
}

TEST_F(NpzFormatTest, NothingElseIsLeftInTheFolder) {
  const auto files = [&] {
    const fs::directory_iterator folder(fs::path(file_).parent_path());
    return std::distance(begin(folder), end(folder));
  };
  const auto writer = kNpzWriter.make(file_, aboutOf(640, 480));
  writer->write(randomEvents(2 * kBlock, 640, 480), 0);
  EXPECT_EQ(files(), 1);
  writer->finish();
  EXPECT_EQ(files(), 1);
}

// More than a block of a move in each column.
TEST_F(NpzFormatTest, AFullDiskKeepsTheBatchesBefore) {
  Events events = randomEvents(20'000, 640, 480);
  for (Event& event : events) event.t_ns = 0;  // so that x fails, after t
  const auto writer = kNpzWriter.make(file_, aboutOf(640, 480));
  std::size_t batches = 0;
  {
    const FileSizeLimit limit(2'500'000);
    EXPECT_THROW(for (;; ++batches) writer->write(events, 0), std::system_error);
  }
  writer->finish();
  Events expected;
  for (std::size_t i = 0; i < batches; ++i) expected.insert(expected.end(), events.begin(), events.end());
  EXPECT_GT(batches, 20u);
  EXPECT_EQ(read(), expected);
}

TEST_F(NpzFormatTest, ADiskThatIsFullAtTheStartIsTold) {
  const FileSizeLimit limit(1'000'000);
  try {
    kNpzWriter.make(file_, aboutOf(640, 480));
    FAIL() << "there is no room";
  } catch (const std::system_error& error) {
    EXPECT_EQ(std::string(error.what()).find(file_ + ": "), 0u) << error.what();
  }
}

TEST_F(NpzFormatTest, AnInterruptedRecordingCanBeRead) {
  const Events events = randomEvents(1000, 640, 480);
  {
    RecordingFile recording(file_, kNpzWriter, {aboutOf(640, 480)});
    recording.sensor(0).write(events, 0, events.back().t_ns + 1000);
  }
  fs::rename(file_ + ".partial", file_);
  EXPECT_EQ(read(), events);
}

TEST_F(NpzFormatTest, DamagedFilesAreRefused) {
  write(kNpzWriter, file_, {randomEvents(1000, 640, 480)}, 0, aboutOf(640, 480));
  std::string bytes(fs::file_size(file_), '\0');
  std::ifstream(file_, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto faultOfBytes = [&](const std::string& changed) {
    std::ofstream(file_, std::ios::binary) << changed;
    return faultOf();
  };
  std::string changed = bytes;
  changed.replace(bytes.size() / 2, 20, std::string(20, 'x'));
  EXPECT_NE(faultOfBytes(changed).find(file_ + ": "), std::string::npos);
  changed = bytes;
  changed[400] ^= 1;  // within a block of t
  EXPECT_NE(faultOfBytes(changed).find(file_ + ": t.npy: "), std::string::npos) << faultOf();
  EXPECT_NE(faultOfBytes(bytes.substr(0, bytes.size() - 1)).find("is not a whole zip archive"),
            std::string::npos);
  EXPECT_NE(faultOfBytes("").find("is not a whole zip archive"), std::string::npos);
  fs::remove(file_);
  EXPECT_THROW(read(), std::system_error);
}

// A hole of the file stands for the members before: libzip has to find the one at its end.
TEST_F(NpzFormatTest, OffsetsBeyondFourGibAreWritten) {
  ZipMember small = zipMember("small", "events");
  small.offset = 5'000'000'000;
  ZipMember large{"large", false, 0, 6'000'000'000, 6'000'000'000, 0};
  const std::string end = zipHeader(small) + "events";
  OutputFile file(file_);
  file.overwrite(0, zipHeader(large));
  file.overwrite(small.offset, end);
  file.overwrite(small.offset + end.size(), zipDirectory({large, small}, small.offset + end.size()));
  file.close();
  int fault = 0;
  zip_t* archive = zip_open(file_.c_str(), ZIP_RDONLY, &fault);
  ASSERT_TRUE(archive) << fault;
  zip_stat_t stat;
  EXPECT_EQ(zip_stat(archive, "large", 0, &stat), 0);
  EXPECT_EQ(stat.size, 6'000'000'000u);
  EXPECT_EQ(stat.comp_size, 6'000'000'000u);
  char text[7] = "";
  zip_file_t* member = zip_fopen(archive, "small", 0);
  ASSERT_TRUE(member) << zip_strerror(archive);
  EXPECT_EQ(zip_fread(member, text, sizeof text), 6);
  EXPECT_STREQ(text, "events");
  zip_fclose(member);
  zip_discard(archive);
}

// Headers as numpy.lib.format writes them, and as its specification allows them.
TEST(NpyHeader, TakesOneColumnOrOneNumber) {
  const auto column = parseNpyHeader("{'descr': '<u2', 'fortran_order': False, 'shape': (1234567,), }   \n");
  ASSERT_TRUE(column);
  EXPECT_EQ(column->fields.at(0).kind, 'u');
  EXPECT_EQ(column->fields.at(0).order, '<');
  EXPECT_EQ(column->element_bytes, 2u);
  EXPECT_EQ(column->length, 1234567u);
  EXPECT_EQ(parseNpyHeader("{'shape': (3L,),'descr':'|b1','fortran_order': True}")->length, 3u);
  EXPECT_FALSE(parseNpyHeader("{'descr': '<i8', 'fortran_order': False, 'shape': (), }")->length);
  for (const char* other :
       {"{'descr': '<i8', 'fortran_order': False, 'shape': (3, 4, 5), }",
        "{'descr': '<i8', 'fortran_order': False, 'shape': (3, 65), }",
        "{'descr': [('x', '<i2', (2,))], 'fortran_order': False, 'shape': (3,), }",
        "{'descr': [], 'fortran_order': False, 'shape': (3,), }", "{'descr': '<i8', 'fortran_order': False}",
        "", "{'descr': '<i8', 'shape': (9999999999999999999,)}"})
    EXPECT_FALSE(parseNpyHeader(other)) << other;
}

TEST(NpyHeader, TakesATableAndStructures) {
  const auto table = parseNpyHeader("{'descr': '<f8', 'fortran_order': True, 'shape': (3, 4), }");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->length, 3u);
  EXPECT_EQ(table->columns, 4u);
  EXPECT_TRUE(table->by_columns);
  const auto structures = parseNpyHeader(
      "{'descr': [('x', '<u2'), ('', '|V6'), ('t', '<i8')], 'fortran_order': False, 'shape': (3,), }");
  ASSERT_TRUE(structures);
  EXPECT_EQ(structures->element_bytes, 16u);
  ASSERT_EQ(structures->fields.size(), 3u);
  EXPECT_EQ(structures->fields[2].name, "t");
  EXPECT_EQ(structures->fields[2].offset, 8u);
}

}  // namespace
}  // namespace saccade::client
