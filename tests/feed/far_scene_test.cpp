// A room in map coordinates gives the changes of the same room at 0.
#include <gtest/gtest.h>

#include <cmath>

#include "feed/feed.h"
#include "render/camera/view_grid.h"
#include "scene/camera/motion.h"
#include "scene/mitsuba/mitsuba_xml.h"

namespace saccade {
namespace {

constexpr int kW = 32, kH = 24;

// Turned boxes on a floor under a lamp, seen from above the floor: `x` and `z` are those of the room's
// middle.
std::string roomAt(double x, double z) {
  const auto place = [&](double dx, double y, double dz) {
    return "<translate x='" + std::to_string(x + dx) + "' y='" + std::to_string(y) + "' z='" +
           std::to_string(z + dz) + "'/></transform>";
  };
  const auto box = [&](double angle, double edge, double dx, double dz) {
    return "<shape type='cube'><transform name='to_world'><scale value='" + std::to_string(edge) +
           "'/><rotate y='1' angle='" + std::to_string(angle) + "'/>" + place(dx, edge, dz) + "</shape>";
  };
  return "<scene version='3.0.0'><sensor type='perspective'><float name='fov' value='60'/>"
         "<transform name='to_world'><rotate x='1' angle='12'/><rotate y='1' angle='180'/>" +
         place(0, 1.5, 1.9) +
         "</sensor><shape type='rectangle'><transform name='to_world'><scale value='2'/>"
         "<rotate x='1' angle='-90'/>" +
         place(0, 0, 0) + "</shape>" + box(20, 0.5, -0.6, -0.5) + box(-25, 0.35, 0.7, 0.1) +
         "<shape type='rectangle'><transform name='to_world'><scale value='0.4'/><rotate x='1' angle='90'/>" +
         place(0, 2.98, 0) +
         "<emitter type='area'><float name='radiance' value='12'/></emitter></shape></scene>";
}

std::shared_ptr<const RenderScene> openRoom(double x, double z) {
  return std::make_shared<RenderScene>(parseMitsubaXml(roomAt(x, z), "room/scene.xml"));
}

struct Seen {
  std::vector<float> dI, I;
};

// Frames of a camera that moves to the right.
Seen look(const std::shared_ptr<const RenderScene>& scene, const std::string& method) {
  const Scene& s = scene->description();
  FeedConfig config;
  config.camera = pinhole(s.fov_x_deg, kW, kH);
  config.method = method;
  std::string bad;
  EXPECT_EQ(resolveParams(*findMethod(method), {}, config.params, bad), "");
  const Trajectory path = makeMotion(namedMotion("right", s.fov_x_deg), s.T_world_camera,
                                     probePoints(*scene, s.T_world_camera, Lens(config.camera)));
  TilePool pool(2);
  Feed feed(scene, path, config, pool);
  Seen seen;
  for (int t = 0; t < 6; ++t) {
    const IntensityChange& change = feed.step(pool);
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x)
        seen.dI.push_back(change.dI.at(x, y)), seen.I.push_back(change.I_now.at(x, y));
  }
  return seen;
}

double relativeL1(const std::vector<float>& a, const std::vector<float>& b) {
  double off = 0, all = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    off += std::abs(double{a[i]} - double{b[i]}), all += std::abs(double{b[i]});
  return off / all;
}

// Coordinates of the shapes are those of the room at 0 but for their last bit. So a path here and there meets
// the other side of an edge.
TEST(FarScene, LooksAsAtTheOrigin) {
  for (const char* method : {"irradiance_cache", "event_svgf"}) {
    const Seen near = look(openRoom(0, 0), method);
    for (const double far : {1e4, 1e5, 1e6}) {
      const Seen seen = look(openRoom(far, -far), method);
      EXPECT_LT(relativeL1(seen.I, near.I), 1e-3) << method << " at " << far;
      EXPECT_LT(relativeL1(seen.dI, near.dI), 0.02) << method << " at " << far;
    }
  }
}

}  // namespace
}  // namespace saccade
