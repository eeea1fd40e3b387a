#include "client/recording/recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "client/formats/common/reader.h"
#include "client/recording/sidecar.h"
#include "file_size_limit.h"
#include "random_events.h"
#include "saccade/stream_fault.h"
#include "scratch_folder.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

class RecorderTest : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_.at(name); }

  std::string textOf(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(at(name)).rdbuf();
    return text.str();
  }

  const ScratchFolder folder_;
};

DecodedPacket batchOf(std::uint32_t sensor, v1::Kind kind, Events events) {
  DecodedPacket batch;
  batch.header.set_sensor(sensor);
  batch.header.set_kind(kind);
  batch.header.set_t1_ns(3'000'000'000);
  batch.events = std::move(events);
  return batch;
}

v1::StreamOpened streamOf(int sensors) {
  v1::StreamOpened opened;
  opened.mutable_resolved()->mutable_view()->set_width(346);
  opened.mutable_resolved()->mutable_view()->set_height(260);
  for (int i = 0; i < sensors; ++i) opened.mutable_resolved()->add_sensors();
  return opened;
}

const Events kEvents{{0, 1, 2, 1}, {1'234'567'000, 345, 259, 0}, {2'000'000'000, 0, 0, 1}};

TEST_F(RecorderTest, WritesCsv) {
  Recorder recorder(at("a.csv"), writerFor("a.csv"), streamOf(1));
  recorder.add(batchOf(0, v1::KIND_EVENTS, kEvents));
  recorder.add(batchOf(0, v1::KIND_END, {}));
  recorder.commit();
  EXPECT_EQ(textOf("a.csv"), "t,x,y,p\n0,1,2,1\n1234567,345,259,0\n2000000,0,0,1\n");
}

TEST_F(RecorderTest, WritesTxtWithTheSizeFirst) {
  Recorder recorder(at("a.txt"), writerFor("a.txt"), streamOf(1));
  recorder.add(batchOf(0, v1::KIND_EVENTS, kEvents));
  recorder.add(batchOf(0, v1::KIND_END, {}));
  recorder.commit();
  EXPECT_EQ(textOf("a.txt"), "346 260\n0.000000000 1 2 1\n1.234567000 345 259 0\n2.000000000 0 0 1\n");
}

TEST_F(RecorderTest, FileGetsItsNameAtACompleteEnd) {
  Recorder recorder(at("a.csv"), writerFor("a.csv"), streamOf(1));
  recorder.add(batchOf(0, v1::KIND_EVENTS, kEvents));
  EXPECT_FALSE(recorder.complete());
  EXPECT_FALSE(fs::exists(at("a.csv")));
  EXPECT_EQ(recorder.files(), std::vector{at("a.csv.partial")});
  recorder.add(batchOf(0, v1::KIND_END, {}));
  EXPECT_TRUE(recorder.complete());
  recorder.commit();
  EXPECT_EQ(recorder.files(), std::vector{at("a.csv")});
  EXPECT_FALSE(fs::exists(at("a.csv.partial")));
}

TEST_F(RecorderTest, EventsBeforeAFaultAreKept) {
  {
    Recorder recorder(at("a.csv"), writerFor("a.csv"), streamOf(1));
    recorder.add(batchOf(0, v1::KIND_EVENTS, {{5000, 1, 2, 0}}));
  }
  EXPECT_EQ(textOf("a.csv.partial"), "t,x,y,p\n5,1,2,0\n");
}

TEST_F(RecorderTest, SeveralSensorsHaveAFileEach) {
  Recorder recorder(at("a.b.csv"), writerFor("a.b.csv"), streamOf(2));
  recorder.add(batchOf(1, v1::KIND_EVENTS, {{5000, 1, 2, 0}}));
  recorder.add(batchOf(1, v1::KIND_END, {}));
  EXPECT_FALSE(recorder.complete());
  EXPECT_EQ(recorder.time_ns(), 0);  // nothing is known of sensor 0
  recorder.add(batchOf(0, v1::KIND_END, {}));
  ASSERT_TRUE(recorder.complete());
  recorder.commit();
  EXPECT_EQ(textOf("a.b-0.csv"), "t,x,y,p\n");
  EXPECT_EQ(textOf("a.b-1.csv"), "t,x,y,p\n5,1,2,0\n");
  EXPECT_EQ(recorder.events(), 1u);
}

TEST_F(RecorderTest, SeveralSensorsShareAFileOfAFormatThatHoldsThem) {
  for (const char* name : {"a.bag", "a.h5", "a.mcap"}) {
    Recorder recorder(at(name), writerFor(name), streamOf(2));
    recorder.add(batchOf(1, v1::KIND_EVENTS, {{5000, 1, 2, 0}}));
    for (const std::uint32_t sensor : {0, 1}) recorder.add(batchOf(sensor, v1::KIND_END, {}));
    EXPECT_EQ(recorder.files(), std::vector{at(name) + ".partial"});
    recorder.commit();
    EXPECT_EQ(recorder.files(), std::vector{at(name)});
    EXPECT_FALSE(fs::exists(at(name) + ".partial"));
    EXPECT_EQ(recordingOf(at(name))->events(), 0u);
    EXPECT_EQ(recordingOf(at(name) + ".sensor1")->events(), 1u);
    EXPECT_EQ(recordingOf(at(name) + ".sensor1")->sensor(), 1u);
  }
}

TEST_F(RecorderTest, ASharedFileKeepsTheEventsBeforeAFault) {
  std::vector<std::uintmax_t> sizes;
  for (const std::size_t events : {0, 1000}) {
    {
      Recorder recorder(at("a.bag"), writerFor("a.bag"), streamOf(2));
      recorder.add(batchOf(1, v1::KIND_EVENTS, Events(events, {5000, 1, 2, 0})));
    }
    sizes.push_back(fs::file_size(at("a.bag.partial")));
    EXPECT_FALSE(fs::exists(at("a.bag.sensor1.json")));
  }
  EXPECT_GT(sizes[1], sizes[0] + 13'000);  // 13 bytes for each event
}

TEST_F(RecorderTest, ASensorNobodyAskedForIsAFault) {
  Recorder recorder(at("a.csv"), writerFor("a.csv"), streamOf(1));
  EXPECT_THROW(recorder.add(batchOf(1, v1::KIND_EVENTS, {})), StreamFault);
}

TEST_F(RecorderTest, UnknownFormatNamesTheKnown) {
  try {
    Recorder recorder(at("a.xyz"), writerFor("a.xyz"), streamOf(1));
    FAIL() << "a writer for .xyz";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    for (const WriterInfo* writer : writerTable()) EXPECT_NE(text.find(writer->extension), std::string::npos);
  }
}

TEST_F(RecorderTest, ARecordingMayBeginInTheMiddleOfAFeed) {
  Recorder recorder(at("a.csv"), writerFor("a.csv"), streamOf(2));
  EXPECT_EQ(recorder.duration_ns(), 0);
  DecodedPacket batch = batchOf(0, v1::KIND_EVENTS, {});
  batch.header.set_t0_ns(2'900'000'000);
  recorder.add(batch);
  EXPECT_EQ(recorder.duration_ns(), 0);  // nothing is known of sensor 1
  batch.header.set_sensor(1);
  recorder.add(batch);
  EXPECT_EQ(recorder.time_ns(), 3'000'000'000);
  EXPECT_EQ(recorder.duration_ns(), 100'000'000);
}

TEST_F(RecorderTest, SnapshotsAndHeartbeatsLeaveNoTrace) {
  Recorder recorder(at("a.csv"), writerFor("a.csv"), streamOf(1));
  DecodedPacket snapshot = batchOf(0, v1::KIND_SNAPSHOT, {});
  snapshot.header.set_t0_ns(3'000'000'000);
  snapshot.pixels = {{0.5f}, {0.25f}};
  recorder.add(snapshot);
  DecodedPacket heartbeat = batchOf(0, v1::KIND_HEARTBEAT, {});
  heartbeat.header.set_t1_ns(9'000'000'000);  // rendered, not received
  recorder.add(heartbeat);
  EXPECT_EQ(recorder.time_ns(), 3'000'000'000);
  EXPECT_EQ(recorder.duration_ns(), 0);
  recorder.add(batchOf(0, v1::KIND_END, {}));
  recorder.commit();
  EXPECT_EQ(textOf("a.csv"), "t,x,y,p\n");
}

// A folder of the final name makes the renaming of that sensor's file fail.
TEST_F(RecorderTest, AFileThatCannotGetItsNameStaysPartialAsDoTheLaterOnes) {
  Recorder recorder(at("a.csv"), writerFor("a.csv"), streamOf(3));
  for (std::uint32_t sensor : {0, 1, 2}) {
    recorder.add(batchOf(sensor, v1::KIND_EVENTS, {{5000, 1, 2, 0}}));
    recorder.add(batchOf(sensor, v1::KIND_END, {}));
  }
  fs::create_directory(at("a-1.csv"));
  EXPECT_THROW(recorder.commit(), std::system_error);
  EXPECT_EQ(recorder.files(), (std::vector{at("a-0.csv"), at("a-1.csv.partial"), at("a-2.csv.partial")}));
  for (const std::string& file : recorder.files()) {
    EXPECT_TRUE(fs::is_regular_file(file)) << file;
    EXPECT_EQ(textOf(fs::path(file).filename()), "t,x,y,p\n5,1,2,0\n");
  }
}

TEST_F(RecorderTest, StandardOutputGetsCsvAndKeepsItsName) {
  testing::internal::CaptureStdout();
  Recorder recorder(kStandardOutput, writerFor(kStandardOutput), streamOf(1));
  recorder.add(batchOf(0, v1::KIND_EVENTS, {{5000, 1, 2, 0}}));
  recorder.add(batchOf(0, v1::KIND_END, {}));
  recorder.commit();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "t,x,y,p\n5,1,2,0\n");
  EXPECT_EQ(recorder.files(), std::vector<std::string>{"-"});
}

TEST_F(RecorderTest, AFolderThatIsNotThereIsNamed) {
  try {
    Recorder recorder(at("none/a.csv"), writerFor("none/a.csv"), streamOf(1));
    FAIL() << "there is no folder";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("none/a.csv"), std::string::npos);
  }
}

TEST_F(RecorderTest, AFullDiskLeavesWholeLinesAndAsManyAsAreTold) {
  Recorder recorder(at("a.csv"), writerFor("a.csv"), streamOf(1));
  const DecodedPacket batch = batchOf(0, v1::KIND_EVENTS, kEvents);
  {
    const FileSizeLimit limit(100'001);
    EXPECT_THROW(while (true) recorder.add(batch), std::system_error);
  }
  const std::string text = textOf("a.csv.partial");
  EXPECT_GT(recorder.events(), 1000u);
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::ptrdiff_t(1 + recorder.events()));
}

TEST_F(RecorderTest, TheSecondOfTwoOnOneFileIsRefusedAndHarmsNothing) {
  for (const std::string name : {"a.csv", "a.raw", "a.h5", "a.aedat4", "a.npz", "a.mcap", "a.bag"}) {
    Recorder first(at(name), writerFor(name), streamOf(1));
    first.add(batchOf(0, v1::KIND_EVENTS, kEvents));
    const std::string before = textOf(name + ".partial");
    try {
      Recorder second(at(name), writerFor(name), streamOf(1));
      ADD_FAILURE() << name << ": two write it";
    } catch (const std::system_error& error) {
      EXPECT_NE(std::string(error.what()).find(name + ".partial: another program is writing it"),
                std::string::npos)
          << error.what();
    }
    EXPECT_EQ(textOf(name + ".partial"), before) << name;
    first.add(batchOf(0, v1::KIND_END, {}));
    first.commit();
    EXPECT_NO_THROW(Recorder(at(name), writerFor(name), streamOf(1)));
  }
}

TEST_F(RecorderTest, TheSecondOfTwoRigsOnOneFileIsRefused) {
  for (const std::string name : {"a.csv", "a.h5", "a.npz", "a.mcap", "a.bag"}) {
    const Recorder first(at(name), writerFor(name), streamOf(2));
    EXPECT_THROW(Recorder(at(name), writerFor(name), streamOf(2)), std::system_error) << name;
    EXPECT_TRUE(isBeingWritten(first.files().back())) << name;
  }
  EXPECT_FALSE(isBeingWritten(at("none")));
}

// Columns of a .npz wait in files of their own, and a bound of one file is no full disk for them.
TEST_F(RecorderTest, AFullDiskKeepsAsManyEventsAsAreTold) {
  for (const std::string name : {"a.csv", "a.txt", "a.raw", "a.h5", "a.aedat4", "a.bag", "a.mcap"}) {
    auto recorder = std::make_unique<Recorder>(at(name), writerFor(name), streamOf(1));
    std::uint64_t told = 0;
    {
      const FileSizeLimit limit(5'000'000);
      std::int64_t t_ns = 0;
      const auto next = [&t_ns] {
        DecodedPacket batch = batchOf(0, v1::KIND_EVENTS, randomEvents(20'000, 346, 260));
        for (Event& event : batch.events) event.t_ns += t_ns;
        t_ns = batch.events.back().t_ns + 1000;
        batch.header.set_t1_ns(t_ns);
        return batch;
      };
      EXPECT_THROW(while (true) recorder->add(next()), std::system_error) << name;
      told = recorder->salvage();
    }
    recorder.reset();
    fs::rename(at(name + ".partial"), at(name));
    const auto reader = readerFor(at(name)).make(at(name));
    std::uint64_t read = 0;
    for (Events batch; reader->read(batch);) read += batch.size();
    EXPECT_EQ(read, told) << name;
    EXPECT_GT(told, 100'000u) << name;
  }
}

}  // namespace
}  // namespace saccade::client
