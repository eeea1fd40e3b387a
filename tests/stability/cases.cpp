#include "stability/cases.h"

#include <ostream>

namespace saccade::test {
namespace {

using F = Figures;

std::string ownFile(const std::string& path) {
  return std::string(SACCADE_SOURCE_DIR) + "/tests/stability/" + path;
}

std::vector<StabilityCase> sensorCases() {
  return {
      {.name = "threshold_0.01",
       .why = "small errors are many events",
       .px_per_frame = 1,
       .threshold = 0.01,
       .claims = {{"event_svgf", 0.95}, {"irradiance_cache", 0.35}}},
      {.name = "bias_1e-8",
       .why = "the relative errors of the darkest pixels count",
       .px_per_frame = 1,
       .bias = 1e-8,
       .claims = {{"event_svgf", 0.42}, {"irradiance_cache", 0.178}}},
      {.name = "bias_1",
       .why = "only the brightest pixels count",
       .px_per_frame = 1,
       .bias = 1,
       .claims = {{"event_svgf", 0.028}, {"irradiance_cache", 0.0114}}},
      {.name = "bias_100",
       .why = "I is far below I_eps",
       .px_per_frame = 1,
       .bias = 100,
       .claims = {{"event_svgf", 3e-4}, {"irradiance_cache", 0.000125}}},
  };
}

std::vector<StabilityCase> sizeCases(bool full) {
  return {
      {.name = "size_1x1",
       .why = "no neighbours; how right one pixel is, chance decides",
       .px_per_frame = 0.02,
       .width = 1,
       .height = 1,
       .last = 40,
       .scored = 0,
       .judged = &F::non_finite,
       .claims = {{"event_svgf", 0}, {"irradiance_cache", 0}}},
      {.name = "size_17x13",
       .why = "neither a tile nor a vector fits",
       .px_per_frame = 1,
       .width = 17,
       .height = 13,
       .claims = {{"event_svgf", 0.62}, {"irradiance_cache", 0.29}}},
      {.name = full ? "size_1280x720" : "size_320x180",
       .why = "a whole picture; whether it is right is for other cases to say",
       .px_per_frame = 1,
       .width = full ? 1280 : 320,
       .height = full ? 720 : 180,
       .last = 3,
       .scored = 0,
       .judged = &F::non_finite,
       .claims = {{"event_svgf", 0}, {"irradiance_cache", 0}}},
  };
}

}  // namespace

std::string ownScene(const std::string& name) {
  return ownFile("scenes/" + name + ".xml");
}

std::string ownModel(const std::string& name) {
  return ownFile("scenes/" + name + ".gltf");
}

std::string ownTrajectory(const std::string& name) {
  return ownFile("trajectories/" + name + ".csv");
}

StabilityCase lapBefore(StabilityCase c) {
  c.name += "_lap_before";
  c.why = "the same views, a lap earlier";
  c.last -= c.lap;
  c.claims.clear();
  return c;
}

std::vector<StabilityCase> stabilityCases(bool full) {
  std::vector<StabilityCase> all;
  for (const auto& some : {motionCases(), bodyCases(), bodyPlaceCases(), placeCases(), sceneCases(),
                           lightCases(), longCases(full), sensorCases(), sizeCases(full)})
    all.insert(all.end(), some.begin(), some.end());
  for (StabilityCase& c : all)
    if (c.width == 0) c.width = c.height = full ? 128 : 48;
  return all;
}

std::ostream& operator<<(std::ostream& out, const StabilityCase& c) {
  return out << c.name << ": " << c.why;
}

}  // namespace saccade::test
