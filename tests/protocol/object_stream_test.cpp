// Streams of scenes whose objects move.
#include <gtest/gtest.h>

#include <cstring>

#include "mock/control_calls.h"
#include "mock/events_of.h"
#include "objects.h"
#include "scene/library/scene_library.h"
#include "scene/motion/bodies.h"

namespace saccade {
namespace {

std::string bytesOf(TestServer& server, const v1::OpenStream& request) {
  std::string bytes;
  for (const auto& [channel, packets] : server.run(request)) bytes += comparableBytes(packets);
  return bytes;
}

// Where the scene file has the tall block.
Vec3d restOfTheBlock() {
  Scene scene = SceneLibrary(SACCADE_SOURCE_DIR "/scenes").load("cornell-box");
  const std::string name = "tall_block";
  setBodies(scene, {&name, 1});
  return toDouble(scene.bodies.at(0).centre()) + scene.origin;
}

void addKey(v1::OpenStream& request, double time_s, Vec3d at) {
  if (request.objects_size() == 0) addObject(request, "tall_block");
  v1::Keyframe& key = *request.mutable_objects(0)->mutable_path()->mutable_keyframes()->add_keys();
  key.set_time_s(time_s);
  key.mutable_position()->set_x(at.x), key.mutable_position()->set_y(at.y),
      key.mutable_position()->set_z(at.z);
  key.mutable_rotation()->set_w(1);
}

v1::OpenStream withDepth(v1::OpenStream request) {
  request.add_truth()->set_name("depth");
  return request;
}

// The picture of the first frame, as bytes.
std::string depthOf(TestServer& server, const v1::OpenStream& request) {
  return samplesOf(server.run(withDepth(request))[1]).at(0).elements;
}

TEST(ObjectStream, OnlyWhatMovesMakesEventsBeforeACameraThatStands) {
  TestServer server;
  EXPECT_TRUE(eventsOf(server.run(stillRequest())[0]).empty());
  const Events events = eventsOf(server.run(spinning())[0]);
  EXPECT_GT(events.size(), 20u);
}

TEST(ObjectStream, AMotionTellsHowFastThePictureMoves) {
  TestServer server;
  const v1::OpenStream request = spinning();
  EXPECT_EQ(server.client().open(stillRequest()).px_per_frame_p99(), 0);
  EXPECT_GT(server.client().open(request).px_per_frame_p99(), 0.01);
  EXPECT_EQ(server.client().open(request).px_per_frame_p50(), 0);  // most of the picture stands
}

TEST(ObjectStream, APathIsTheSameAsItsText) {
  TestServer server;
  v1::OpenStream keyed = stillRequest(), text = stillRequest();
  addKey(keyed, 0, {2, 1, 3});
  addKey(keyed, 0.04, {2.5, 1, 3});
  addObject(text, "tall_block").set_csv("70 2 1 3 0 0 0 1\n70.04 2.5 1 3 0 0 0 1\n");
  const std::string bytes = bytesOf(server, withDepth(keyed));
  EXPECT_EQ(bytes, bytesOf(server, withDepth(text)));
  addKey(keyed, 0.05, {2.5, 1, 3});
  keyed.mutable_objects(0)->mutable_path()->mutable_keyframes()->mutable_keys(1)->mutable_position()->set_x(
      2.6);
  EXPECT_NE(bytes, bytesOf(server, withDepth(keyed)));
}

// A second line a second later, so that a path is not a single pose.
std::string textFrom(double begin_s, Vec3d at) {
  const auto line = [&](double t, Vec3d p) {
    return std::to_string(t) + " " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
           std::to_string(p.z) + " 0 0 0 1\n";
  };
  return line(begin_s, at) + line(begin_s + 1, at + Vec3d{1, 0, 0});
}

// x of the objects at the first frame and 0.02 s later.
std::vector<double> placesOf(TestServer& server, v1::OpenStream request) {
  request.add_truth()->set_name("object_poses");
  std::vector<double> places;
  const TruthSamples samples = samplesOf(server.run(request)[1]);
  for (const std::size_t i : {0u, 1u, 20u, 21u}) {
    double row[2];
    std::memcpy(row, samples.at(i).elements.data(), sizeof row);
    places.push_back(row[1]);
  }
  return places;
}

TEST(ObjectStream, TextsOfObjectsShareOneClock) {
  TestServer server;
  v1::OpenStream request = stillRequest();
  addObject(request, "short_block").set_csv(textFrom(1.7e9, {1, 1, 1}));
  addObject(request, "tall_block").set_csv(textFrom(1.7e9 + 0.01, {4, 1, 1}));
  const std::vector<double> places = placesOf(server, request);
  EXPECT_NEAR(places[0], 1, 1e-6);
  EXPECT_NEAR(places[1], 4, 1e-6);
  EXPECT_NEAR(places[2], 1.02, 1e-6);
  EXPECT_NEAR(places[3], 4.01, 1e-6);  // it began 0.01 s later
}

TEST(ObjectStream, TheTextOfTheCameraSetsTheClock) {
  TestServer server;
  v1::OpenStream request = stillRequest();
  request.mutable_trajectory()->set_csv("1.7e9 2.78 2.73 -7.5 0 0 1 0\n");
  addObject(request, "short_block").set_csv(textFrom(1.7e9 - 0.5, {1, 1, 1}));
  addObject(request, "tall_block").set_csv(textFrom(1.7e9, {4, 1, 1}));
  const std::vector<double> places = placesOf(server, request);
  EXPECT_NEAR(places[0], 1.5, 1e-6);
  EXPECT_NEAR(places[1], 4, 1e-6);
}

TEST(ObjectStream, APoseIsWhereTheCentreOfTheBoxLies) {
  TestServer server;
  const Vec3d rest = restOfTheBlock();
  v1::OpenStream at_rest = stillRequest(), moved = stillRequest();
  addKey(at_rest, 0, rest);
  addKey(moved, 0, rest + Vec3d{0.5, 0, 0});
  const std::string plain = depthOf(server, stillRequest());
  EXPECT_EQ(depthOf(server, at_rest), plain);
  EXPECT_NE(depthOf(server, moved), plain);
}

TEST(ObjectStream, ThreadsDoNotMatter) {
  v1::OpenStream request = withDepth(spinning());
  request.add_further_views()->CopyFrom(request.view());
  request.add_sensors()->set_view(1);
  TestServer one(1), two(2), five(5);
  const std::string bytes = bytesOf(one, request);
  EXPECT_EQ(bytes, bytesOf(two, request));
  EXPECT_EQ(bytes, bytesOf(five, request));
}

v1::OpenStream endless(v1::OpenStream request) {
  request.set_delivery(v1::DELIVERY_LIVE);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_frame_rate_hz(50);
  request.mutable_timing()->set_duration_s(0);
  return request;
}

MockSubscriber join(TestServer& server, const v1::OpenStream& request) {
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(server.client().open(request));
  subscriber.giveCredit(std::uint64_t{1} << 30);
  return subscriber;
}

TEST(ObjectStream, EqualMotionsShareAFeedAndOthersDoNotDisturb) {
  TestServer server(2);
  const std::string alone = bytesOf(server, spinning());
  v1::OpenStream both = endless(spinning());
  addMotion(both, "light", v1::OBJECT_MOTION_KIND_SLIDE, 0.1);
  MockSubscriber early = join(server, both);
  while (early.receive()->header.t1_ns() < 100'000'000) {
  }
  EXPECT_EQ(alone, bytesOf(server, spinning()));
  both.mutable_objects()->SwapElements(0, 1);
  EXPECT_EQ(join(server, both).receive()->header.kind(), v1::KIND_SNAPSHOT);
  both.mutable_objects(0)->mutable_path()->mutable_motion()->set_speed(0.2);
  EXPECT_NE(join(server, both).receive()->header.kind(), v1::KIND_SNAPSHOT);
}

TEST(ObjectStream, ComposesWithASimplifiedScene) {
  TestServer server;
  v1::OpenStream plain = stillRequest();
  plain.set_scene("textured-cornell-box");
  plain.mutable_quality()->add_disabled_features("textures");
  v1::OpenStream moving = plain;
  addMotion(moving, "tall_block", v1::OBJECT_MOTION_KIND_SPIN, 720);
  EXPECT_TRUE(eventsOf(server.run(plain)[0]).empty());
  EXPECT_FALSE(eventsOf(server.run(moving)[0]).empty());
  EXPECT_EQ(server.client().open(moving).resolved().quality().disabled_features(0), "textures");
}

TEST(ObjectStream, ASteeredStreamIsDescribedWithThePathsOfItsObjects) {
  TestServer server;
  v1::OpenStream request = stillRequest();
  addObject(request, "light").set_csv("0 1 2 3 0 0 0 1\n");
  const auto described = [&] { return describe(server.client(), server.client().open(request)).objects(0); };
  EXPECT_EQ(described().name(), "light");
  EXPECT_FALSE(described().has_path());
  request.mutable_timing()->set_clock(v1::CLOCK_LOCKSTEP);
  ASSERT_EQ(described().path().keyframes().keys_size(), 1);  // where it is at the first frame
  EXPECT_EQ(described().path().keyframes().keys(0).position().y(), 2);
}

}  // namespace
}  // namespace saccade
