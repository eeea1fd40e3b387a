#include "client/recording/recording_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "client/recording/sidecar.h"
#include "format_test.h"

namespace saccade::client {
namespace {

const WriterInfo& kCsvWriter = writerFor("a.csv", "csv");
const ReaderInfo& kCsvReader = readerFor("a.csv");

namespace fs = std::filesystem;

// Python: hashlib.blake2b(struct.pack('<qHHB', 5, 1, 2, 1) + struct.pack('<qHHB', 70000, 345, 259, 0),
// digest_size=32).hexdigest()
constexpr const char* kDigest = "487be9eaa7e0fa674afca5afd891b039afd440bc28f50a3b7d05eb498017fa00";
const Events kEvents{{5000, 1, 2, 1}, {70'000'000, 345, 259, 0}};

using RecordingFileTest = FormatTest;

TEST(EventDigest, IsThatOfAnotherProgramHoweverTheEventsCome) {
  EventDigest whole, parts;
  whole.add(kEvents);
  parts.add({kEvents[0]});
  parts.add({});
  parts.add({kEvents[1]});
  EXPECT_EQ(whole.hex(), kDigest);
  EXPECT_EQ(parts.hex(), kDigest);
}

TEST_F(RecordingFileTest, SaysBesideTheFileWhatIsKnownOfIt) {
  v1::Recording about = aboutOf(346, 260);
  about.mutable_request()->set_scene("cornell-box");
  about.mutable_request()->set_seed(18446744073709551615u);
  about.set_instruction_set("avx2");
  RecordingFile file(at("a.csv"), kCsvWriter, {about});
  file.sensor(0).write(kEvents, 2000, 80'000'000);
  file.sensor(0).write({}, 80'000'000, 90'000'000);
  EXPECT_FALSE(fs::exists(at("a.csv")));
  file.close();
  file.commit();
  EXPECT_FALSE(fs::exists(at("a.csv.partial")));
  const auto recording = recordingOf(at("a.csv"));
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->width(), 346u);
  EXPECT_EQ(recording->begin_ns(), 2000);
  EXPECT_EQ(recording->end_ns(), 90'000'000);
  EXPECT_EQ(recording->events(), 2u);
  EXPECT_EQ(recording->digest(), kDigest);
  EXPECT_EQ(recording->request().scene(), "cornell-box");
  EXPECT_EQ(recording->request().seed(), 18446744073709551615u);
  EXPECT_EQ(recording->instruction_set(), "avx2");
}

TEST_F(RecordingFileTest, WithoutAnEndStaysPartialAndHasNoJson) {
  { RecordingFile(at("a.csv"), kCsvWriter, {aboutOf(4, 3)}).sensor(0).write({{1000, 1, 2, 1}}, 0, 2000); }
  EXPECT_FALSE(fs::exists(at("a.csv")));
  EXPECT_FALSE(fs::exists(at("a.csv.json")));
  const auto reader = kCsvReader.make(at("a.csv.partial"));
  EXPECT_EQ(readBack(*reader), (Events{{1000, 1, 2, 1}}));
}

TEST_F(RecordingFileTest, StandardOutputHasNoJson) {
  testing::internal::CaptureStdout();
  RecordingFile file(kStandardOutput, kCsvWriter, {aboutOf(4, 3)});
  file.sensor(0).write({{1000, 1, 2, 1}}, 0, 2000);
  file.close();
  file.commit();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "t,x,y,p\n1,1,2,1\n");
  EXPECT_FALSE(fs::exists("-.json"));
}

TEST_F(RecordingFileTest, AFaultInTheJsonNamesTheFile) {
  std::ofstream(at("a.csv.json")) << "{\"width\": \"wide\"}";
  try {
    recordingOf(at("a.csv"));
    FAIL() << "no fault";
  } catch (const FileFault& fault) {
    EXPECT_NE(std::string(fault.what()).find("a.csv.json: is not the description"), std::string::npos);
  }
  EXPECT_FALSE(recordingOf(at("b.csv")));
  EXPECT_THROW(readSidecar(at("b.csv.json")), std::system_error);
}

}  // namespace
}  // namespace saccade::client
