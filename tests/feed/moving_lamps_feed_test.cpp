// Feeds under lamps without extent that move, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "feed/feed.h"
#include "render/test_scenes.h"
#include "scene/motion/bodies.h"

namespace saccade {
namespace {

constexpr int kSize = 24;
constexpr double kRate = 100, kStep = 0.02, kAlbedo = 0.5, kHeight = 1;

// A floor from above.
Scene floorUnder(const std::string& lamp) {
  Scene s = test::floorFromAbove(kAlbedo);
  const Rgb white{4, 4, 4};
  if (lamp == "point") s.point_lights = {{{0, 0, kHeight}, white, "lamp"}};
  if (lamp == "spot") s.spot_lights = {{{0, 0, kHeight}, {0, 0, -1}, white, 0.3f, 0.3f, "lamp"}};
  if (lamp == "sun") s.directional_lights = {{{0, 0, -1}, white, "lamp"}};
  s.T_world_camera.position = {0, 0, 2};
  s.fov_x_deg = 40;
  const std::string names[]{"lamp"};
  setBodies(s, names);
  return s;
}

struct Case {
  std::string lamp;
  Trajectory path;
  double (*light)(double x, double y, double t);  // that the floor reflects; t: frames
};

const TimeNs kEnd{1'000'000'000};

Trajectory sliding() {
  return Trajectory({{TimeNs(0), {{0, 0, kHeight}, {}}}, {kEnd, {{kRate * kStep, 0, kHeight}, {}}}});
}
Trajectory turning() {
  return Trajectory({{TimeNs(0), {}}, {kEnd, {{}, axisAngle({0, kRate * kStep, 0})}}});
}

double ofPoint(double x, double y, double t) {
  const double dx = x - kStep * t, d2 = dx * dx + y * y + kHeight * kHeight;
  return kAlbedo / std::numbers::pi * 4 * kHeight / (d2 * std::sqrt(d2));
}
double ofSpot(double x, double y, double t) {
  const double dx = x - kStep * t;
  return std::hypot(dx, y) < kHeight * std::tan(0.3) ? ofPoint(x, y, t) : 0;
}
double ofSun(double, double, double t) {
  return kAlbedo / std::numbers::pi * 4 * std::cos(kStep * t);
}

const std::vector<Case> kCases{
    {"point", sliding(), ofPoint}, {"spot", sliding(), ofSpot}, {"sun", turning(), ofSun}};

// Calls `take` with the frame, the picture and the place of each pixel on the floor.
void forFrames(const Case& c, const std::string& method, const auto& take) {
  TilePool pool(2);
  const Scene scene = floorUnder(c.lamp);
  FeedConfig config;
  config.camera = pinhole(40, kSize, kSize), config.frame_rate_hz = kRate, config.bounces = 0;
  config.method = method, config.body_paths = {c.path};
  std::string name;
  ASSERT_EQ(resolveParams(*findMethod(config.method), {}, config.params, name), "");
  Feed feed(std::make_shared<RenderScene>(scene), Trajectory({{TimeNs(0), scene.T_world_camera}}), config,
            pool);
  const double pixel = 2 * 2 * std::tan(20 * std::numbers::pi / 180) / kSize;
  for (int frame = 1; frame <= 4; ++frame) {
    const IntensityChange& change = feed.step(pool);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        take(frame, (x + 0.5 - kSize / 2.) * pixel, -(y + 0.5 - kSize / 2.) * pixel, change.I_now.at(x, y),
             change.dI.at(x, y));
  }
}

// These trace a ray to each lamp.
TEST(MovingLampsFeed, LightIsThatOfTheFormula) {
  for (const std::string method : {"irradiance_cache", "pt-correlated"})
    for (const Case& c : kCases) {
      double worst_I = 0, worst_dI = 0, most_dI = 0;
      forFrames(c, method, [&](int frame, double x, double y, double I, double dI) {
        const double change = c.light(x, y, frame) - c.light(x, y, frame - 1);
        worst_I = std::max(worst_I, std::abs(I - c.light(x, y, frame)));
        worst_dI = std::max(worst_dI, std::abs(dI - change)), most_dI = std::max(most_dI, std::abs(change));
      });
      EXPECT_LT(worst_I, 5e-5) << method << ' ' << c.lamp;
      EXPECT_LT(worst_dI, 5e-5) << method << ' ' << c.lamp;
      EXPECT_GT(most_dI, 1e-4) << c.lamp;
    }
}

// It filters the change, which is blurred then.
TEST(MovingLampsFeed, EventSvgfChangesAboutAsMuchOnEitherSide) {
  double brighter = 0, darker = 0, expected_brighter = 0, expected_darker = 0;
  forFrames(kCases[0], "event_svgf", [&](int frame, double x, double y, double, double dI) {
    if (frame < 3 || std::abs(x) < 0.2) return;
    const double change = ofPoint(x, y, frame) - ofPoint(x, y, frame - 1);
    (x > 0 ? brighter : darker) += dI, (x > 0 ? expected_brighter : expected_darker) += change;
  });
  EXPECT_NEAR(brighter / expected_brighter, 1, 0.25);
  EXPECT_NEAR(darker / expected_darker, 1, 0.25);
}

}  // namespace
}  // namespace saccade
