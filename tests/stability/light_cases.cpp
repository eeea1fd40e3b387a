// The cases of what the light is like.
#include "stability/cases.h"

namespace saccade::test {

std::vector<StabilityCase> lightCases() {
  return {
      {.name = "fireflies",
       .why = "a hot spot that a path finds rarely makes rare large differences",
       .scene = ownScene("fireflies"),
       .px_per_frame = 1,
       .scored = 1,
       .truth_paths = 8,
       .claims =
           {{"event_svgf",
             0.98,
             {"svgf", "svgf:as_falcor=1"},
             "it misses fewer events, but a firefly in a difference makes twice as many false ones"},
            {"irradiance_cache",
             0.88,
             {"svgf", "svgf:as_falcor=1", "event_svgf", "relax", "a_svgf"},
             "it makes half as many false events, but misses more: so few paths are no proof of a spot"}}},
      {.name = "open_sky",
       .why = "light comes from everywhere, and behind the horizon there is no surface",
       .scene = ownScene("open_sky"),
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.054}, {"irradiance_cache", 0.032}}},
      {.name = "black",
       .why = "where I is 0, any light that a filter spills is infinitely more",
       .scene = ownScene("black"),
       .px_per_frame = 1,
       .bias = 1e-8,
       .claims = {{"event_svgf", 0.135}, {"irradiance_cache", 0.0275}}},
      {.name = "dark",
       .why = "I is far below I_eps: there is nothing to be seen",
       .scene = ownScene("dark"),
       .px_per_frame = 1,
       .claims = {{"event_svgf", 3.5e-5}, {"irradiance_cache", 2.5e-05}}},
      {.name = "dark_seen",
       .why = "the same with an eye for it: small constants in a filter are no longer small",
       .scene = ownScene("dark"),
       .px_per_frame = 1,
       .bias = 1e-9,
       .claims = {{"event_svgf", 0.19}, {"irradiance_cache", 0.14}}},
      {.name = "bright",
       .why = "emission of 1e6 in view: squares of it are 1e12, and a jump to it is a hundred events",
       .scene = ownScene("bright"),
       .px_per_frame = 1,
       .suppresses = true,
       .claims = {{"event_svgf", 0.2}, {"irradiance_cache", 0.093}}},
      {.name = "switched_lamp",
       .why = "all light changes under a still camera, and history goes on with the old",
       .scene = ownScene("switched_lamp"),
       .trajectory = "still",
       .last = 29,
       .scored = 10,
       .claims =
           {{"event_svgf",
             1,
             {"pt-correlated"},
             "a tenth of the change shows at once, the rest as false events over the next twenty frames; "
             "pt-correlated remembers nothing"},
            {"irradiance_cache", 0.02}}},
      {.name = "flickering_lamp",
       .why = "the same in every frame, up and down: its mean over time is no change",
       .scene = ownScene("flickering_lamp"),
       .trajectory = "still",
       .last = 29,
       .scored = 10,
       .claims = {{"event_svgf", 0.68}, {"irradiance_cache", 0.15}}},
  };
}

}  // namespace saccade::test
