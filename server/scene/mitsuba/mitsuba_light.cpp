#include "scene/mitsuba/mitsuba_light.h"

#include <cmath>
#include <numbers>

#include "scene/files/limits.h"
#include "scene/mitsuba/mitsuba_environment.h"
#include "scene/mitsuba/mitsuba_sky.h"
#include "scene/mitsuba/mitsuba_transform.h"
#include "scene/mitsuba/xml_properties.h"
#include "scene/sky/sky_picture.h"

namespace saccade {
namespace {

// White light of 1 by default.
Rgb readColor(Properties& properties, const char* name) {
  return properties.quantity(name, kMaxRadiance).value_or(Rgb{1, 1, 1});
}

void readEnvmap(const XmlFile& file, pugi::xml_node emitter, Properties& properties, FileLoads& loads,
                Scene& scene) {
  const float scale = static_cast<float>(properties.number("scale", 1));
  if (!(scale >= 0 && scale <= kMaxRadiance)) throw file.error(emitter, "the scale must be within [0, 1e18]");
  const Affine to_world = parseTransform(file, properties.object("transform", "to_world"));
  const std::string path = file.locate(emitter, properties.text("filename"));
  addEnvironment(file, emitter, scene, {{scale, scale, scale}, {}, orthonormal(file, emitter, to_world)});
  addSkyPicture(file.errorsAt(emitter), path, loads, scene);
}

// By which objects are moved; empty where the file gives none.
std::string nameOf(pugi::xml_node emitter) {
  return emitter.attribute("id").value();
}

void readPoint(const XmlFile& file, pugi::xml_node emitter, Properties& properties, Scene& scene) {
  const Affine to_world = parseTransform(file, properties.object("transform", "to_world"));
  const Vec3d position = properties.vector("position").value_or(to_world.translation);
  scene.point_lights.push_back(
      {toFloat(position - scene.origin), readColor(properties, "intensity"), nameOf(emitter)});
}

// A half-angle in degrees, as radians.
float halfAngle(const XmlFile& file, pugi::xml_node emitter, double degrees, const char* name) {
  if (!(degrees >= 0 && degrees <= 180))
    throw file.error(emitter, "the " + std::string(name) + " must be within [0, 180] degrees");
  return static_cast<float>(degrees * std::numbers::pi / 180);
}

void readSpot(const XmlFile& file, pugi::xml_node emitter, Properties& properties, Scene& scene) {
  const Affine to_world = parseTransform(file, properties.object("transform", "to_world"));
  const double cutoff = properties.number("cutoff_angle", 20);
  const double beam = properties.number("beam_width", cutoff * 3 / 4);
  if (beam > cutoff) throw file.error(emitter, "the beam_width must be at most the cutoff_angle");
  scene.spot_lights.push_back(
      {toFloat(to_world.translation - scene.origin), toFloat(orthonormal(file, emitter, to_world).z),
       readColor(properties, "intensity"), halfAngle(file, emitter, beam, "beam_width"),
       halfAngle(file, emitter, cutoff, "cutoff_angle"), nameOf(emitter)});
}

void readDirectional(const XmlFile& file, pugi::xml_node emitter, Properties& properties, Scene& scene) {
  const Affine to_world = parseTransform(file, properties.object("transform", "to_world"));
  const Vec3d direction = properties.vector("direction").value_or(to_world.z);
  if (!(length(direction) > 0 && std::isfinite(length(direction))))
    throw file.error(emitter, "the direction must not be 0, and finite");
  scene.directional_lights.push_back(
      {toFloat(normalize(direction)), readColor(properties, "irradiance"), nameOf(emitter)});
}

}  // namespace

void readLight(const XmlFile& file, pugi::xml_node emitter, FileLoads& loads, Scene& scene) {
  const std::string type = supportedType(
      file, emitter, {"envmap", "constant", "sky", "sun", "sunsky", "point", "spot", "directional"});
  Properties properties(file, emitter);
  properties.ignore("float", {"sampling_weight"});
  if (type == "envmap") {
    readEnvmap(file, emitter, properties, loads, scene);
  } else if (type == "constant") {
    addEnvironment(file, emitter, scene, {readColor(properties, "radiance"), {}, {}});
  } else if (type == "sky" || type == "sun" || type == "sunsky") {
    readSky(file, emitter, type, properties, loads, scene);
  } else if (type == "point") {
    readPoint(file, emitter, properties, scene);
  } else if (type == "spot") {
    readSpot(file, emitter, properties, scene);
  } else {
    readDirectional(file, emitter, properties, scene);
  }
  properties.finish();
}

}  // namespace saccade
