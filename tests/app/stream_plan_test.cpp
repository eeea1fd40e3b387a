// From a request to packets in one process, without a socket.
#include "app/sequence/stream_plan.h"

#include <gtest/gtest.h>
#include <link.h>

#include <string>
#include <vector>

#include "app/request/refusal.h"
#include "app/request/resolve_trajectory.h"
#include "app/sequence/channel.h"
#include "app/sequence/stream_rig.h"
#include "scene/gltf_scratch.h"

namespace saccade {
namespace {

v1::OpenStream request() {
  v1::OpenStream r;
  r.set_scene("cornell-box");
  r.mutable_view()->set_width(32), r.mutable_view()->set_height(24);
  r.mutable_trajectory()->set_name("right");
  r.mutable_timing()->set_frame_rate_hz(1000), r.mutable_timing()->set_duration_s(0.01);
  r.add_sensors()->set_threshold(0.1);
  return r;
}

struct StreamPlanTest : testing::Test {
  StreamPlan plan(const v1::OpenStream& request) {
    return planStream(request, scenes.library(), tables, limits);
  }

  const Limits limits;
  const MeasuredTables tables{openAccuracySource(""), openSimplificationSource("")};
  SceneCache scenes{std::string(SACCADE_SOURCE_DIR) + "/scenes"};
};

TEST_F(StreamPlanTest, LeadsToTheEventsOfEachInterval) {
  StreamPlan of = plan(request());
  loadScenes(of, scenes, {});
  TilePool pool(2);
  Rig rig =
      makeRig(of.scene, resolveTrajectory(of.resolved, *of.whole, scenes.library()), of.resolved, {pool});
  const auto channels = makeChannels(of.resolved, "one", 1);
  ASSERT_EQ(channels.size(), 1u);
  std::uint64_t events = 0;
  std::int64_t until = 0;
  for (FrameIndex i = 0; i < of.resolved.frames; ++i) {
    channels[0]->process(rig.step({pool}).front(), true);
    for (const Packet& packet : channels[0]->takePackets()) {
      PacketContent content;
      ASSERT_EQ(decodePacket(packet.header, *packet.payload, content), "");
      EXPECT_GE(packet.header.t0_ns(), until);
      until = packet.header.t1_ns(), events += content.events.size();
    }
  }
  EXPECT_EQ(until, 10'000'000);
  EXPECT_GT(events, 0u);
  EXPECT_EQ(events, channels[0]->items());
}

TEST_F(StreamPlanTest, RefusesAsAServerDoes) {
  v1::OpenStream unknown = request(), large = request();
  unknown.set_scene("nowhere");
  large.mutable_method()->set_spp(1'000'000);
  EXPECT_THROW(plan(unknown), Refusal);
  EXPECT_THROW(plan(large), Refusal);
}

// Of the libraries of this program, which links what a batch needs.
TEST(RequestLibrary, LinksNoTransport) {
  std::vector<std::string> loaded;
  const auto add = [](dl_phdr_info* info, std::size_t, void* to) {
    static_cast<std::vector<std::string>*>(to)->push_back(info->dlpi_name);
    return 0;
  };
  dl_iterate_phdr(add, &loaded);
  ASSERT_GT(loaded.size(), 3u);
  for (const std::string& library : loaded)
    for (const char* transport : {"zmq", "microhttpd", "wslay"})
      EXPECT_EQ(library.find(transport), std::string::npos) << library;
}

// A camera of a glTF file is known once the file has been read.
TEST(StreamPlanOfGltf, TakesItsCamerasAndItsMotions) {
  const Scratch files;
  test::GltfArrays arrays = test::triangle();
  arrays.floats({0, 1}, "SCALAR"), arrays.floats({0, 0, 0, 1, 0, 0}, "VEC3");
  files.write("mine/data.bin", arrays.bytes());
  files.write(
      "mine/scene.gltf",
      test::gltf({test::kTriangleMesh, arrays.json(),
                  R"("cameras":[{"type":"perspective","perspective":{"yfov":1}}])",
                  R"("nodes":[{"mesh":0,"name":"it"},{"camera":0,"name":"eye","translation":[0,0,5]}])",
                  R"("animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],
                          "samplers":[{"input":1,"output":2}]}])"}));
  SceneCache scenes(files.path(""));
  const MeasuredTables tables{openAccuracySource(""), openSimplificationSource("")};
  const auto resolvedFor = [&](const std::string& trajectory) {
    v1::OpenStream r = request();
    r.set_scene("mine"), r.mutable_trajectory()->set_name(trajectory);
    StreamPlan plan = planStream(r, scenes.library(), tables, {});
    loadScenes(plan, scenes, {});
    return plan;
  };
  const StreamPlan of = resolvedFor("eye");
  EXPECT_EQ(resolveTrajectory(of.resolved, *of.whole, scenes.library()).at(TimeNs{0}).position,
            (Vec3d{0, 0, 5}));
  ASSERT_EQ(of.resolved.request.objects_size(), 1);
  EXPECT_TRUE(of.resolved.request.objects(0).path().has_own());
  EXPECT_NEAR(of.resolved.feed.body_paths.at(0).at(TimeNs{500'000'000}).position.x, 1, 1e-6);
  const StreamPlan other = resolvedFor("nose");
  try {
    resolveTrajectory(other.resolved, *other.whole, scenes.library());
    FAIL() << "there is no trajectory nose";
  } catch (const Refusal& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("eye"), std::string::npos) << refusal.what();
  }
}

// Walk goes by 1 in a second, and Run by 5.
struct AnimatedScene : testing::Test {
  AnimatedScene() {
    test::GltfArrays arrays = test::triangle();
    arrays.floats({0, 1}, "SCALAR");
    arrays.floats({0, 0, 0, 1, 0, 0}, "VEC3"), arrays.floats({0, 0, 0, 5, 0, 0}, "VEC3");
    const auto animation = [](const std::string& name, const std::string& values) {
      return R"({"name":")" + name +
             R"(","channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],)" +
             R"("samplers":[{"input":1,"output":)" + values + "}]}";
    };
    files.write("mine/data.bin", arrays.bytes());
    files.write("mine/scene.gltf", test::gltf({test::kTriangleMesh, test::kTriangleNode, arrays.json(),
                                               R"("animations":[)" + animation("Walk", "2") + "," +
                                                   animation("Run", "3") + "]"}));
  }
  StreamPlan plan(const std::string& animation) {
    v1::OpenStream r = request();
    r.set_scene("mine"), r.set_animation(animation);
    StreamPlan of = planStream(r, scenes.library(), tables, {});
    loadScenes(of, scenes, {});
    return of;
  }

  const Scratch files;
  SceneCache scenes{files.path("")};
  const MeasuredTables tables{openAccuracySource(""), openSimplificationSource("")};
};

TEST_F(AnimatedScene, PlaysTheOneThatTheStreamChooses) {
  const StreamPlan walk = plan("Walk"), run = plan("Run"), any = plan("");
  const auto at1s = [](const StreamPlan& of) {
    return of.resolved.feed.body_paths.at(0).at(TimeNs{1'000'000'000}).position.x -
           of.resolved.feed.body_paths.at(0).at(TimeNs{0}).position.x;
  };
  EXPECT_NEAR(at1s(walk), 1, 1e-6);
  EXPECT_NEAR(at1s(run), 5, 1e-6);
  EXPECT_NEAR(at1s(any), 1, 1e-6);
  EXPECT_NE(walk.scene, run.scene);
  EXPECT_EQ(plan("Run").scene, run.scene);
  EXPECT_NE(walk.resolved.feedKey(), run.resolved.feedKey());
}

// Each choice is a scene in memory of its own, which Limit::kScenes counts.
TEST_F(AnimatedScene, ScenesOfFurtherAnimationsAreBounded) {
  auto walk = scenes.get("mine", {}, {}, "Walk"), run = scenes.get("mine", {}, {}, "Run");
  Limits limits;
  limits[Limit::kScenes] = static_cast<double>(scenes.bytes() - 1) / (1 << 20);
  SceneCache few(files.path(""), limits);
  walk = few.get("mine", {}, {}, "Walk");
  EXPECT_THROW(few.get("mine", {}, {}, "Run"), LimitReached);
  EXPECT_EQ(few.get("mine", {}, {}, "Walk"), walk);
  walk.reset();
  EXPECT_NE(few.get("mine", {}, {}, "Run"), nullptr);
}

// None of them has a name that is too long to be listed.
TEST_F(AnimatedScene, NoMoreThanALimitAreListed) {
  const auto named = [](const std::string& name) {
    return R"({"name":")" + name + R"(","channels":[],"samplers":[]})";
  };
  std::string all = named(std::string(kMaxEntryBytes + 1, 'x'));
  for (std::size_t i = 0; i <= kMostListedAnimations; ++i) all += "," + named("a" + std::to_string(i));
  files.write("many/scene.gltf", test::gltf({test::kTriangleMesh, test::kTriangleNode,
                                             test::triangle().json(), R"("animations":[)" + all + "]"}));
  files.write("many/data.bin", test::triangle().bytes());
  const SceneLibrary library(files.path(""));
  EXPECT_EQ(library.animations("many").size(), kMostListedAnimations);
  EXPECT_EQ(library.animations("many").back(), "a" + std::to_string(kMostListedAnimations - 1));
}

TEST_F(AnimatedScene, TellsTheNamesThereAre) {
  EXPECT_EQ(scenes.library().list().at(0).animations, (std::vector<std::string>{"Walk", "Run"}));
  try {
    plan("Jump");
    FAIL() << "there is no animation Jump";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.code, v1::CODE_NOT_FOUND);
    EXPECT_EQ(refusal.field, "animation");
    expectContains(refusal.what(), "no animation 'Jump'; it has: Walk, Run");
  }
  EXPECT_TRUE(scenes.note("mine").failure.empty());
  v1::OpenStream r = request();
  r.set_animation("Run");
  try {
    planStream(r, SceneLibrary(std::string(SACCADE_SOURCE_DIR) + "/scenes"), tables, {});
    FAIL() << "cornell-box has no animation";
  } catch (const Refusal& refusal) {
    expectContains(refusal.what(), "no animation 'Run'; it has none: only scenes of glTF do");
  }
}

}  // namespace
}  // namespace saccade
