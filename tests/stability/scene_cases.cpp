// The cases that have scenes of their own.
#include "stability/cases.h"

namespace saccade::test {
namespace {

std::string scene(const std::string& name) {
  return stabilityFile("scenes/" + name + ".xml");
}

}  // namespace

std::vector<StabilityCase> sceneCases() {
  return {
      {.name = "fireflies",
       .why = "a hot spot that a path finds rarely makes rare large differences",
       .scene = scene("fireflies"),
       .px_per_frame = 1,
       .bound = 1.2},
      {.name = "thin_rails",
       .why = "rails thinner than a pixel come and go with the pixel centres",
       .scene = scene("rails"),
       .px_per_frame = 1,
       .bound = 0.115},
      {.name = "disocclusion",
       .why = "what a post uncovers has no history",
       .scene = scene("rails"),
       .px_per_frame = 4,
       .bound = 0.19},
      {.name = "checkerboard",
       .why = "squares smaller than a pixel, filtered in closed form",
       .scene = scene("checkerboard"),
       .px_per_frame = 1,
       .bound = 0.185},
      {.name = "bitmap",
       .why = "fine pictures on the walls, filtered by their mip chain",
       .scene = "textured-cornell-box",
       .px_per_frame = 1,
       .bound = 0.41},
      {.name = "bitmap_unfiltered",
       .why = "the same without mips: they alias, and every frame is another sample of them",
       .scene = "textured-cornell-box",
       .px_per_frame = 1,
       .mips = false,
       .bound = 0.39},
      {.name = "bitmap_jittered",
       .why = "the same from all over the pixel, against the mean over the pixel",
       .scene = "textured-cornell-box",
       .px_per_frame = 1,
       .jitter = true,
       .bound = 0.49},
      {.name = "glass_and_mirror",
       .why = "what is seen in a mirror or through glass moves unlike their surfaces",
       .scene = scene("glass_and_mirror"),
       .px_per_frame = 1,
       .bound = 0.475},
      {.name = "glossy_rails",
       .why = "highlights move over lacquer and metal, on legs a few pixels wide",
       .scene = scene("glossy_rails"),
       .px_per_frame = 1,
       .bound = 0.18,
       .beaten_by = {"svgf"},
       .beaten_why = "by a tenth at 128x128; why is not understood"},
      {.name = "open_sky",
       .why = "light comes from everywhere, and behind the horizon there is no surface",
       .scene = scene("open_sky"),
       .px_per_frame = 1,
       .bound = 0.054},
      {.name = "black",
       .why = "where I is 0, any light that a filter spills is infinitely more",
       .scene = scene("black"),
       .px_per_frame = 1,
       .bias = 1e-8,
       .bound = 0.135},
      {.name = "dark",
       .why = "I is far below I_eps: there is nothing to be seen",
       .scene = scene("dark"),
       .px_per_frame = 1,
       .bound = 3.5e-5},
      {.name = "dark_seen",
       .why = "the same with an eye for it: small constants in a filter are no longer small",
       .scene = scene("dark"),
       .px_per_frame = 1,
       .bias = 1e-9,
       .bound = 0.19},
      {.name = "bright",
       .why = "emission of 1e6 in view: squares of it are 1e12, and a jump to it is a hundred events",
       .scene = scene("bright"),
       .px_per_frame = 1,
       .bound = 0.2,
       .suppresses = true},
  };
}

std::vector<StabilityCase> lightCases() {
  return {
      {.name = "switched_lamp",
       .why = "all light changes under a still camera, and history goes on with the old",
       .scene = scene("switched_lamp"),
       .trajectory = "still",
       .last = 29,
       .scored = 10,
       .bound = 1,
       .beaten_by = {"pt-correlated"},
       .beaten_why =
           "a tenth of the change shows at once, the rest as false events over the next twenty frames; "
           "pt-correlated remembers nothing"},
      {.name = "flickering_lamp",
       .why = "the same in every frame, up and down: its mean over time is no change",
       .scene = scene("flickering_lamp"),
       .trajectory = "still",
       .last = 29,
       .scored = 10,
       .bound = 0.68},
  };
}

}  // namespace saccade::test
