// Bags and MCAP files by our own writers and readers. bag_test.py and mcap_test.py take those of others.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "client/formats/ros/bag_record.h"
#include "client/formats/ros/event_array.h"
#include "format_test.h"
#include "random_events.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kUs = 1000, kSecond = 1'000'000'000;

// Sensors of two views, two of each.
std::vector<v1::Recording> rig() {
  std::vector<v1::Recording> sensors(4);
  for (std::uint32_t i = 0; i < 4; ++i) {
    v1::OpenStream& request = *sensors[i].mutable_request();
    for (v1::View* view : {request.mutable_view(), request.add_further_views()})
      view->set_width(640), view->set_height(480), view->set_fov_x_deg(60);
    for (const std::uint32_t view : {0, 0, 1, 1}) request.add_sensors()->set_view(view);
    sensors[i].set_sensor(i);
    sensors[i].set_width(640), sensors[i].set_height(480);
  }
  return sensors;
}

class RosReaderTest : public FormatTest, public testing::WithParamInterface<const char*> {
 protected:
  const std::string file_ = at(std::string("a") + GetParam());
  const WriterInfo& writer_ = writerFor(file_);

  Events read(const SensorChoice& choice = {}) const { return readBack(*openReader(file_, choice)); }
  std::string fault() const { return faultOf(readerFor(file_), file_); }
  // The sensors' events, batch by batch as a stream brings them.
  std::vector<Events> writeRig() const {
    std::vector<Events> all;
    for (int i = 0; i < 4; ++i) all.push_back(randomEvents(20'000, 640, 480));
    const Writers writers = writer_.makeJoint(file_, rig());
    for (std::size_t done = 0; done < all[0].size(); done += 1000)
      for (std::size_t i = 0; i < 4; ++i)
        writers[i]->write({all[i].begin() + done, all[i].begin() + done + 1000}, all[i][done].t_ns);
    for (const auto& writer : writers) writer->finish();
    return all;
  }
  std::string bytes() const {
    std::string bytes(fs::file_size(file_), '\0');
    std::ifstream(file_, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
  }
  void put(const std::string& bytes) const { std::ofstream(file_, std::ios::binary) << bytes; }
};

TEST_P(RosReaderTest, EventsAndSizeComeBackOverSeveralChunks) {
  const Events events = randomEvents(300'000, 640, 480);
  write(writer_, file_, {events}, 0, aboutOf(640, 480));
  const auto reader = readerFor(file_).make(file_);
  EXPECT_EQ(reader->size().width, 640u);
  EXPECT_EQ(reader->size().height, 480u);
  EXPECT_EQ(reader->leftOut(), "");
  EXPECT_EQ(readBack(*reader), events);
}

TEST_P(RosReaderTest, TimesBeforeAndInSilenceKeepTheirWraps) {
  const Events events{{100 * kSecond, 1, 2, 1}, {107 * kSecond + kUs, 3, 4, 0}, {116 * kSecond, 5, 6, 1},
                      {300 * kSecond, 7, 8, 0}, {300 * kSecond, 7, 9, 1},       {2000 * kSecond, 0, 0, 1}};
  write(writer_, file_, {events}, 0, aboutOf(640, 480));
  EXPECT_EQ(read(), events);
}

TEST_P(RosReaderTest, AFileMayHaveNoEvents) {
  write(writer_, file_, {}, 5'000'000, aboutOf(4, 3));
  const auto reader = readerFor(file_).make(file_);
  EXPECT_EQ(reader->size().width, 0u);
  EXPECT_EQ(readBack(*reader), Events());
}

TEST_P(RosReaderTest, EachSensorOfSeveralIsFoundByNumberAndTopic) {
  const std::vector<Events> all = writeRig();
  const std::string space = file_.ends_with(".bag") ? "/dvs" : "/event_camera";
  const char* topics[] = {"/events", "/events_1", "_1/events", "_1/events_1"};
  EXPECT_EQ(read(), all[0]);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(read({.sensor = i}), all[i]) << i;
    const auto reader = openReader(file_, {.topic = space + topics[i]});
    EXPECT_EQ(reader->sensor(), i);
    EXPECT_EQ(reader->name(), space + topics[i]);
    EXPECT_EQ(readBack(*reader), all[i]) << i;
  }
  const std::string left_out = openReader(file_, {.sensor = 1})->leftOut();
  for (const std::string& part : {space + "/events (--sensor 0)", space + "_1/events_1 (--sensor 3)",
                                  space + "/camera_info (sensor_msgs/"})
    EXPECT_NE(left_out.find(part), std::string::npos) << left_out;
  EXPECT_EQ(left_out.find("--sensor 1"), std::string::npos) << left_out;
}

TEST_P(RosReaderTest, AChoiceThatTheFileHasNotNamesWhatItHas) {
  writeRig();
  const auto told = [&](const SensorChoice& choice) {
    try {
      openReader(file_, choice);
    } catch (const std::invalid_argument& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  EXPECT_EQ(told({.sensor = 4}), "--sensor: '" + file_ + "' has no sensor 4; it has 0 to 3");
  EXPECT_NE(told({.topic = "/x"}).find("--topic: '" + file_ + "' has no events on '/x', but on /"),
            std::string::npos);
}

// A killed program leaves whole chunks, and part of one.
TEST_P(RosReaderTest, AFileWithoutItsEndIsReadUpToThere) {
  const Events events = randomEvents(300'000, 640, 480);
  const auto writer = writer_.make(file_, aboutOf(640, 480));
  writer->write(events, events.back().t_ns);
  const std::string written = bytes();
  put(written);
  const Events whole = read();
  EXPECT_GT(whole.size(), 100'000u);
  EXPECT_EQ(whole, Events(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(whole.size())));
  put(written.substr(0, written.size() - 100'000));
  const Events cut = read();
  EXPECT_LT(cut.size(), whole.size());
  EXPECT_EQ(cut, Events(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(cut.size())));
}

TEST_P(RosReaderTest, DamagedFilesAreRefused) {
  write(writer_, file_, {randomEvents(1000, 640, 480)}, 0, aboutOf(640, 480));
  const std::string good = bytes();
  put(good.substr(0, 5));
  EXPECT_NE(fault().find("does not begin as "), std::string::npos) << fault();
  int refused = 0;
  for (std::size_t at = 0; at < good.size(); at += 43) {
    std::string bad = good;
    bad[at] = static_cast<char>(~bad[at]);
    put(bad);
    refused += fault() != "none";
  }
  EXPECT_GT(refused, 5);
}

INSTANTIATE_TEST_SUITE_P(Formats, RosReaderTest, testing::Values(".bag", ".mcap"),
                         [](const auto& test) { return test.param + 1; });

// dvs_msgs/EventArray: seq, stamp, frame "", height, width, and one event: x, y, sec, nsec, polarity.
std::string arrayOf(std::uint8_t p) {
  std::string bytes(16, '\0');
  for (const std::uint32_t number : {3, 4, 1}) bytes.append(reinterpret_cast<const char*>(&number), 4);
  return bytes.append(12, '\0') + static_cast<char>(p);
}

TEST(EventArray, RefusesAPolarityThatIsNeither0Nor1) {
  const std::string good = arrayOf(1), bad = arrayOf(2);  // the decoder keeps a view of its message
  EventArrayDecoder decoder;
  Events events;
  decoder.begin(good);
  EXPECT_TRUE(decoder.append(events));
  EXPECT_EQ(events, (Events{{0, 0, 0, 1}}));
  decoder.begin(bad);
  try {
    decoder.append(events);
    ADD_FAILURE() << "was taken";
  } catch (const std::runtime_error& fault) {
    EXPECT_STREQ(fault.what(), "has an event of polarity 2; it is 0 or 1");
  }
}

using BagReaderTest = FormatTest;

// "#ROSBAG V2.0", the header of a bag without an index, and a chunk.
std::string bagOf(const std::string& compression, const std::string& chunk) {
  std::string bytes = "#ROSBAG V2.0\n";
  BagFields head(BagOp::kBagHeader), about(BagOp::kChunk);
  head.number<std::uint64_t>("index_pos", 0);
  about.text("compression", compression).number<std::uint32_t>("size", chunk.size());
  appendRecord(bytes, head, "");
  appendRecord(bytes, about, chunk);
  return bytes;
}

TEST_F(BagReaderTest, FaultsSayWhatIsWrongAndWhere) {
  const auto told = [&](const std::string& bytes) {
    std::ofstream(at("a.bag"), std::ios::binary) << bytes;
    return faultOf(readerFor("a.bag"), at("a.bag"));
  };
  const std::string imu = connectionRecords({{"/imu", "sensor_msgs/Imu", "6a62", ""}});
  EXPECT_EQ(told("#ROSBAG V1.2\n"),
            at("a.bag") + ": is a bag of another version than 2.0; `rosbag fix` rewrites it");
  EXPECT_EQ(told(bagOf("none", "")), at("a.bag") + ": has no topics");
  EXPECT_EQ(told(bagOf("none", imu)),
            at("a.bag") + ": has no events that can be read; its topics are /imu (sensor_msgs/Imu)");
  EXPECT_EQ(told(bagOf("none", connectionRecords({{"/e", "dvs_msgs/EventArray", "732c", ""}}))),
            at("a.bag") +
                ": has no events that can be read; its topics are /e (dvs_msgs/EventArray of another "
                "definition, 732c)");
  EXPECT_NE(
      told(bagOf("bz2", imu)).find("is compressed by bz2, which cannot be read here; `rosbag decompress`"),
      std::string::npos);
  EXPECT_NE(told(bagOf("none", imu.substr(1))).find("the record at byte "), std::string::npos);
}

}  // namespace
}  // namespace saccade::client
