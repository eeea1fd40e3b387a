// The cases of how bodies move.
#include "stability/cases.h"

namespace saccade::test {

std::vector<StabilityCase> bodyCases() {
  return {
      {.name = "body_slides",
       .why = "its shadow and its light on walls change slowly, before a camera that stands",
       .trajectory = "still",
       .objects = {"tall_block=slide:-0.06/frame"},
       .claims = {{"event_svgf", 0.055}, {"irradiance_cache", 0.048}}},
      {.name = "body_and_camera",
       .why = "the motion of the picture and that of a body differ",
       .objects = {"tall_block=slide:-0.06/frame"},
       .px_per_frame = 0.5,
       .claims = {{"event_svgf", 0.335}, {"irradiance_cache", 0.115}}},
      {.name = "body_spins",
       .why = "normals turn under standing light",
       .scene = "cornell-bunny",
       .trajectory = "still",
       .objects = {"bunny=spin:2/frame"},
       .claims = {{"event_svgf",
                   0.255,
                   {"svgf", "svgf:as_falcor=1"},
                   "its history of the difference is of other normals, and svgf has none"},
                  {"irradiance_cache", 0.182}}},
      {.name = "body_fast",
       .why = "what it uncovers has no history",
       .trajectory = "still",
       .objects = {"tall_block=slide:-0.2/frame"},
       .last = 6,
       .claims = {{"event_svgf", 0.121}, {"irradiance_cache", 0.087}}},
      {.name = "body_turns_back",
       .why = "changes of light that were learned have the wrong sign",
       .trajectory = "still",
       .objects = {"tall_block=slide:-0.72"},
       .rate_hz = 12,
       .claims = {{"event_svgf", 0.074}, {"irradiance_cache", 0.058}}},
      {.name = "bodies_slide_and_spin",
       .why = "each casts a shadow on the other",
       .trajectory = "still",
       .objects = {"tall_block=slide:-0.05/frame", "short_block=spin:3/frame"},
       .claims = {{"event_svgf", 0.102}, {"irradiance_cache", 0.103}}},
      {.name = "lamp_slides",
       .why = "all light changes, and all shadows move",
       .trajectory = "still",
       .objects = {"light=slide:0.04/frame"},
       .claims = {{"event_svgf", 0.039}, {"irradiance_cache", 0.033}}},
      {.name = "metal_body",
       .why = "the grid does not hold its light",
       .scene = ownScene("metal_ball"),
       .trajectory = "still",
       .objects = {"ball=slide:0.03/frame"},
       .claims = {{"event_svgf", 0.178}, {"irradiance_cache", 0.139}}},
  };
}

}  // namespace saccade::test
