// Streams of scenes that move their own objects.
#include <gtest/gtest.h>

#include "app/request/resolve.h"
#include "mock/bad_request.h"
#include "mock/control_calls.h"
#include "mock/events_of.h"
#include "objects.h"

namespace saccade {
namespace {

v1::OpenStream turntable() {
  v1::OpenStream request = stillRequest();
  request.set_scene("cornell-turntable");
  request.mutable_timing()->set_frame_rate_hz(100);
  request.mutable_timing()->set_duration_s(0.1);
  return request;
}

v1::OpenStream stopped() {
  v1::OpenStream request = turntable();
  addObject(request, "turntable").mutable_still();
  addObject(request, "ball").mutable_still();
  return request;
}

std::string bytesOf(TestServer& server, const v1::OpenStream& request) {
  return comparableBytes(server.run(request)[0]);
}

std::vector<std::string> pathsOf(const v1::OpenStream& request) {
  std::vector<std::string> paths;
  for (const v1::ObjectMotion& object : request.objects()) paths.push_back(object.ShortDebugString());
  return paths;
}

TEST(OwnMotion, AStreamHasItUnlessItSaysOtherwise) {
  TestServer server;
  const Events events = eventsOf(server.run(turntable())[0]);
  EXPECT_GT(events.size(), 20u);
  EXPECT_TRUE(eventsOf(server.run(stopped())[0]).empty());
  v1::OpenStream one = turntable();
  addObject(one, "ball").mutable_still();
  const Events fewer = eventsOf(server.run(one)[0]);
  EXPECT_FALSE(fewer.empty());
  EXPECT_NE(fewer, events);
}

TEST(OwnMotion, TheReplyNamesWhatMovesAndRepeatsTheStream) {
  TestServer server;
  v1::OpenStream request = turntable();
  addMotion(request, "light", v1::OBJECT_MOTION_KIND_SLIDE, 0.2);
  const v1::OpenStream resolved = server.client().open(request).resolved();
  EXPECT_EQ(pathsOf(resolved),
            (std::vector<std::string>{"name: \"ball\" path { own { } }",
                                      "name: \"light\" path { motion { kind: OBJECT_MOTION_KIND_SLIDE "
                                      "speed: 0.2 } }",
                                      "name: \"turntable\" path { own { } }"}));
  EXPECT_EQ(server.client().open(resolved).resolved().DebugString(), resolved.DebugString());
  EXPECT_EQ(bytesOf(server, resolved), bytesOf(server, request));
}

TEST(OwnMotion, TheClientsOwnPathComesFirst) {
  TestServer server;
  v1::OpenStream same = stopped(), other = stopped(), own = stopped();
  same.mutable_objects(0)->mutable_path()->mutable_motion()->set_kind(v1::OBJECT_MOTION_KIND_SPIN);
  same.mutable_objects(0)->mutable_path()->mutable_motion()->set_speed(60);  // as motion.toml
  other = same;
  other.mutable_objects(0)->mutable_path()->mutable_motion()->set_speed(-60);
  own.mutable_objects(0)->mutable_path()->mutable_own();
  EXPECT_EQ(bytesOf(server, same), bytesOf(server, own));
  EXPECT_NE(bytesOf(server, other), bytesOf(server, own));
}

TEST(OwnMotion, WhatStandsAnywayMakesNoOtherFeed) {
  TestServer server;
  v1::OpenStream request = stillRequest();
  addObject(request, "tall_block").mutable_still();
  const v1::StreamOpened plain = server.client().open(stillRequest()), still = server.client().open(request);
  EXPECT_EQ(still.resolved().DebugString(), plain.resolved().DebugString());
  EXPECT_EQ(server.client().open(stopped()).resolved().objects_size(), 2);  // here it has an effect
}

TEST(OwnMotion, IsListed) {
  TestServer server;
  v1::Request call;
  call.mutable_list_scenes();
  const v1::SceneList scenes = server.client().call(call).list_scenes();
  std::map<std::string, std::string> motions;
  for (const v1::SceneInfo& scene : scenes.scenes())
    for (const v1::SceneObject& object : scene.objects())
      motions[scene.name() + "/" + object.name()] = object.motion();
  EXPECT_EQ(motions.at("cornell-turntable/turntable"), "spin:60");
  EXPECT_EQ(motions.at("cornell-turntable/ball"), "swing:2");
  EXPECT_EQ(motions.at("cornell-turntable/light"), "");
  EXPECT_EQ(motions.at("cornell-box/tall_block"), "");
}

TEST(OwnMotion, WhatAMovingSceneCannotHaveIsRefusedUnlessItStands) {
  TestServer server;
  const auto bake = [](v1::OpenStream& r) { r.mutable_quality()->set_bake_error(1); };
  expectRefused(
      server,
      {{turntable(), bake, v1::CODE_INVALID_ARGUMENT, "quality.bake_error", "these move: ball, turntable"},
       {turntable(), [](auto& r) { addObject(r, "light").mutable_own(); }, v1::CODE_NOT_FOUND,
        "objects[0].path.own", "does not move 'light'; it moves: ball, turntable"}});
  v1::OpenStream standing = stopped();
  bake(standing);
  EXPECT_EQ(server.client().tryOpen(standing).message(), "this server keeps no bakes");  // what comes after
}

TEST(OwnMotion, EqualStreamsShareAFeed) {
  TestServer server(2);
  v1::OpenStream request = turntable();
  request.set_delivery(v1::DELIVERY_LIVE);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_frame_rate_hz(20);
  request.mutable_timing()->set_duration_s(0);
  const auto join = [&](const v1::OpenStream& r) {
    MockSubscriber subscriber = server.dataSubscriber();
    subscriber.attach(server.client().open(r));
    subscriber.giveCredit(std::uint64_t{1} << 30);
    return subscriber;
  };
  MockSubscriber early = join(request);
  while (early.receive()->header.t1_ns() < 200'000'000) {
  }
  v1::OpenStream explicitly = request, otherwise = request;
  addObject(explicitly, "ball").mutable_own();
  addObject(otherwise, "ball").mutable_still();
  EXPECT_EQ(join(explicitly).receive()->header.kind(), v1::KIND_SNAPSHOT);
  EXPECT_NE(join(otherwise).receive()->header.kind(), v1::KIND_SNAPSHOT);
}

}  // namespace
}  // namespace saccade
