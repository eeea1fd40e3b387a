#include "scene/mitsuba/mitsuba_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/files/limits.h"
#include "scene/mitsuba/mitsuba_environment.h"
#include "scene/mitsuba/mitsuba_transform.h"
#include "scene/sky/preetham_sky.h"
#include "scene/sky/sun.h"

namespace saccade {
namespace {

constexpr int kWidth = 512, kHeight = 256;  // of the picture of a sky, as in Mitsuba

// A unit direction with x to the east, y up and z to the south: the space of an environment's picture.
Vec3d direction(double zenith, double azimuth) {
  return {std::sin(azimuth) * std::sin(zenith), std::cos(zenith), -std::cos(azimuth) * std::sin(zenith)};
}

// These axes in those of the emitter.
Affine axesOf(const XmlFile& file) {
  if (file.isMitsuba0()) return {};
  return {{0, -1, 0}, {0, 0, 1}, {1, 0, 0}, {}};
}

Vec3d inverseOf(const Affine& orthonormal, Vec3d v) {
  return {dot(orthonormal.x, v), dot(orthonormal.y, v), dot(orthonormal.z, v)};
}

int wholeNumber(const XmlFile& file, pugi::xml_node emitter, Properties& properties, const std::string& name,
                int fallback, int least, int most) {
  const double value = properties.number(name, fallback);
  if (!(value >= least && value <= most) || value != std::floor(value))
    throw file.error(emitter, name + " must be a whole number from " + std::to_string(least) + " to " +
                                  std::to_string(most));
  return static_cast<int>(value);
}

SunTime readTime(const XmlFile& file, pugi::xml_node emitter, Properties& properties) {
  SunTime t;
  const auto whole = [&](const char* name, int fallback, int least, int most) {
    return wholeNumber(file, emitter, properties, name, fallback, least, most);
  };
  t.year = whole("year", t.year, 1900, 2100);
  t.month = whole("month", t.month, 1, 12);
  t.day = whole("day", t.day, 1, 31);
  t.hour = properties.number("hour", t.hour);
  t.minute = properties.number("minute", t.minute);
  t.second = properties.number("second", t.second);
  t.latitude = properties.number("latitude", t.latitude);
  t.longitude = properties.number("longitude", t.longitude);
  t.timezone = properties.number("timezone", t.timezone);
  return t;
}

// The unit direction to the sun: given in the world, or by time and place.
Vec3d readSun(const XmlFile& file, pugi::xml_node emitter, Properties& properties, const Affine& to_world) {
  Vec3d sun;
  if (const auto given = properties.vector("sun_direction")) {
    sun = inverseOf(to_world, *given / length(*given));
  } else {
    const SunPlace place = sunPlace(readTime(file, emitter, properties));
    sun = direction(place.zenith, place.azimuth);
  }
  if (!(sun.y > 0)) throw file.error(emitter, "the sun is below the horizon, or its direction is 0");
  return sun;
}

double readScale(const XmlFile& file, pugi::xml_node emitter, Properties& properties, const std::string& name,
                 double fallback) {
  const double scale = properties.number(name, fallback);
  if (!(scale >= 0 && scale <= kMaxRadiance))
    throw file.error(emitter, "the " + name + " must be within [0, 1e18]");
  return scale;
}

Picture pictureOf(const PreethamSky& sky, Vec3d sun, bool extend) {
  Picture picture{kWidth, kHeight, std::vector<Rgb>(std::size_t{kWidth} * kHeight)};
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const double row = static_cast<double>(i / kWidth) + 0.5, column = static_cast<double>(i % kWidth) + 0.5;
    const Vec3d d = direction(row / kHeight * std::numbers::pi, column / kWidth * 2 * std::numbers::pi);
    if (d.y > 0 || extend)
      picture.pixels[i] = sky.radiance(d.y, std::acos(std::clamp(dot(d, sun), -1.0, 1.0)));
  }
  return picture;
}

// Properties that Mitsuba has, and that change nothing here, as Scene::unread tells.
void ignoreRest(Properties& properties) {
  properties.neutral("stretch", 1);
  for (const char* tag : {"float", "rgb", "spectrum"}) properties.ignore(tag, {"albedo"});
  properties.ignore("float", {"sun_radius_scale", "sun_aperture"});
  properties.ignore("integer", {"resolution"});
}

}  // namespace

void readSky(const XmlFile& file, pugi::xml_node emitter, const std::string& type, Properties& properties,
             FileLoads& loads, Scene& scene) {
  const Affine placed = parseTransform(file, properties.object("transform", "to_world"));
  const Affine to_world = orthonormal(file, emitter, placed) * axesOf(file);
  const double turbidity = properties.number("turbidity", 3);
  if (!(turbidity >= kLeastTurbidity && turbidity <= kMostTurbidity))
    throw file.error(emitter, "the turbidity must be within [2, 10]");
  const Vec3d sun = readSun(file, emitter, properties, to_world);
  const double scale = readScale(file, emitter, properties, "scale", 1);
  const double of_sun = type == "sky" ? 0 : readScale(file, emitter, properties, "sun_scale", scale);
  const double of_sky = type == "sun" ? 0 : readScale(file, emitter, properties, "sky_scale", scale);
  const bool extend = properties.flag("extend", false);
  ignoreRest(properties);
  const double zenith = std::acos(std::min(sun.y, 1.0));
  if (of_sun > 0) {
    const Rgb irradiance = sunIrradiance(turbidity, zenith) * static_cast<float>(of_sun);
    scene.directional_lights.push_back({toFloat(-mapVector(to_world, sun)), irradiance});
    scene.unread.push_back("the sun is a directional light, so that its shadows have sharp edges");
  }
  if (of_sky == 0) return;
  const float factor = static_cast<float>(of_sky);
  addEnvironment(file, emitter, scene, {{factor, factor, factor}, {}, to_world});
  scene.unread.push_back(
      "the sky is that of Preetham, and of Hosek and Wilkie in Mitsuba: the albedo of the ground does not "
      "count");
  loads.add(file.errorsAt(emitter), [&loads, &scene, sun, turbidity, zenith, extend] {
    loads.takePixels(std::size_t{kWidth} * kHeight);
    scene.environment->picture = pictureOf(PreethamSky(turbidity, zenith), sun, extend);
  });
}

}  // namespace saccade
