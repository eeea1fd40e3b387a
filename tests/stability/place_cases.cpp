// The cases of where surfaces stand to each other, and to the camera.
#include "stability/cases.h"

namespace saccade::test {

std::vector<StabilityCase> placeCases() {
  return {
      {.name = "thin_walls",
       .why = "a wall without thickness between a bright and a dim room: light may leak along the floor they "
              "share",
       .scene = ownScene("thin_walls"),
       .trajectory = ownTrajectory("over_the_wall"),
       .last = 24,
       .scored = 3,
       .claims = {{"event_svgf", 0.47}, {"irradiance_cache", 0.25}}},
      {.name = "thin_wall_behind",
       .why = "the same from inside: whatever the bright side leaves on the dim side is too bright there",
       .scene = ownScene("thin_walls"),
       .trajectory = ownTrajectory("through_the_wall"),
       .last = 24,
       .scored = 1,
       .judged = &Figures::drift,
       .claims = {{"event_svgf", 0.21}, {"irradiance_cache", 0.175}}},
      {.name = "corners",
       .why = "where things touch, light changes within a pixel",
       .scene = ownScene("corners"),
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.155}, {"irradiance_cache", 0.085}}},
      {.name = "corridor",
       .why = "near walls rush by while the far end hardly moves",
       .scene = ownScene("corridor"),
       .trajectory = "forward",
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.375}, {"irradiance_cache", 0.26}}},
      {.name = "near_and_far",
       .why = "distances in one picture differ by four orders of magnitude",
       .scene = ownScene("near_and_far"),
       .trajectory = ownTrajectory("past_the_panel"),
       .claims = {{"event_svgf", 0.024}, {"irradiance_cache", 0.016}}},
  };
}

}  // namespace saccade::test
