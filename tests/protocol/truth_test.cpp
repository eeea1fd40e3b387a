// Truth channels of a stream: the same socket, order, credit and resumption as events.
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "mock/bad_request.h"
#include "objects.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

// Depth of every third frame and poses beside the events. Channel 0 is the sensor.
v1::OpenStream withTruth() {
  v1::OpenStream request = tinyRequest();
  v1::Truth& depth = *request.add_truth();
  depth.set_name("depth");
  depth.set_every(3);
  request.add_truth()->set_name("pose");
  return request;
}

TruthSamples samplesOf(const Packets& packets) {
  TruthSamples all;
  std::int64_t t = 0;
  for (const Received& packet : packets) {
    PacketContent content;
    EXPECT_EQ(decodePacket(packet.header, packet.payload, content), "");
    EXPECT_EQ(packet.header.t0_ns(), t);
    EXPECT_EQ(packet.header.first_event_index(), all.size());
    t = packet.header.t1_ns();
    all.insert(all.end(), content.truth.begin(), content.truth.end());
  }
  EXPECT_EQ(packets.back().header.kind(), v1::KIND_END);
  EXPECT_EQ(t, 40'000'000);
  return all;
}

std::vector<std::int64_t> timesOf(const TruthSamples& samples) {
  std::vector<std::int64_t> times;
  for (const TruthSample& sample : samples) times.push_back(sample.t_ns);
  return times;
}

TEST(Truth, ComesOnTheClockOfTheEvents) {
  TestServer server;
  auto packets = server.run(withTruth());
  ASSERT_EQ(packets.size(), 3u);
  checkPackets(packets[0]);
  const TruthSamples depth = samplesOf(packets[1]), poses = samplesOf(packets[2]);
  EXPECT_EQ(timesOf(depth), (std::vector<std::int64_t>{0, 6'000'000, 12'000'000, 18'000'000, 24'000'000,
                                                       30'000'000, 36'000'000}));
  EXPECT_EQ(poses.size(), 21u);
  EXPECT_EQ(depth.front().elements.size(), 32u * 24 * sizeof(float));
  EXPECT_EQ(poses.front().elements.size(), 7u * sizeof(double));
}

TEST(Truth, ChangesNoEvent) {
  TestServer server;
  EXPECT_EQ(comparableBytes(server.run(withTruth())[0]), comparableBytes(server.run(tinyRequest())[0]));
}

TEST(Truth, ComesAtTheTimesAskedFor) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  v1::Truth& depth = *request.add_truth();
  depth.set_name("depth");
  for (const double t : {0.0, 0.0101, 0.0119, 0.03, 5.0}) depth.add_times_s(t);
  EXPECT_EQ(timesOf(samplesOf(server.run(request)[1])),
            (std::vector<std::int64_t>{0, 12'000'000, 30'000'000}));
}

// 500 Hz: an exposure of 6 ms is three frames.
TEST(Truth, ExposesFramesOnTheClockOfTheEvents) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  v1::Truth& truth = *request.add_truth();
  truth.set_name("frame16");
  truth.set_every(5);
  truth.mutable_aps()->set_exposure_s(0.0061);
  const TruthSamples frames = samplesOf(server.run(request)[1]);
  EXPECT_EQ(timesOf(frames), (std::vector<std::int64_t>{10'000'000, 20'000'000, 30'000'000, 40'000'000}));
  for (const TruthSample& frame : frames) {
    EXPECT_EQ(frame.exposure_begin_ns, frame.t_ns - 6'000'000);
    EXPECT_EQ(frame.exposure_end_ns, frame.t_ns);
    EXPECT_EQ(frame.elements.size(), 32u * 24 * 2);
  }
}

// One object moves, so that channels of objects have a row for each frame. The IMU has times of its own.
// Forward flow of a frame comes with the next frame, and that of the last frame never comes.
TEST(Truth, EveryChannelOfTheListComes) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  addMotion(request, "tall_block", v1::OBJECT_MOTION_KIND_SPIN, 90);
  for (const TruthChannelInfo& info : truthTable()) request.add_truth()->set_name(info.name);
  auto packets = server.run(request);
  ASSERT_EQ(packets.size(), 1 + truthTable().size());
  for (std::size_t i = 0; i < truthTable().size(); ++i) {
    const std::string& name = truthTable()[i].name;
    const std::vector<std::int64_t> times = timesOf(samplesOf(packets[i + 1]));
    if (name == "imu") continue;
    const bool first = name != "flow_backward" && !name.starts_with("frame"), last = name != "flow_forward";
    ASSERT_EQ(times.size(), 19u + first + last) << name;
    EXPECT_EQ(times.front(), first ? 0 : 2'000'000) << name;
    EXPECT_EQ(times.back(), last ? 40'000'000 : 38'000'000) << name;
  }
}

TEST(Truth, TheReplyNamesTheNumbersOfIds) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  EXPECT_FALSE(server.client().open(request).has_id_names());
  request.add_truth()->set_name("ids");
  const v1::IdNames names = server.client().open(request).id_names();
  EXPECT_EQ(names.objects_size(), 8);
  EXPECT_EQ(names.materials_size(), 4);
  const TruthSample ids = samplesOf(server.run(request)[1]).front();
  std::vector<std::uint32_t> numbers(ids.elements.size() / sizeof(std::uint32_t));
  std::memcpy(numbers.data(), ids.elements.data(), ids.elements.size());
  std::set<std::pair<std::string, std::string>> seen;
  for (std::size_t i = 0, pixels = numbers.size() / 2; i < pixels; ++i)
    seen.emplace(names.objects(static_cast<int>(numbers[i]) - 1),
                 names.materials(static_cast<int>(numbers[pixels + i]) - 1));
  for (const auto& [object, material] : {std::pair("floor", "white"), std::pair("left_wall", "red")})
    EXPECT_TRUE(seen.contains({object, material})) << object;
}

TEST(Truth, GoesOnFromASample) {
  TestServer before, again;
  v1::OpenStream request = withTruth();
  const TruthSamples whole = samplesOf(before.run(request)[1]);
  request.mutable_sensors(0)->set_from_event(1);
  request.mutable_truth(0)->set_from_sample(4);
  request.mutable_truth(1)->set_from_sample(1000);
  auto rest = again.run(request);
  ASSERT_EQ(rest[1].size(), 5u);  // three pictures, the time after the last one, and END
  EXPECT_EQ(rest[1].front().header.first_event_index(), 4u);
  PacketContent content;
  EXPECT_EQ(decodePacket(rest[1].front().header, rest[1].front().payload, content), "");
  EXPECT_EQ(content.truth, TruthSamples{whole[4]});
  EXPECT_EQ(rest[2].size(), 1u);
}

TEST(Truth, IsRefusedByField) {
  TestServer server;
  const v1::OpenStream good = withTruth();
  using Open = v1::OpenStream;
  expectRefused(server, {{good, [](Open& r) { r.mutable_truth(1)->set_name("dept"); },
                          v1::CODE_INVALID_ARGUMENT, "truth[1].name", "there are: depth"},
                         {good, [](Open& r) { r.mutable_truth(0)->add_times_s(1); },
                          v1::CODE_INVALID_ARGUMENT, "truth[0].times_s", "either"},
                         {good,
                          [](Open& r) {
                            r.mutable_truth(1)->add_times_s(1);
                            r.mutable_truth(1)->add_times_s(1);
                          },
                          v1::CODE_INVALID_ARGUMENT, "truth[1].times_s", "do not increase"},
                         {good, [](Open& r) { r.mutable_truth(0)->set_bias(1); }, v1::CODE_INVALID_ARGUMENT,
                          "truth[0].bias", "depth has no bias"},
                         {good, [](Open& r) { r.mutable_truth(1)->mutable_aps(); }, v1::CODE_INVALID_ARGUMENT,
                          "truth[1].aps", "pose has no exposure"},
                         {good,
                          [](Open& r) {
                            r.mutable_truth(0)->set_name("frame");
                            r.mutable_truth(0)->mutable_aps()->set_exposure_s(0);
                          },
                          v1::CODE_INVALID_ARGUMENT, "truth[0].aps.exposure_s", "0"},
                         {good,
                          [](Open& r) {
                            r.mutable_truth(0)->set_name("frame");
                            r.mutable_truth(0)->mutable_aps()->set_gamma(0);
                          },
                          v1::CODE_INVALID_ARGUMENT, "truth[0].aps.gamma", "0"},
                         {good,
                          [](Open& r) {
                            r.mutable_truth(0)->set_name("brightness");
                            r.mutable_truth(0)->set_bias(0);
                          },
                          v1::CODE_INVALID_ARGUMENT, "truth[0].bias", "0"},
                         {good, [](Open& r) { r.mutable_truth(1)->add_times_s(-1); },
                          v1::CODE_INVALID_ARGUMENT, "truth[1].times_s", "-1"},
                         {good,
                          [](Open& r) {
                            for (int i = 0; i < 100'001; ++i) r.mutable_truth(1)->add_times_s(i);
                          },
                          v1::CODE_INVALID_ARGUMENT, "truth.times_s", "more than 100000"},
                         {good,
                          [](Open& r) {
                            for (int i = 0; i < 31; ++i) r.add_truth()->set_name("pose");
                          },
                          v1::CODE_INVALID_ARGUMENT, "truth", "more than 32"},
                         {good,
                          [](Open& r) {
                            r.set_delivery(v1::DELIVERY_LIVE);
                            r.mutable_truth(0)->set_from_sample(1);
                          },
                          v1::CODE_INVALID_ARGUMENT, "truth[0].from_sample", "LOSSLESS"}});
}

}  // namespace
}  // namespace saccade
