// Objects of events, and the truth about objects, against each other and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <set>

#include "mock/bad_request.h"
#include "mock/events_of.h"
#include "objects.h"

namespace saccade {
namespace {

constexpr int kWidth = 32, kHeight = 24;

v1::OpenStream withIds(v1::OpenStream request) {
  request.mutable_sensors(0)->set_object_ids(true);
  request.add_truth()->set_name("ids");
  return request;
}

// The plane `object` of each frame.
std::vector<std::vector<std::uint32_t>> objectsOf(const Packets& packets) {
  std::vector<std::vector<std::uint32_t>> planes;
  for (const TruthSample& sample : samplesOf(packets)) {
    planes.emplace_back(kWidth * kHeight);
    std::memcpy(planes.back().data(), sample.elements.data(), planes.back().size() * sizeof(std::uint32_t));
  }
  return planes;
}

TEST(ObjectIds, AreThoseOfTheNearerFrame) {
  TestServer server;
  for (v1::OpenStream request : {withIds(tinyRequest()), withIds(spinning())}) {
    auto packets = server.run(request);
    const Events events = eventsOf(packets[0]);
    const auto planes = objectsOf(packets[1]);
    EXPECT_EQ(packets[0].front().header.layout(), v1::LAYOUT_OBJECT_COLUMNS);
    EXPECT_GT(events.size(), 20u);
    std::set<std::uint32_t> seen;
    for (const Event& event : events) {
      const auto frame = static_cast<std::size_t>((event.t_ns + 1'000'000) / 2'000'000);
      EXPECT_EQ(event.object, planes.at(frame).at(event.y * kWidth + event.x)) << event.t_ns;
      seen.insert(event.object);
    }
    EXPECT_GT(seen.size(), 1u);
  }
}

TEST(ObjectIds, ChangeNoEvent) {
  TestServer server;
  Events with = eventsOf(server.run(withIds(spinning()))[0]);
  for (Event& event : with) event.object = 0;
  EXPECT_EQ(with, eventsOf(server.run(spinning())[0]));
}

TEST(ObjectIds, StandBesideLabels) {
  TestServer server;
  v1::OpenStream both = withIds(spinning()), labelled = spinning();
  both.mutable_sensors(0)->set_labels(true), labelled.mutable_sensors(0)->set_labels(true);
  Events events = eventsOf(server.run(both)[0]);
  EXPECT_TRUE(std::ranges::any_of(events, [](const Event& event) { return event.object > 0; }));
  for (Event& event : events) event.object = 0;
  EXPECT_EQ(events, eventsOf(server.run(labelled)[0]));
}

TEST(ObjectIds, AreNamedByTheReply) {
  TestServer server;
  v1::OpenStream request = spinning();
  request.mutable_sensors(0)->set_object_ids(true);
  const v1::StreamOpened opened = server.client().open(request);
  const auto& names = opened.id_names().objects();
  EXPECT_NE(std::ranges::find(names, "tall_block"), names.end());
}

TEST(ObjectIds, AStreamWithoutASceneHasNone) {
  TestServer server;
  v1::OpenStream pushed;
  pushed.set_pushed(true);
  pushed.mutable_view()->set_width(8), pushed.mutable_view()->set_height(8);
  pushed.mutable_timing()->set_frame_rate_hz(100);
  pushed.add_sensors();
  EXPECT_EQ(server.client().tryOpen(pushed).code(), v1::CODE_OK);
  pushed.mutable_sensors(0)->set_object_ids(true);
  EXPECT_EQ(server.client().tryOpen(pushed).field(), "sensors[0].object_ids");
}

// The shapes of the turntable have one number where it may move, and else a number each.
TEST(ObjectIds, ABodyHasOneNumber) {
  TestServer server;
  v1::OpenStream request = withIds(stillRequest());
  request.set_scene("cornell-turntable");
  const auto numbers = [&](const v1::OpenStream& r) {
    const v1::StreamOpened opened = server.client().open(r);
    std::map<std::string, std::set<std::uint32_t>> by_name;
    const auto planes = objectsOf(server.run(r)[1]);
    for (const std::uint32_t number : planes.front()) {
      const std::string& name = opened.id_names().objects(static_cast<int>(number) - 1);
      by_name[name.substr(0, name.find("_"))].insert(number);
    }
    return by_name.at("turntable");
  };
  EXPECT_EQ(numbers(request).size(), 1u);
  addObject(request, "turntable").mutable_still();
  EXPECT_GT(numbers(request).size(), 1u);
}

template <std::size_t N>
std::vector<std::array<double, N>> rowsOf(const Packets& packets) {
  std::vector<std::array<double, N>> rows;
  for (const TruthSample& sample : samplesOf(packets)) {
    EXPECT_EQ(sample.elements.size(), N * sizeof(double));
    std::memcpy(rows.emplace_back().data(), sample.elements.data(), N * sizeof(double));
  }
  return rows;
}

// Two objects that turn at other rates about the vertical: the first by its own centre.
TEST(ObjectTruth, PosesAndVelocitiesAreThoseOfTheFormulas) {
  TestServer server;
  v1::OpenStream request = spinning("tall_block", 90);
  addMotion(request, "light", v1::OBJECT_MOTION_KIND_SWING, 3);
  request.add_truth()->set_name("object_poses");
  request.add_truth()->set_name("object_velocities");
  auto packets = server.run(request);
  const auto poses = rowsOf<8>(packets[1]);
  const auto velocities = rowsOf<7>(packets[2]);
  ASSERT_EQ(poses.size(), 2u * 21);
  ASSERT_EQ(velocities.size(), 2u * 21);
  const v1::StreamOpened opened = server.client().open(request);
  const auto nameOf = [&](double number) { return opened.id_names().objects(static_cast<int>(number) - 1); };
  for (std::size_t frame = 0; frame < 21; ++frame) {
    const double t = 0.002 * static_cast<double>(frame), phase = std::numbers::pi * t;
    const auto &lamp = poses[2 * frame], &block = poses[2 * frame + 1];
    EXPECT_EQ(nameOf(lamp[0]), "light");
    EXPECT_EQ(nameOf(block[0]), "tall_block");
    EXPECT_NEAR(block[5], std::sin(phase / 4), 1e-9);  // half of 90 degrees per second, about y
    EXPECT_NEAR(block[7], std::cos(phase / 4), 1e-9);
    EXPECT_NEAR(lamp[1] - poses[0][1], -3 / std::numbers::pi * std::sin(phase), 1e-9);  // right is -x
    EXPECT_NEAR(velocities[2 * frame][1], -3 * std::cos(phase), 1e-9);
    EXPECT_NEAR(velocities[2 * frame + 1][5], std::numbers::pi / 2, 1e-9);
    for (int i = 1; i < 4; ++i) EXPECT_NEAR(velocities[2 * frame + 1][i], 0, 1e-9);
  }
}

TEST(ObjectTruth, IsEmptyWhereNothingMoves) {
  TestServer server;
  v1::OpenStream request = stillRequest();
  request.add_truth()->set_name("object_poses");
  EXPECT_TRUE(samplesOf(server.run(request)[1]).empty());
}

TEST(ObjectTruth, ARigOfTwoCamerasSeesOneWorld) {
  TestServer server;
  v1::OpenStream request = spinning();
  request.add_further_views()->CopyFrom(request.view());
  for (const char* name : {"object_poses", "ids"})
    for (std::uint32_t view : {0u, 1u}) {
      v1::Truth& truth = *request.add_truth();
      truth.set_name(name), truth.set_view(view);
    }
  auto packets = server.run(request);
  for (std::uint32_t channel : {1u, 3u}) {
    const TruthSamples first = samplesOf(packets[channel]), second = samplesOf(packets[channel + 1]);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].elements, second[i].elements);
  }
}

}  // namespace
}  // namespace saccade
