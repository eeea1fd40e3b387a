#include "scene/strength.h"

#include "scene/emitter_strengths.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

TEST(Strength, IsOneWithoutKeys) {
  EXPECT_TRUE(Strength().isSteady());
  EXPECT_EQ(Strength().at(7s), 1);
}

TEST(Strength, IsLinearBetweenKeysAndHoldsOutside) {
  const Strength fade({{10ms, 1}, {30ms, 0.2f}});
  EXPECT_FALSE(fade.isSteady());
  EXPECT_EQ(fade.at(0s), 1);
  EXPECT_EQ(fade.at(10ms), 1);
  EXPECT_FLOAT_EQ(fade.at(15ms), 0.8f);  // 1 - 0.8 * 5 / 20
  EXPECT_EQ(fade.at(30ms), 0.2f);
  EXPECT_EQ(fade.at(9s), 0.2f);
}

TEST(Strength, TwoKeysAtOneTimeSwitchAtThatTime) {
  const Strength off({{0ms, 1}, {50ms, 1}, {50ms, 0}});
  EXPECT_EQ(off.at(50ms - 1ns), 1);
  EXPECT_EQ(off.at(50ms), 0);
}

TEST(Strength, RepeatsAfterItsPeriod) {
  // On for 3 ms of every 10.
  const Strength lamp = Strength::periodic({{0ms, 2}, {3ms, 2}, {3ms, 0.5f}}, 10ms);
  for (const TimeNs start : {0ms, 10ms, 12'340ms}) {
    EXPECT_EQ(lamp.at(start), 2);
    EXPECT_EQ(lamp.at(start + 3ms - 1ns), 2);
    EXPECT_EQ(lamp.at(start + 3ms), 0.5f);
    EXPECT_EQ(lamp.at(start + 10ms - 1ns), 0.5f);
  }
}

// Meshes first, then spheres, as geometry is counted.
TEST(EmitterStrengths, StandsByGeometryAndIsEmptyWhereAllAreSteady) {
  Scene scene;
  scene.meshes.resize(2);
  scene.spheres.resize(2);
  EXPECT_TRUE(EmitterStrengths(scene).factors().empty());
  EXPECT_EQ(EmitterStrengths(scene)[3], 1);
  scene.meshes[1].strength = Strength({{0s, 0.5f}, {1s, 0.25f}});
  scene.spheres[1].strength = Strength({{0s, 3}});
  EmitterStrengths strengths(scene);
  EXPECT_EQ(strengths.factors(), (std::vector<float>{1, 0.5f, 1, 3}));
  const auto at_first = strengths.state();
  strengths.setTime(1s);
  EXPECT_EQ(strengths.factors(), (std::vector<float>{1, 0.25f, 1, 3}));
  EXPECT_NE(strengths.state(), at_first);
  strengths.setTime(0s);
  EXPECT_EQ(strengths.state(), at_first);
}

Scene lampScene(const std::string& shape, const std::string& strength) {
  const Scratch files;
  return loadMitsubaXml(files.write(
      "scene.xml", "<scene><sensor type='perspective'><float name='fov' value='40'/></sensor><shape type='" +
                       shape + "'><emitter type='area'><float name='radiance' value='3'/>" + strength +
                       "</emitter></shape></scene>"));
}

TEST(MitsubaStrength, IsReadForEveryShape) {
  const std::string keys = "<string name='strength' value='0:1, 0.05:1, 0.05:0.2'/>";
  const std::string period = "<float name='strength_period' value='0.1'/>";
  for (const bool repeats : {false, true}) {
    const std::string text = keys + (repeats ? period : "");
    for (const Strength& s :
         {lampScene("rectangle", text).meshes[0].strength, lampScene("sphere", text).spheres[0].strength}) {
      EXPECT_EQ(s.at(50ms - 1ns), 1);
      EXPECT_EQ(s.at(50ms), 0.2f);
      EXPECT_EQ(s.at(120ms), repeats ? 1 : 0.2f);
    }
  }
  EXPECT_TRUE(lampScene("rectangle", "").meshes[0].strength.isSteady());
}

TEST(MitsubaStrength, KeysArePartedByBlanksCommasOrLines) {
  const std::string keys = "<string name='strength' value='\n  0:1 0.02:+3e0,\n\t0.04:5,0.06:7\n'/>";
  const Strength s = lampScene("rectangle", keys).meshes[0].strength;
  for (int i = 0; i < 4; ++i) EXPECT_EQ(s.at(i * 20ms), 1 + 2 * i);
}

}  // namespace
}  // namespace saccade
