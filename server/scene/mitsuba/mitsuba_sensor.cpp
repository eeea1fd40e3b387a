#include "scene/mitsuba/mitsuba_sensor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "scene/files/limits.h"
#include "scene/files/text.h"
#include "scene/mitsuba/mitsuba_transform.h"
#include "scene/mitsuba/xml_properties.h"

namespace saccade {
namespace {

constexpr double kHalfDegree = std::numbers::pi / 360;
constexpr double kFilmAspect = 768.0 / 576;  // of Mitsuba's film where the file has none

int parseFilmEdge(const XmlFile& file, pugi::xml_node film, Properties& properties, const std::string& name,
                  int fallback) {
  const double edge = properties.number(name, fallback);
  if (!(edge >= 1 && edge <= kMaxFilmEdge) || edge != std::floor(edge))
    throw file.error(
        film, "the film's " + name + " must be a whole number from 1 to " + std::to_string(kMaxFilmEdge));
  return static_cast<int>(edge);
}

// Twice the angle of this tangent.
double degrees(double tangent) {
  return std::atan(tangent) / kHalfDegree;
}

// The tangent of half the horizontal field of view, over that along `axis`, by its name in Mitsuba.
double horizontalShare(const XmlFile& file, pugi::xml_node sensor, const std::string& axis, double aspect) {
  if (axis.empty() || axis == "x") return 1;
  if (axis == "y") return aspect;
  if (axis == "smaller") return std::max(1.0, aspect);
  if (axis == "larger") return std::min(1.0, aspect);
  if (axis == "diagonal") return aspect / std::hypot(aspect, 1);
  throw file.error(sensor,
                   "fov_axis '" + axis + "' is not supported; supported: x, y, smaller, larger, diagonal");
}

// Of "50mm" or "50".
double parseFocalLength(const XmlFile& file, pugi::xml_node sensor, std::string_view text) {
  if (text.ends_with("mm")) text.remove_suffix(2);
  const auto mm = parseNumber(text);
  if (!mm || !(*mm > 0)) throw file.error(sensor, "the focal_length must be a length above 0, such as 50mm");
  return *mm;
}

// The horizontal field of view in degrees. It is given by `fov` and `fov_axis`, or by the focal length of a
// lens, by default 50 mm. That lens stands before film of 36 mm by 24 mm, of which the diagonal counts.
double readFov(const XmlFile& file, pugi::xml_node sensor, Properties& properties, double aspect) {
  constexpr double kAbsent = std::numeric_limits<double>::infinity();
  const double fov = properties.number("fov", kAbsent);
  const std::string axis = properties.text("fov_axis"), focal = properties.text("focal_length");
  if (fov == kAbsent) {
    const double mm = parseFocalLength(file, sensor, focal.empty() ? "50mm" : focal);
    return degrees(std::hypot(36, 24) / 2 / mm * horizontalShare(file, sensor, "diagonal", aspect));
  }
  if (!focal.empty()) throw file.error(sensor, "the sensor has both a fov and a focal_length");
  if (!(fov > 0 && fov < 180)) throw file.error(sensor, "the fov must be within (0, 180) degrees");
  const double share = horizontalShare(file, sensor, axis, aspect);
  return share == 1 ? fov : degrees(std::tan(fov * kHalfDegree) * share);
}

// Mitsuba's camera axes are x left, y up, z forward; ours x right, y down, z forward. A camera that mirrors
// the picture is taken as one that does not, with the same axes y and z.
Pose cameraPose(const XmlFile& file, pugi::xml_node sensor, const Affine& to_world, Scene& scene) {
  const Vec3d z = normalize(to_world.z), y = normalize(to_world.y), x = normalize(to_world.x);
  const Vec3d left = cross(y, z);
  if (length(left - x) > 1e-3 && length(left + x) > 1e-3)
    throw file.error(sensor, "the sensor's to_world may rotate, translate, scale and mirror, not shear");
  if (dot(left, x) < 0) scene.unread.push_back("the sensor mirrors the picture; it is shown unmirrored");
  const Vec3d down = -normalize(y - z * dot(y, z));
  return {to_world.translation, fromAxes(cross(down, z), down, z)};
}

// The size of the picture. Nothing else of the film changes the light that reaches it. It may be cropped to
// all of itself.
void readFilm(const XmlFile& file, pugi::xml_node film, Scene& scene) {
  Properties properties(file, film);
  scene.width = parseFilmEdge(file, film, properties, "width", scene.width);
  scene.height = parseFilmEdge(file, film, properties, "height", scene.height);
  properties.neutral("crop_offset_x", 0);
  properties.neutral("crop_offset_y", 0);
  properties.neutral("crop_width", scene.width);
  properties.neutral("crop_height", scene.height);
  for (const char* tag : {"rfilter", "string", "boolean", "float"}) properties.ignore(tag);
  properties.finish();
}

}  // namespace

void readSensor(const XmlFile& file, pugi::xml_node sensor, Scene& scene) {
  supportedType(file, sensor, {"perspective"});
  Properties properties(file, sensor);
  const pugi::xml_node film = properties.object("film");
  if (film) readFilm(file, film, scene);
  const double aspect = film ? static_cast<double>(scene.width) / scene.height : kFilmAspect;
  scene.fov_x_deg = readFov(file, sensor, properties, aspect);
  const Affine to_world = parseTransform(file, properties.object("transform", "to_world"));
  scene.T_world_camera = cameraPose(file, sensor, to_world, scene);
  properties.neutral("principal_point_offset_x", 0);
  properties.neutral("principal_point_offset_y", 0);
  properties.ignore("float", {"near_clip", "far_clip", "focus_distance", "shutter_open", "shutter_close"});
  for (const char* tag : {"sampler", "hide"}) properties.ignore(tag);
  properties.finish();
}

}  // namespace saccade
