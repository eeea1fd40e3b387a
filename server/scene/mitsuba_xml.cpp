#include "scene/mitsuba_xml.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "scene/mitsuba_material.h"
#include "scene/mitsuba_shape.h"
#include "scene/mitsuba_transform.h"
#include "scene/xml_properties.h"

namespace saccade {
namespace {

constexpr int kMaxFilm = 16384;

int parseFilmEdge(const XmlFile& file, pugi::xml_node film, const std::string& name, int fallback) {
  const double edge = Properties(file, film).number(name, fallback);
  if (!(edge >= 1 && edge <= kMaxFilm) || edge != std::floor(edge))
    throw file.error(film,
                     "the film's " + name + " must be a whole number from 1 to " + std::to_string(kMaxFilm));
  return static_cast<int>(edge);
}

// `fov` as the file gives it, along the axis it names, turned into the horizontal one.
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

void readSensor(const XmlFile& file, pugi::xml_node sensor, Scene& scene) {
  supportedType(file, sensor, {"perspective"});
  Properties properties(file, sensor);
  const double fov = properties.number("fov", 0);
  const std::string axis = properties.text("fov_axis");
  const Affine to_world = parseTransform(file, properties.object("transform", "to_world"));
  const pugi::xml_node film = properties.object("film");
  for (const char* name : {"near_clip", "far_clip", "focus_distance"}) properties.readPast("float", name);
  properties.readPast("sampler", "");
  properties.finish();
  if (film) {
    scene.width = parseFilmEdge(file, film, "width", scene.width);
    scene.height = parseFilmEdge(file, film, "height", scene.height);
  }
  scene.fov_x_deg = horizontalFov(file, sensor, fov, axis, static_cast<double>(scene.width) / scene.height);
  scene.T_world_camera = cameraPose(file, sensor, to_world);
}

}  // namespace

Scene loadMitsubaXml(const std::string& path, const std::map<std::string, std::string>& definitions) {
  const XmlFile file(path, definitions);
  Properties properties(file, file.root());
  Scene scene;
  scene.name = std::filesystem::path(path).parent_path().filename().string();
  const pugi::xml_node sensor = properties.object("sensor");
  if (!sensor) throw file.error(file.root(), "the scene has no <sensor type=\"perspective\">");
  readSensor(file, sensor, scene);

  // Shapes name the materials they use; the others are not read.
  MaterialReader materials(file, scene);
  for (const pugi::xml_node shape : properties.objects("shape")) readShape(file, shape, materials, scene);
  for (const pugi::xml_node node : file.root().children("default"))
    properties.readPast("default", node.attribute("name").value());
  for (const char* tag : {"bsdf", "texture", "integrator", "sampler", "film", "rfilter"})
    properties.readPast(tag, "");
  properties.finish();
  return scene;
}

}  // namespace saccade
