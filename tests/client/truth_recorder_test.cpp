// The recorder with truth channels.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "client/recording/recorder.h"
#include "saccade/stream_fault.h"
#include "scratch_folder.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHead = "t_us,a,b\n";

v1::TruthInfo infoOf(const std::string& name, v1::Layout layout, const std::vector<std::string>& planes) {
  v1::TruthInfo info;
  info.set_name(name);
  info.set_layout(layout);
  info.set_element(v1::ELEMENT_F32);
  info.mutable_planes()->Assign(planes.begin(), planes.end());
  return info;
}

class TruthRecorder : public testing::Test {
 protected:
  TruthRecorder() {
    *server_.add_truth() = infoOf("rows", v1::LAYOUT_ROWS, {"a", "b"});
    *server_.add_truth() = infoOf("depth", v1::LAYOUT_PICTURE, {"z"});
    stream_.mutable_resolved()->mutable_view()->set_width(2);
    stream_.mutable_resolved()->mutable_view()->set_height(1);
    stream_.mutable_resolved()->add_sensors();
  }
  void ask(const std::string& name) { stream_.mutable_resolved()->add_truth()->set_name(name); }
  Recorder record(const std::string& name) const {
    return Recorder(folder_.at(name), writerFor(name), stream_, server_);
  }
  std::string textOf(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_.at(name)).rdbuf();
    return text.str();
  }

  const ScratchFolder folder_;
  v1::ServerDescription server_;
  v1::StreamOpened stream_;
};

DecodedPacket endOf(std::uint32_t channel) {
  DecodedPacket batch;
  batch.header.set_sensor(channel);
  batch.header.set_kind(v1::KIND_END);
  return batch;
}

// A packet of `rows`, as channel 1, with a row for each time.
DecodedPacket rowsAt(const std::vector<std::int64_t>& times_ns) {
  DecodedPacket batch;
  batch.header.set_sensor(1);
  batch.header.set_kind(v1::KIND_TRUTH);
  batch.header.set_layout(v1::LAYOUT_ROWS);
  batch.header.set_element(v1::ELEMENT_F32);
  batch.header.set_planes(2);
  const float row[] = {0.25f, -1e-7f};
  for (const std::int64_t t_ns : times_ns)
    batch.truth.push_back({t_ns, std::string(reinterpret_cast<const char*>(row), sizeof row)});
  return batch;
}

TEST_F(TruthRecorder, EndsWithItsLastChannel) {
  ask("rows"), ask("depth");
  Recorder recorder = record("a.csv");
  recorder.add(endOf(0));
  recorder.add(endOf(2));
  EXPECT_FALSE(recorder.complete());
  recorder.add(endOf(1));
  EXPECT_TRUE(recorder.complete());
}

TEST_F(TruthRecorder, CountsSamplesAndNamesTheirPlace) {
  ask("rows");
  Recorder recorder = record("a.csv");
  recorder.add(rowsAt({0, 1'500'000}));
  recorder.add(rowsAt({2'000'000}));
  EXPECT_EQ(recorder.truthPlace(), folder_.at("a.csv.partial.truth"));
  recorder.add(endOf(0)), recorder.add(endOf(1));
  recorder.commit();
  EXPECT_EQ(recorder.truthPlace(), folder_.at("a.csv.truth"));
  EXPECT_EQ(recorder.about(0).truth(0).samples(), 3u);
  EXPECT_EQ(textOf("a.csv.truth/rows.csv"),
            kHead + std::string("0,0.25,-1e-07\n1500,0.25,-1e-07\n2000,0.25,-1e-07\n"));
  EXPECT_FALSE(fs::exists(folder_.at("a.csv.partial.truth")));
}

TEST_F(TruthRecorder, AnInterruptedRecordingKeepsWhatArrived) {
  ask("rows");
  for (const char* name : {"a.csv", "a.npz", "a.h5", "a.bag", "a.mcap"}) {
    {
      Recorder recorder = record(name);
      recorder.add(rowsAt({0}));
    }
    EXPECT_FALSE(fs::exists(folder_.at(name)));
    EXPECT_TRUE(fs::exists(folder_.at(name) + ".partial")) << name;
  }
  for (const char* name : {"a.csv", "a.bag", "a.mcap"})
    EXPECT_EQ(textOf(name + std::string(".partial.truth/rows.csv")), kHead + std::string("0,0.25,-1e-07\n"))
        << name;
}

TEST_F(TruthRecorder, NamesOfIdsGoWithTheSensorThatHasThem) {
  *server_.add_truth() = infoOf("ids", v1::LAYOUT_PICTURE, {"object", "material"});
  stream_.mutable_id_names()->add_objects("door");
  stream_.mutable_resolved()->add_sensors();
  ask("ids");
  const Recorder recorder = record("a.csv");
  EXPECT_EQ(recorder.about(0).id_names().objects(0), "door");
  EXPECT_FALSE(recorder.about(1).has_id_names());
}

TEST_F(TruthRecorder, ASecondChannelOfANameGetsANumber) {
  ask("rows"), ask("depth"), ask("rows"), ask("rows");
  Recorder recorder = record("a.csv");
  std::vector<std::string> names;
  for (const v1::RecordedTruth& channel : recorder.about(0).truth()) names.push_back(channel.name());
  EXPECT_EQ(names, (std::vector<std::string>{"rows", "depth", "rows_1", "rows_2"}));
}

TEST_F(TruthRecorder, OnlyTheFirstSensorHasTheTruth) {
  stream_.mutable_resolved()->add_sensors();
  ask("rows");
  Recorder recorder = record("a.csv");
  EXPECT_EQ(recorder.about(0).truth_size(), 1);
  EXPECT_EQ(recorder.about(1).truth_size(), 0);
  DecodedPacket rows = rowsAt({0});
  rows.header.set_sensor(2);
  recorder.add(rows);
  EXPECT_EQ(recorder.about(0).truth(0).samples(), 1u);
  EXPECT_TRUE(fs::exists(folder_.at("a-0.csv.partial.truth")));
  EXPECT_FALSE(fs::exists(folder_.at("a-1.csv.partial.truth")));
}

TEST_F(TruthRecorder, SensorsOfASharedFileHaveFoldersOfTheirOwn) {
  v1::OpenStream& request = *stream_.mutable_resolved();
  *request.add_further_views() = request.view();
  request.add_sensors()->set_view(1);
  ask("rows"), ask("rows");
  request.mutable_truth(1)->set_view(1);
  Recorder recorder = record("a.bag");
  for (const std::uint32_t channel : {2, 3}) {
    DecodedPacket rows = rowsAt(std::vector<std::int64_t>(channel, 0));
    rows.header.set_sensor(channel);
    recorder.add(rows);
  }
  for (const std::uint32_t channel : {0, 1, 2, 3}) recorder.add(endOf(channel));
  recorder.commit();
  const std::string row = "0,0.25,-1e-07\n";
  EXPECT_EQ(textOf("a.bag.truth/rows.csv"), kHead + row + row);
  EXPECT_EQ(textOf("a.bag.sensor1.truth/rows.csv"), kHead + row + row + row);
  EXPECT_EQ(recorder.truthPlace(), folder_.at("a.bag.truth") + " " + folder_.at("a.bag.sensor1.truth"));
}

TEST_F(TruthRecorder, DescriptionsSayWhereTheTruthOfTheViewIs) {
  v1::OpenStream& request = *stream_.mutable_resolved();
  *request.add_further_views() = request.view();
  for (const int view : {0, 1}) request.add_sensors()->set_view(view);
  ask("rows"), ask("depth"), ask("rows");
  request.mutable_truth(2)->set_view(1);
  const auto places = [&](const std::string& name) {
    const Recorder recorder = record(name);
    std::string text;
    for (const v1::Recording& about : recorder.descriptions()) {
      for (const std::string& place : about.truth_places()) text += place + " ";
      text += "| ";
    }
    return text;
  };
  EXPECT_EQ(places("a.npz"), "a-0.npz | a-0.npz | a-2.npz | ");
  EXPECT_EQ(places("a.csv"), "a-0.csv.truth | a-0.csv.truth | a-2.csv.truth | ");
  EXPECT_EQ(places("a.h5"), "a.h5 | a.h5 | a.h5 | ");
  EXPECT_EQ(places("a.bag"), "a.bag a.bag.truth | a.bag a.bag.truth | a.bag.sensor2.truth | ");
  request.clear_truth();
  EXPECT_EQ(places("b.npz"), "| | | ");
}

TEST_F(TruthRecorder, AViewHasItsTruthInTheFileOfItsSensor) {
  v1::OpenStream& request = *stream_.mutable_resolved();
  for (const std::uint32_t width : {4u, 6u}) {
    *request.add_further_views() = request.view();
    request.mutable_further_views(request.further_views_size() - 1)->set_width(width);
  }
  for (const int view : {1, 1}) request.add_sensors()->set_view(view);  // none sees view 2
  for (const char* name : {"rows", "rows", "depth", "depth", "rows"}) ask(name);
  const std::uint32_t views[] = {0, 1, 2, 1, 2};
  for (int i = 0; i < 5; ++i) request.mutable_truth(i)->set_view(views[i]);
  Recorder recorder = record("a.csv");
  std::vector<std::string> names;
  for (int sensor = 0; sensor < 3; ++sensor)
    for (const v1::RecordedTruth& channel : recorder.about(sensor).truth())
      names.push_back(std::to_string(sensor) + channel.name() + std::to_string(channel.width()));
  EXPECT_EQ(names,
            (std::vector<std::string>{"0rows2", "0depth_view26", "0rows_view26", "1rows4", "1depth4"}));
  DecodedPacket rows = rowsAt({0});
  rows.header.set_sensor(3 + 1);
  recorder.add(rows);
  EXPECT_EQ(recorder.about(0).truth(0).samples(), 0u);
  EXPECT_EQ(recorder.about(1).truth(0).samples(), 1u);
  EXPECT_EQ(recorder.truthPlace(),
            folder_.at("a-0.csv.partial.truth") + " " + folder_.at("a-1.csv.partial.truth"));
}

TEST_F(TruthRecorder, APacketThatIsNotAsDescribedIsAFault) {
  ask("rows");
  Recorder recorder = record("a.csv");
  const auto faulty = [&](auto change) {
    DecodedPacket batch = rowsAt({0});
    change(batch.header);
    EXPECT_THROW(recorder.add(batch), StreamFault) << batch.header.ShortDebugString();
  };
  faulty([](v1::PacketHeader& h) { h.set_planes(3); });
  faulty([](v1::PacketHeader& h) { h.set_element(v1::ELEMENT_F64); });
  faulty([](v1::PacketHeader& h) { h.set_layout(v1::LAYOUT_PICTURE); });
  faulty([](v1::PacketHeader& h) { h.set_sensor(2); });
}

TEST_F(TruthRecorder, APictureOfAnotherSizeIsAFault) {
  ask("depth");
  Recorder recorder = record("a.csv");
  DecodedPacket batch = rowsAt({0});
  batch.header.set_layout(v1::LAYOUT_PICTURE);
  batch.header.set_planes(1);
  batch.header.set_width(1), batch.header.set_height(2);
  EXPECT_THROW(recorder.add(batch), StreamFault);
  batch.header.set_width(2), batch.header.set_height(1);
  recorder.add(batch);
  EXPECT_EQ(recorder.about(0).truth(0).samples(), 1u);
}

TEST_F(TruthRecorder, AChannelThatTheServerDoesNotDescribeIsAFault) {
  ask("../rows");
  EXPECT_THROW(record("a.csv"), StreamFault);
  *server_.add_truth() = infoOf("../rows", v1::LAYOUT_ROWS, {"a"});  // the name of a file elsewhere
  EXPECT_THROW(record("a.csv"), StreamFault);
}

}  // namespace
}  // namespace saccade::client
