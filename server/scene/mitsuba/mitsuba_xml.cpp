#include "scene/mitsuba/mitsuba_xml.h"

#include <algorithm>
#include <filesystem>

#include "scene/emission_pictures.h"
#include "scene/files/confinement.h"
#include "scene/files/file_loads.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/mitsuba/mitsuba_integrator.h"
#include "scene/mitsuba/mitsuba_light.h"
#include "scene/mitsuba/mitsuba_material.h"
#include "scene/mitsuba/mitsuba_sensor.h"
#include "scene/mitsuba/mitsuba_shape.h"
#include "scene/scene_origin.h"

namespace saccade {
namespace {

void checkTriangles(const XmlFile& file, const Scene& scene) {
  std::size_t triangles = 0;
  for (const Mesh& mesh : scene.meshes) triangles += mesh.triangles.size();
  if (triangles > kMaxTriangles)
    throw file.error(file.root(), "the scene has " + std::to_string(triangles) + " triangles; at most " +
                                      std::to_string(kMaxTriangles) + " are supported");
}

std::string readConfined(const std::string& path, const LoadOptions& options) {
  if (!mayRead(path, options.confined_to)) throw SceneError(path + ": leads out of the folder of the scenes");
  return readFile(path, kMaxXmlBytes);
}

// A further sensor, as a camera path that stands.
ScenePath readFurther(const XmlFile& file, pugi::xml_node sensor, std::size_t number, const Scene& scene) {
  Scene seen;
  seen.origin = scene.origin;
  readSensor(file, sensor, seen);
  const std::string id = sensor.attribute("id").value();
  return {id.empty() ? "sensor_" + std::to_string(number) : id,
          Trajectory({{TimeNs{0}, seen.T_world_camera}})};
}

void readCamera(const XmlFile& file, const std::vector<pugi::xml_node>& sensors, Scene& scene) {
  constexpr std::size_t kMost = 64;
  if (sensors.empty()) throw file.error(file.root(), "the scene has no <sensor type=\"perspective\">");
  readSensor(file, sensors[0], scene);
  for (std::size_t i = 1; i < std::min(sensors.size(), kMost); ++i)
    scene.paths.push_back(readFurther(file, sensors[i], i + 1, scene));
  if (sensors.size() > 1)
    scene.unread.push_back("the first of " + std::to_string(sensors.size()) +
                           " sensors is the camera; the poses of others are trajectories, by their ids");
}

// Runs `read`, whose fault options.fault may take.
template <class Read>
void attempt(const LoadOptions& options, Read read) {
  try {
    read();
  } catch (const SceneError& fault) {
    if (!options.fault) throw;
    options.fault(fault.what());
  }
}

// An area emitter with an id at the top is there for a <ref> of shapes.
bool isForShapes(pugi::xml_node emitter) {
  return emitter.attribute("id") && std::string_view(emitter.attribute("type").value()) == "area";
}

// All but the meshes and pictures, which `loads` will fill in. `scene` must stay where it is until then.
void readScene(const XmlFile& file, const LoadOptions& options, FileLoads& loads, Scene& scene) {
  Properties properties(file, file.root());
  attempt(options, [&] { readCamera(file, properties.objects("sensor"), scene); });
  // Only the materials that shapes use are read.
  TextureReader textures(file, loads, scene);
  MaterialReader materials(file, textures, scene);
  for (const pugi::xml_node shape : properties.objects("shape"))
    attempt(options, [&] { readShape(file, shape, materials, loads, scene); });
  for (const pugi::xml_node emitter : properties.objects("emitter"))
    if (!isForShapes(emitter)) attempt(options, [&] { readLight(file, emitter, loads, scene); });
  attempt(options, [&] { scene.bounces = readBounces(file, properties.objects("integrator")); });
  for (const char* tag : {"default", "path", "bsdf", "texture", "sampler", "film", "rfilter"})
    properties.ignore(tag);
  attempt(options, [&] { properties.finish(); });
}

Scene loadScene(const XmlFile& file, const std::string& path, const LoadOptions& options, Vec3d origin) {
  FileLoads loads;
  Scene scene;
  scene.name = std::filesystem::path(path).parent_path().filename().string();
  scene.origin = origin;
  readScene(file, options, loads, scene);
  loads.run(options);
  const std::vector<Rgb> means = takeEmissionMeans(scene);
  for (Mesh& mesh : scene.meshes)
    mesh.radiance = mesh.radiance * means[static_cast<std::size_t>(mesh.material)];
  checkTriangles(file, scene);
  return scene;
}

}  // namespace

Scene loadMitsubaXml(const std::string& path, const LoadOptions& options) {
  return parseMitsubaXml(readConfined(path, options), path, options);
}

Scene parseMitsubaXml(std::string text, const std::string& path, const LoadOptions& options) {
  const XmlFile file(std::move(text), path, options);
  return loadAtOrigin([&](Vec3d origin) { return loadScene(file, path, options, origin); });
}

Scene outlineMitsubaXml(const std::string& path, const LoadOptions& options) {
  const XmlFile file(readConfined(path, options), path, options);
  FileLoads not_run;
  Scene scene;
  readScene(file, options, not_run, scene);
  return scene;
}

}  // namespace saccade
