// The cases of what the surfaces are like.
#include "stability/cases.h"

namespace saccade::test {

std::vector<StabilityCase> sceneCases() {
  return {
      {.name = "thin_rails",
       .why = "rails thinner than a pixel come and go with the pixel centres",
       .scene = ownScene("rails"),
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.115}, {"irradiance_cache", 0.055}}},
      {.name = "disocclusion",
       .why = "what a post uncovers has no history",
       .scene = ownScene("rails"),
       .px_per_frame = 4,
       .claims = {{"event_svgf", 0.19}, {"irradiance_cache", 0.078}}},
      {.name = "checkerboard",
       .why = "squares smaller than a pixel, filtered in closed form",
       .scene = ownScene("checkerboard"),
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.185}, {"irradiance_cache", 0.08}}},
      {.name = "bitmap",
       .why = "fine pictures on the walls, filtered by their mip chain",
       .scene = "textured-cornell-box",
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.41}, {"irradiance_cache", 0.168}}},
      {.name = "bitmap_unfiltered",
       .why = "the same without mips: they alias, and every frame is another sample of them",
       .scene = "textured-cornell-box",
       .px_per_frame = 1,
       .mips = false,
       .claims = {{"event_svgf", 0.39}, {"irradiance_cache", 0.158}}},
      {.name = "bitmap_jittered",
       .why = "the same from all over the pixel, against the mean over the pixel",
       .scene = "textured-cornell-box",
       .px_per_frame = 1,
       .jitter = true,
       .claims = {{"event_svgf", 0.49}, {"irradiance_cache", 0.195}}},
      {.name = "glass_and_mirror",
       .why = "what is seen in a mirror or through glass moves unlike their surfaces",
       .scene = ownScene("glass_and_mirror"),
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.475}, {"irradiance_cache", 0.37}}},
      {.name = "glossy_rails",
       .why = "highlights move over lacquer and metal, on legs a few pixels wide",
       .scene = ownScene("glossy_rails"),
       .px_per_frame = 1,
       .claims = {{"event_svgf", 0.18, {"svgf"}, "by a tenth at 128x128; why is not understood"},
                  {"irradiance_cache", 0.12}}},
      {.name = "metal_ball",
       .why = "what brushed metal shows moves unlike its surface, and is not kept on surfaces",
       .scene = ownScene("metal_ball"),
       .px_per_frame = 0.67,
       .claims = {{"event_svgf", 0.29}, {"irradiance_cache", 0.225}}},
  };
}

}  // namespace saccade::test
