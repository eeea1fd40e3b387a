// The cases of where bodies move, of what they are made of, and of the light that falls on them.
#include "stability/cases.h"

namespace saccade::test {
namespace {

StabilityCase movingThings(const char* name, const char* why, std::vector<std::string> objects) {
  return {.name = name,
          .why = why,
          .scene = ownScene("moving_things"),
          .trajectory = "still",
          .objects = std::move(objects)};
}

}  // namespace

std::vector<StabilityCase> bodyPlaceCases() {
  std::vector<StabilityCase> all{
      {.name = "body_comes_near",
       .why = "coarse cells reach over the foot of a body, and over the gap between two",
       .trajectory = "still",
       .objects = {"tall_block=slide:0.08/frame"},
       .claims = {{"event_svgf", 0.099}, {"irradiance_cache", 0.081}}},
      {.name = "body_swings_back",
       .why = "its light has changed one way for a while, and changes back",
       .trajectory = "still",
       .objects = {"tall_block=swing:0.72"},
       .rate_hz = 12,
       .last = 9,
       .claims = {{"event_svgf", 0.0528}, {"irradiance_cache", 0.0417}}},
      {.name = "body_spins_and_camera",
       .why = "the normals of a body turn, and the picture moves",
       .scene = "cornell-bunny",
       .objects = {"bunny=spin:2/frame"},
       .px_per_frame = 0.5,
       .claims = {{"event_svgf", 0.406}, {"irradiance_cache", 0.224}}},
      {.name = "body_under_a_sky",
       .why = "light of all directions changes around it",
       .scene = ownScene("open_sky"),
       .trajectory = "still",
       .objects = {"ball=slide:0.04/frame"},
       .claims = {{"event_svgf", 0.0245}, {"irradiance_cache", 0.0119}}},
      {.name = "body_under_lamp_sun_and_sky",
       .why = "each casts a shadow of its own kind",
       .scene = ownScene("near_and_far"),
       .trajectory = "still",
       .objects = {"block=spin:3/frame"},
       .claims = {{"event_svgf", 0.00266}, {"irradiance_cache", 0.000918}}},
      {.name = "body_under_a_flickering_lamp",
       .why = "the strength of a lamp changes while a body moves",
       .scene = ownScene("flickering_lamp"),
       .trajectory = "still",
       .objects = {"ball=slide:0.04/frame"},
       .rate_hz = 500,
       .claims = {{"event_svgf", 0.41}, {"irradiance_cache", 0.0568}}},
      {.name = "lacquered_body",
       .why = "its highlights move unlike its surface",
       .scene = ownScene("glossy_rails"),
       .trajectory = "still",
       .objects = {"leg_1=slide:0.03/frame"},
       .claims = {{"event_svgf", 0.0329}, {"irradiance_cache", 0.0244}}},
      {.name = "glass_body",
       .why = "what is seen through it moves unlike its surface",
       .scene = ownScene("glass_and_mirror"),
       .trajectory = "still",
       .objects = {"glass_ball=slide:0.03/frame"},
       .claims = {{"event_svgf", 0.174}, {"irradiance_cache", 0.159}}},
  };
  const auto add = [&](StabilityCase c, std::vector<Claim> claims) {
    c.claims = std::move(claims);
    all.push_back(std::move(c));
  };
  add(movingThings("turntable", "it slides in itself, and its pattern moves", {"table=spin:3/frame"}),
      {{"event_svgf", 0.0949}, {"irradiance_cache", 0.0137}});
  add(movingThings("body_in_a_mirror", "its picture in a mirror moves, too", {"ball=slide:0.05/frame"}),
      {{"event_svgf", 0.0576}, {"irradiance_cache", 0.0386}});
  add(movingThings("body_small_and_fast", "it covers other pixels in every frame",
                   {"marble=slide:0.15/frame"}),
      {{"event_svgf", 0.00387},
       {"irradiance_cache",
        0.00178,
        {"adaptive_denoising"},
        "by a tenth; light hardly changes, and adaptive_denoising sees only what moves"}});
  add(movingThings("body_jumps", "it is elsewhere at once", {"ball=" + ownTrajectory("ball_jumps")}),
      {{"event_svgf", 0.144}, {"irradiance_cache", 0.0719}});
  add(movingThings("body_passes", "it enters the view, and leaves it",
                   {"ball=" + ownTrajectory("ball_passes")}),
      {{"event_svgf", 0.138, {"svgf", "svgf:as_falcor=1"}, "by a sixth; why is not understood"},
       {"irradiance_cache", 0.0654}});
  add(movingThings("bodies_and_lamp", "three bodies cast shadows on each other, and a lamp is one of them",
                   {"ball=slide:0.04/frame", "table=spin:2/frame", "side_lamp=slide:-0.04/frame"}),
      {{"event_svgf", 0.113}, {"irradiance_cache", 0.0438}});
  return all;
}

}  // namespace saccade::test
