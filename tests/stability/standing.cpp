#include "stability/standing.h"

#include "events/sensor.h"
#include "methods/method.h"

namespace saccade::test {
namespace {

constexpr SensorConfig kMostSensitive{.threshold = 0.01, .threshold_off = 0.01, .bias = 1e-8};

ParamValues defaultsOf(const std::string& method) {
  ParamValues params;
  std::string bad_name;
  SACCADE_CHECK(resolveParams(*findMethod(method), {}, params, bad_name).empty());
  return params;
}

}  // namespace

Ghosts ghostsOf(Standing of, const std::string& method, TilePool& pool) {
  of.config.method = method, of.config.params = defaultsOf(method);
  const int width = of.config.camera.width, height = of.config.camera.height;
  Feed feed(of.scene, of.path, of.config, pool);
  Sensor sensor(kMostSensitive, width, height);
  SensorOutput out;
  Ghosts found;
  for (int t = 1; t <= of.last; ++t) {
    const IntensityChange& change = feed.step(pool);
    sensor.generate(change, out);
    if (t <= of.moving) continue;
    found.events += static_cast<long>(out.events.size());
    found.lit = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        found.changes += change.dI.at(x, y) != 0, found.changes += change.var_dI.at(x, y) != 0;
        found.lit += change.I_now.at(x, y) > 0;
      }
  }
  return found;
}

}  // namespace saccade::test
