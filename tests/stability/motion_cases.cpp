// The cases of how the camera moves.
#include "stability/cases.h"

namespace saccade::test {

std::vector<StabilityCase> motionCases() {
  return {
      {.name = "motion_0.25px",
       .why = "so little changes that all noise is false events",
       .px_per_frame = 0.25,
       .claims = {{"event_svgf", 0.15}, {"irradiance_cache", 0.095}}},
      {.name = "motion_1px",
       .why = "equal seeds meet other surfaces",
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.4}, {"irradiance_cache", 0.172}}},
      {.name = "motion_4px",
       .why = "histories are short, equal seeds hardly help",
       .px_per_frame = 4,
       .claims = {{"event_svgf", 0.39}, {"irradiance_cache", 0.182}}},
      {.name = "motion_16px",
       .why = "a tenth of the picture and more is new in every frame",
       .px_per_frame = 16,
       .claims = {{"event_svgf", 0.15}, {"irradiance_cache", 0.079}}},
      {.name = "first_ten_frames",
       .why = "there is no history, and variances are guessed from neighbours",
       .px_per_frame = 1,
       .last = 10,
       .scored = 10,
       .claims = {{"event_svgf", 0.33}, {"irradiance_cache", 0.16}}},
      {.name = "camera_cut",
       .why = "history is of another place, or of the same place seen from elsewhere",
       .trajectory = ownTrajectory("cut"),
       .last = 20,
       .scored = 5,
       .claims = {{"event_svgf",
                   0.12,
                   {"svgf"},
                   "where no history is left it has the difference of two single paths to filter, svgf two "
                   "pictures"},
                  {"irradiance_cache", 0.017}}},
      {.name = "teleports",
       .why = "the same with places that were seen before, which a history of the last frame has forgotten",
       .trajectory = ownTrajectory("teleports"),
       .last = 29,
       .scored = 10,
       .lap = 15,
       .claims = {{.method = "event_svgf", .bound = 0.195},
                  {.method = "irradiance_cache", .bound = 0.072, .lap_ratio = 1}}},
  };
}

}  // namespace saccade::test
