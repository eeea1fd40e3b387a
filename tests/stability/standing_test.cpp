// A camera that stands in constant light gives exactly no events: with every material, in every real scene,
// with each method that promises it.
#include "stability/standing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "eval/bench/open_scene.h"
#include "feed/bake.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/motion/bodies.h"
#include "scene/scratch.h"
#include "statistical/outside_files.h"

namespace saccade::test {
namespace {

using namespace std::chrono_literals;

constexpr int kWidth = 24, kHeight = 18;

Standing standing(std::shared_ptr<const RenderScene> scene, int width = kWidth, int height = kHeight) {
  const Scene& s = scene->description();
  FeedConfig config;
  config.camera = pinhole(s.fov_x_deg, width, height);
  return {std::move(scene), Trajectory({{0ms, s.T_world_camera}}), config};
}

void expectNoGhosts(const Standing& of, const std::string& method, TilePool& pool) {
  const Ghosts found = ghostsOf(of, method, pool);
  EXPECT_EQ(found.changes, 0) << method;
  EXPECT_EQ(found.events, 0) << method;
  EXPECT_GT(found.lit, 0) << method;
}

class StandingMaterial : public testing::TestWithParam<MaterialScene> {
 protected:
  StandingMaterial() {
    files_.write("flag.ppm", "P3 2 2 255  255 255 255  0 0 0  40 40 40  160 160 160");
    scene_ = std::make_shared<RenderScene>(parseMitsubaXml(GetParam().xml, files_.path("scene.xml")));
  }
  const Scratch files_;
  std::shared_ptr<const RenderScene> scene_;
  TilePool pool_{2};
};

TEST_P(StandingMaterial, EveryMethodShowsNoChange) {
  for (const std::string& method : kMethodsWithoutGhosts) expectNoGhosts(standing(scene_), method, pool_);
}

TEST_P(StandingMaterial, NorDoesTheDefaultOverWholePixelsOrWithABake) {
  Standing jittered = standing(scene_);
  jittered.config.jitter = true;
  expectNoGhosts(jittered, "irradiance_cache", pool_);
  Standing baked = standing(scene_);
  const BakePlan plan = planBake(*scene_, baked.path, baked.config, 6, 0.2);
  const auto ignored = [](const auto&) {};
  baked.config.baked = bake(scene_, plan, files_.path("bakes"), pool_, ignored, ignored).light;
  expectNoGhosts(baked, "irradiance_cache", pool_);
}

// From the second frame at one place on. event_svgf forgets motion over some frames, as its page says.
TEST_P(StandingMaterial, ACameraThatStopsShowsNoChange) {
  Standing stops = standing(scene_);
  const Pose begin = stops.path.at(0ms);
  const TimeNs at = frameTime(4, stops.config.frame_rate_hz);
  stops.path = Trajectory({{0ms, begin}, {at, begin * Pose{{0.1, 0.02, 0}, {}}}});
  stops.moving = 4;
  for (const char* method : {"irradiance_cache", "pt-correlated"}) expectNoGhosts(stops, method, pool_);
}

std::string nameOf(const testing::TestParamInfo<MaterialScene>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Materials, StandingMaterial, testing::ValuesIn(materialScenes()), nameOf);

TEST(MaterialScenes, AreOfEveryKind) {
  for (const BsdfTraits& kind : kBsdfTraits)
    EXPECT_TRUE(std::ranges::any_of(materialScenes(), [&](const MaterialScene& scene) {
      return scene.xml.find("<bsdf type='" + std::string(kind.name) + "'") != std::string::npos;
    })) << kind.name;
}

// A body that moves behind a wall changes nothing before it.
TEST(StandingCamera, SeesNothingOfABodyBehindAWall) {
  Scene s = parseMitsubaXml(R"(<scene version="3.0.0">
    <sensor type="perspective"><float name="fov" value="60"/>
      <transform name="to_world"><lookat origin="0, 0, -2.5" target="0, 0, 0" up="0, 1, 0"/></transform></sensor>
    <shape type="cube" id="room"><transform name="to_world"><scale value="3"/></transform></shape>
    <shape type="rectangle" id="wall"><transform name="to_world"><scale value="3.01"/></transform></shape>
    <shape type="sphere" id="ball"><point name="center" x="0" y="0" z="1.5"/>
      <float name="radius" value="0.5"/></shape>
    <shape type="sphere" id="before"><point name="center" x="0.8" y="0" z="-1"/>
      <float name="radius" value="0.5"/></shape>
    <shape type="rectangle" id="lamp"><transform name="to_world"><rotate x="1" angle="90"/>
      <translate y="2.9" z="-1.5"/></transform>
      <emitter type="area"><rgb name="radiance" value="9, 9, 9"/></emitter></shape></scene>)",
                            "scene.xml");
  const std::string names[]{"ball"};
  setBodies(s, names);
  Standing of = standing(std::make_shared<RenderScene>(std::move(s)));
  of.config.body_paths = {Trajectory({{0ms, {{-1, 0, 1.5}, {}}}, {100ms, {{1, 0, 1.5}, {}}}})};
  TilePool pool(2);
  expectNoGhosts(of, "irradiance_cache", pool);
}

class StandingRealScene : public testing::TestWithParam<const char*> {};

TEST_P(StandingRealScene, EveryMethodShowsNoChange) {
  const std::string file = realScene(GetParam() + std::string("/scene.xml"));
  SACCADE_NEEDS(file);
  std::shared_ptr<const RenderScene> scene;
  try {
    scene = eval::openScene(file);
  } catch (const SceneError& absent) {
    GTEST_SKIP() << absent.what();
  }
  TilePool pool(2);
  for (const std::string& method : kMethodsWithoutGhosts)
    expectNoGhosts(standing(scene, 32, 24), method, pool);
}

INSTANTIATE_TEST_SUITE_P(Scenes, StandingRealScene,
                         testing::Values("cornell-box", "staircase", "kitchen", "veach-ajar"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace saccade::test
