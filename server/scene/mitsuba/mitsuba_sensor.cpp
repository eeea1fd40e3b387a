#include "scene/mitsuba/mitsuba_sensor.h"

#include <cmath>
#include <numbers>

#include "scene/files/limits.h"
#include "scene/mitsuba/mitsuba_transform.h"
#include "scene/mitsuba/xml_properties.h"

namespace saccade {
namespace {

int parseFilmEdge(const XmlFile& file, pugi::xml_node film, Properties& properties, const std::string& name,
                  int fallback) {
  const double edge = properties.number(name, fallback);
  if (!(edge >= 1 && edge <= kMaxFilmEdge) || edge != std::floor(edge))
    throw file.error(
        film, "the film's " + name + " must be a whole number from 1 to " + std::to_string(kMaxFilmEdge));
  return static_cast<int>(edge);
}

// The horizontal field of view, from `fov` along the axis that the file names.
double horizontalFov(const XmlFile& file, pugi::xml_node sensor, double fov, const std::string& axis,
                     double aspect) {
  if (!(fov > 0 && fov < 180))
    throw file.error(sensor, "the sensor needs a <float name=\"fov\"> within (0, 180)");
  const bool along_y = axis == "y" || (axis == "smaller" && aspect > 1) || (axis == "larger" && aspect < 1);
  if (!along_y && !axis.empty() && axis != "x" && axis != "smaller" && axis != "larger")
    throw file.error(sensor, "fov_axis '" + axis + "' is not supported; supported: x, y, smaller, larger");
  if (!along_y) return fov;
  constexpr double kHalfDegree = std::numbers::pi / 360;
  return std::atan(std::tan(fov * kHalfDegree) * aspect) / kHalfDegree;
}

// Mitsuba's camera axes are x left, y up, z forward; ours x right, y down, z forward.
Pose cameraPose(const XmlFile& file, pugi::xml_node sensor, const Affine& to_world) {
  const Vec3d z = normalize(to_world.z), y = normalize(to_world.y), x = normalize(to_world.x);
  if (length(cross(y, z) - x) > 1e-3)
    throw file.error(sensor, "the sensor's to_world may rotate, translate and scale, not shear or mirror");
  const Vec3d down = -normalize(y - z * dot(y, z));
  return {to_world.translation, fromAxes(cross(down, z), down, z)};
}

// The size of the picture; the other properties of the film are ignored.
void readFilm(const XmlFile& file, pugi::xml_node film, Scene& scene) {
  Properties properties(file, film);
  scene.width = parseFilmEdge(file, film, properties, "width", scene.width);
  scene.height = parseFilmEdge(file, film, properties, "height", scene.height);
  properties.ignore("rfilter");
  properties.ignore("string", {"file_format", "pixel_format", "component_format", "tonemap_method"});
  properties.ignore("boolean", {"banner", "attach_log", "high_quality_edges", "sample_border"});
  properties.ignore("float", {"gamma", "exposure", "key", "burn"});
  properties.finish();
}

}  // namespace

void readSensor(const XmlFile& file, pugi::xml_node sensor, Scene& scene) {
  supportedType(file, sensor, {"perspective"});
  Properties properties(file, sensor);
  const double fov = properties.number("fov", 0);
  const std::string axis = properties.text("fov_axis");
  const Affine to_world = parseTransform(file, properties.object("transform", "to_world"));
  const pugi::xml_node film = properties.object("film");
  properties.ignore("float", {"near_clip", "far_clip", "focus_distance", "shutter_open", "shutter_close"});
  properties.ignore("sampler");
  properties.finish();
  if (film) readFilm(file, film, scene);
  scene.fov_x_deg = horizontalFov(file, sensor, fov, axis, static_cast<double>(scene.width) / scene.height);
  scene.T_world_camera = cameraPose(file, sensor, to_world);
}

}  // namespace saccade
