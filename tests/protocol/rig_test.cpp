// Streams of several views: cameras that are fixed to one moving body.
#include <gtest/gtest.h>

#include <cstring>

#include "mock/bad_request.h"
#include "mock/events_of.h"
#include "scene/camera/pose.h"

namespace saccade {
namespace {

// A camera of another size to the right of that of tinyRequest(), and slanted, with a sensor and truth of its
// own. Channels: two sensors, depth and pose of view 1.
v1::OpenStream stereo() {
  v1::OpenStream request = tinyRequest();
  v1::View& right = *request.add_further_views();
  right.set_width(24);
  right.set_height(16);
  right.mutable_body_camera()->mutable_position()->set_x(0.3);
  right.mutable_body_camera()->mutable_rotation()->set_y(0.2);
  right.mutable_body_camera()->mutable_rotation()->set_w(2);
  *request.add_sensors() = request.sensors(0);
  request.mutable_sensors(1)->set_view(1);
  for (const char* name : {"depth", "pose"}) {
    v1::Truth& truth = *request.add_truth();
    truth.set_name(name);
    truth.set_view(1);
  }
  return request;
}

Pose poseOf(const TruthSample& sample) {
  double row[7];
  EXPECT_EQ(sample.elements.size(), sizeof row);
  std::memcpy(row, sample.elements.data(), sizeof row);
  return {{row[0], row[1], row[2]}, {row[3], row[4], row[5], row[6]}};
}

TEST(RigStream, TheFirstViewIsAsAlone) {
  TestServer server;
  auto packets = server.run(stereo());
  EXPECT_EQ(comparableBytes(packets[0]), comparableBytes(server.run(tinyRequest())[0]));
}

TEST(RigStream, EachChannelHasTheSizeOfItsView) {
  TestServer server;
  auto packets = server.run(stereo());
  ASSERT_EQ(packets.size(), 4u);
  for (const std::uint32_t channel : {1u, 2u, 3u}) {
    EXPECT_EQ(packets[channel].front().header.width(), 24u);
    EXPECT_EQ(packets[channel].front().header.height(), 16u);
  }
  checkPackets(packets[1]);
  EXPECT_GT(packets[1].back().header.first_event_index(), 0u);
  EXPECT_EQ(samplesOf(packets[2]).front().elements.size(), 24u * 16 * sizeof(float));
}

TEST(RigStream, ACameraMovesWithTheBody) {
  TestServer server;
  v1::OpenStream request = stereo();
  request.mutable_truth(0)->set_name("pose");
  request.mutable_truth(0)->set_view(0);
  auto packets = server.run(request);
  const TruthSamples body = samplesOf(packets[2]), camera = samplesOf(packets[3]);
  ASSERT_EQ(body.size(), camera.size());
  const Pose mount{{0.3, 0, 0}, normalize({0, 0.2, 0, 2})};
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Pose expected = poseOf(body[i]) * mount, found = poseOf(camera[i]);
    EXPECT_LT(length(found.position - expected.position), 1e-12);
    EXPECT_LT(length(rotationVector(conjugate(found.rotation) * expected.rotation)), 1e-12);
  }
  EXPECT_NE(body.front().elements, body.back().elements);
}

TEST(RigStream, ThreadsDoNotMatter) {
  TestServer one(1), two(2);
  auto a = one.run(stereo()), b = two.run(stereo());
  for (std::uint32_t channel = 0; channel < 4; ++channel)
    EXPECT_EQ(comparableBytes(a[channel]), comparableBytes(b[channel])) << channel;
}

TEST(RigStream, GoesOnFromAnEventOfEachView) {
  TestServer before, again;
  auto whole = before.run(stereo());
  v1::OpenStream request = stereo();
  request.mutable_sensors(0)->set_from_event(whole[0].back().header.first_event_index() + 1000);
  const std::uint64_t from = whole[1][2].header.first_event_index();
  ASSERT_LT(from, whole[1].back().header.first_event_index());
  request.mutable_sensors(1)->set_from_event(from);
  auto rest = again.run(request);
  EXPECT_EQ(rest[0].size(), 1u);
  EXPECT_EQ(rest[1].front().header.first_event_index(), from);
  EXPECT_EQ(rest[1].back().header.first_event_index(), whole[1].back().header.first_event_index());
  EXPECT_EQ(rest[1].front().payload, whole[1][2].payload);
}

TEST(RigStream, FillsInTheDefaults) {
  TestServer server;
  v1::OpenStream request = stereo();
  request.mutable_further_views(0)->mutable_body_camera()->clear_rotation();
  const v1::OpenStream resolved = server.client().open(request).resolved();
  EXPECT_EQ(resolved.further_views(0).body_camera().rotation().w(), 1);
  EXPECT_EQ(resolved.further_views(0).fov_x_deg(), resolved.view().fov_x_deg());
  EXPECT_NE(resolved.sensors(0).seed(), resolved.sensors(1).seed());
}

TEST(RigStream, IsRefusedByField) {
  TestServer server;
  using Open = v1::OpenStream;
  constexpr auto kInvalid = v1::CODE_INVALID_ARGUMENT;
  const Open good = stereo();
  const auto mount = [](Open& r) { return r.mutable_further_views(0)->mutable_body_camera(); };
  expectRefused(
      server,
      {{good, [](Open& r) { r.mutable_sensors(1)->set_view(2); }, kInvalid, "sensors[1].view", "there are 2"},
       {good, [](Open& r) { r.mutable_truth(0)->set_view(9); }, kInvalid, "truth[0].view", "no view 9"},
       {good, [](Open& r) { r.mutable_further_views(0)->set_width(0); }, kInvalid, "further_views[0].width",
        "0"},
       {good, [](Open& r) { r.mutable_further_views(0)->set_fov_x_deg(180); }, kInvalid,
        "further_views[0].fov_x_deg", "180"},
       {good,
        [&](Open& r) { mount(r)->mutable_rotation()->set_w(0), mount(r)->mutable_rotation()->set_y(0); },
        kInvalid, "further_views[0].body_camera.rotation", "length"},
       {good, [&](Open& r) { mount(r)->mutable_position()->set_z(2e9); }, kInvalid,
        "further_views[0].body_camera.position.z", "outside"},
       {good, [](Open& r) { r.mutable_view()->mutable_body_camera()->mutable_rotation(); }, kInvalid,
        "view.body_camera.rotation", "length"},
       {good,
        [](Open& r) {
          for (int i = 0; i < 7; ++i) *r.add_further_views() = r.view();
        },
        kInvalid, "further_views", "more than 7"},
       {good,
        [](Open& r) {
          for (v1::View* view : {r.mutable_view(), r.mutable_further_views(0)})
            view->set_width(4096), view->set_height(1024);
          r.mutable_method()->set_spp(64);
          r.mutable_quality()->set_bounces(3);
        },
        v1::CODE_RESOURCE_EXHAUSTED, "view", "limit rays"},
       {good,
        [](Open& r) {
          r.mutable_method()->set_name("irradiance_cache");
          r.mutable_quality()->set_bake_error(0.1);
        },
        kInvalid, "quality.bake_error", "equal size"}});
}

}  // namespace
}  // namespace saccade
