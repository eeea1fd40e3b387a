#include "stability/cases.h"

#include <ostream>

namespace saccade::test {
namespace {

using F = Figures;

std::vector<StabilityCase> motionCases() {
  return {
      {.name = "motion_0.25px",
       .why = "so little changes that all noise is false events",
       .px_per_frame = 0.25,
       .bound = 0.15},
      {.name = "motion_1px", .why = "equal seeds meet other surfaces", .px_per_frame = 1, .bound = 0.4},
      {.name = "motion_4px",
       .why = "histories are short, equal seeds hardly help",
       .px_per_frame = 4,
       .bound = 0.39},
      {.name = "motion_16px",
       .why = "a tenth of the picture and more is new in every frame",
       .px_per_frame = 16,
       .bound = 0.15},
      {.name = "first_ten_frames",
       .why = "there is no history, and variances are guessed from neighbours",
       .px_per_frame = 1,
       .last = 10,
       .scored = 10,
       .bound = 0.33},
      {.name = "camera_cut",
       .why = "history is of another place, or of the same place seen from elsewhere",
       .trajectory = stabilityFile("trajectories/cut.csv"),
       .last = 20,
       .scored = 5,
       .bound = 0.12,
       .beaten_by = {"svgf"},
       .beaten_why =
           "where no history is left it has the difference of two single paths to filter, svgf two pictures"},
  };
}

std::vector<StabilityCase> longCases(bool full) {
  return {
      {.name = "drift",
       .why = "changes of brightness, added up: small errors of one sign add up too",
       .rate_hz = 300,
       .width = full ? 64 : 48,
       .height = full ? 64 : 48,
       .last = full ? 2000 : 200,
       .scored = 1,
       .judged = &F::drift,
       .bound = 0.31},
      {.name = "standing",
       .why = "nothing changes, so that every event is false; seen by the most sensitive of sensors",
       .scene = "textured-cornell-box",
       .trajectory = "still",
       .last = full ? 500 : 60,
       .scored = 0,
       .threshold = 0.01,
       .bias = 1e-8,
       .judged = &F::events,
       .bound = 0,
       .bounded = {"event_svgf", "pt-correlated"}},
  };
}

std::vector<StabilityCase> sensorCases() {
  return {
      {.name = "threshold_0.01",
       .why = "small errors are many events",
       .px_per_frame = 1,
       .threshold = 0.01,
       .bound = 0.95},
      {.name = "bias_1e-8",
       .why = "the relative errors of the darkest pixels count",
       .px_per_frame = 1,
       .bias = 1e-8,
       .bound = 0.42},
      {.name = "bias_1",
       .why = "only the brightest pixels count",
       .px_per_frame = 1,
       .bias = 1,
       .bound = 0.028},
      {.name = "bias_100", .why = "I is far below I_eps", .px_per_frame = 1, .bias = 100, .bound = 3e-4},
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
       .bound = 0},
      {.name = "size_17x13",
       .why = "neither a tile nor a vector fits",
       .px_per_frame = 1,
       .width = 17,
       .height = 13,
       .bound = 0.62},
      {.name = full ? "size_1280x720" : "size_320x180",
       .why = "a whole picture; whether it is right is for other cases to say",
       .px_per_frame = 1,
       .width = full ? 1280 : 320,
       .height = full ? 720 : 180,
       .last = 3,
       .scored = 0,
       .judged = &F::non_finite,
       .bound = 0},
  };
}

}  // namespace

std::string stabilityFile(const std::string& name) {
  return std::string(SACCADE_SOURCE_DIR) + "/tests/stability/" + name;
}

std::vector<StabilityCase> stabilityCases(bool full) {
  std::vector<StabilityCase> all;
  for (const auto& some :
       {motionCases(), sceneCases(), lightCases(), longCases(full), sensorCases(), sizeCases(full)})
    all.insert(all.end(), some.begin(), some.end());
  for (StabilityCase& c : all)
    if (c.width == 0) c.width = c.height = full ? 128 : 48;
  return all;
}

std::ostream& operator<<(std::ostream& out, const StabilityCase& c) {
  return out << c.name << ": " << c.why;
}

}  // namespace saccade::test
