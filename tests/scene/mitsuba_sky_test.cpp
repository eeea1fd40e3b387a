#include <cmath>
#include <numbers>

#include "scene/mitsuba_scratch.h"
#include "scene/sky/preetham_sky.h"
#include "scene/sky/sun.h"

namespace saccade {
namespace {

Scene under(const std::string& type, const std::string& properties, const std::string& version = "0.6.0") {
  const Scratch files;
  return loadBody(files, "<emitter type='" + type + "'>" + properties + "</emitter>", version);
}

std::string direction(const std::string& xyz) {
  return "<vector name='sunDirection' value='" + xyz + "'/>";
}

// The brightest pixel of the sky, as a direction of the world.
Vec3d brightest(const Scene& scene) {
  const Picture& picture = scene.environment->picture;
  std::size_t best = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    if (luminance(picture.pixels[i]) > luminance(picture.pixels[best])) best = i;
  const auto width = static_cast<std::size_t>(picture.width);
  const double azimuth = (static_cast<double>(best % width) + 0.5) / picture.width * 2 * std::numbers::pi;
  const double zenith = (static_cast<double>(best / width) + 0.5) / picture.height * std::numbers::pi;
  return mapVector(scene.environment->to_world, {std::sin(azimuth) * std::sin(zenith), std::cos(zenith),
                                                 -std::cos(azimuth) * std::sin(zenith)});
}

TEST(MitsubaSky, IsBrightestAroundTheSun) {
  const std::string turned = "<transform name='toWorld'><rotate x='1' angle='90'/></transform>";
  for (const char* version : {"0.6.0", "3.6.0"})
    for (const std::string& placed : {std::string(), turned}) {
      const bool up_is_z = (version[0] == '3') == placed.empty();
      if (version[0] == '3' && !placed.empty()) continue;  // up is -y there
      const Scene s = under("sunsky", placed + direction(up_is_z ? "2, 1, 3" : "2, 3, 1"), version);
      const Vec3d sun = normalize(up_is_z ? Vec3d{2, 1, 3} : Vec3d{2, 3, 1});
      EXPECT_GT(dot(brightest(s), sun), 0.999) << version << placed;
      ASSERT_EQ(s.directional_lights.size(), 1u);
      expectNear(toDouble(s.directional_lights[0].direction), -sun, 1e-6);
    }
}

TEST(MitsubaSky, ScalesItsParts) {
  const std::string parts = direction("0, 1, 0") + "<float name='turbidity' value='4'/>";
  const Scene both = under("sunsky", parts +
                                         "<float name='sunScale' value='2'/><float name='skyScale' "
                                         "value='3'/>");
  const Rgb irradiance = sunIrradiance(4, 0);
  EXPECT_FLOAT_EQ(both.directional_lights.at(0).irradiance.y, 2 * irradiance.y);
  EXPECT_EQ(both.environment->radiance, (Rgb{3, 3, 3}));
  const Scene sky = under("sky", parts), sun = under("sun", parts + "<float name='scale' value='5'/>");
  EXPECT_TRUE(sky.directional_lights.empty());
  EXPECT_FALSE(sun.environment);
  EXPECT_FLOAT_EQ(sun.directional_lights.at(0).irradiance.y, 5 * irradiance.y);
  const Picture& picture = sky.environment->picture;
  const auto up = static_cast<double>(0.5 / picture.height) * std::numbers::pi;
  EXPECT_FLOAT_EQ(picture.pixels[0].x, PreethamSky(4, 0).radiance(std::cos(up), up).x);
  EXPECT_EQ(picture.pixels.back(), Rgb{});  // below the horizon
  const Scene extended = under("sky", parts + "<boolean name='extend' value='true'/>");
  EXPECT_GT(extended.environment->picture.pixels.back().x, 0);
}

// At noon of Greenwich in March the sun of London is in the south.
TEST(MitsubaSky, KnowsTheSunByTimeAndPlace) {
  const std::string place =
      "<integer name='year' value='2010'/><integer name='month' value='3'/><integer name='day' value='20'/>"
      "<float name='hour' value='12'/><float name='timezone' value='0'/><float name='latitude' "
      "value='51.5'/><float name='longitude' value='0'/>";
  const double height = (90 - 51.5) * std::numbers::pi / 180;  // of the sun at noon of an equinox
  const auto to = [&](const std::string& version) {
    return -toDouble(under("sun", place, version).directional_lights.at(0).direction);
  };
  expectNear(to("0.6.0"), {0, std::sin(height), std::cos(height)}, 0.04);
  expectNear(to("3.6.0"), {std::cos(height), 0, std::sin(height)}, 0.04);
}

TEST(MitsubaSky, TellsWhatItIsNot) {
  const Scene s = under("sunsky",
                        "<rgb name='albedo' value='0.3'/><integer name='resolution' value='1024'/>"
                        "<float name='sunRadiusScale' value='0'/>");
  ASSERT_EQ(s.unread.size(), 2u);
  expectContains(s.unread[0], "the sun is a directional light");
  expectContains(s.unread[1], "the sky is that of Preetham");
}

TEST(MitsubaSky, FaultsAreErrors) {
  const auto error = [](const std::string& properties) {
    return errorOf([&] { under("sunsky", properties); });
  };
  expectContains(error("<float name='turbidity' value='1'/>"),
                 "scene.xml:3: the turbidity must be within [2, 10]");
  expectContains(error("<float name='hour' value='23'/>"), "the sun is below the horizon");
  expectContains(error("<float name='hour' value='1e308'/>"), "the sun is below the horizon");
  expectContains(error(direction("0, 0, 0")), "or its direction is 0");
  expectContains(error("<integer name='month' value='13'/>"), "month must be a whole number from 1 to 12");
  expectContains(error("<float name='skyScale' value='-1'/>"), "the sky_scale must be within");
  expectContains(error("<float name='stretch' value='1.5'/>"), "'stretch' is supported at 1 alone");
  expectContains(error(direction("0, 1, 0") + "<float name='hour' value='12'/>"),
                 "<float name=\"hour\"> is not supported");
  const Scratch files;
  const std::string sky = "<emitter type='sky'/>";
  expectContains(errorOf([&] { loadBody(files, sky + "\n" + sky); }), "scene.xml:4: a second emitter");
}

}  // namespace
}  // namespace saccade
