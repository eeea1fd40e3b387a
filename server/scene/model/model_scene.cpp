#include "scene/model/model_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "scene/default_view.h"
#include "scene/files/confinement.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/mesh/mesh.h"
#include "scene/mesh/mesh_io.h"
#include "scene/model/obj_materials.h"
#include "scene/model/split_mesh.h"
#include "scene/sky/sky_file.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

void requireReadable(const std::string& path, const LoadOptions& options) {
  if (!mayRead(path, options.confined_to)) throw SceneError(path + ": leads out of the folder of the scenes");
  plainFileSize(path);
}

Scene emptyScene(const std::string& path) {
  Scene scene;
  scene.name = fs::path(path).parent_path().filename().string();
  return scene;
}

Mesh placed(Mesh mesh, const std::string& path) {
  mesh.name = fs::path(path).stem().string();
  placeMesh(mesh, {}, false);
  const bool finite = std::all_of(mesh.positions.begin(), mesh.positions.end(),
                                  [](Vec3 p) { return std::isfinite(dot(p, p)); });
  if (!finite) throw SceneError(path + ": a vertex is too far away for float numbers");
  return mesh;
}

void loadSky(const std::string& path, const LoadOptions& options, Scene& scene) {
  FileLoads loads;
  addSkyFile(path, options, loads, scene);
  loads.run(options);
}

}  // namespace

Scene loadObjScene(const std::string& path, const LoadOptions& options) {
  requireReadable(path, options);
  Scene scene = emptyScene(path);
  ObjFile file = loadObjFile(path);
  const ObjMaterials materials(path, file, options);
  scene.meshes = splitMesh(placed(std::move(file.mesh), path), materials.ranges());
  materials.addTo(scene, options);
  loadSky(path, options, scene);
  addDefaults(scene);
  return scene;
}

Scene loadPlyScene(const std::string& path, const LoadOptions& options) {
  requireReadable(path, options);
  Scene scene = emptyScene(path);
  scene.materials.push_back(greyMaterial());
  scene.meshes.push_back(placed(loadPly(path), path));
  loadSky(path, options, scene);
  addDefaults(scene);
  return scene;
}

Scene outlineModelScene(const std::string& path, const LoadOptions& options) {
  requireReadable(path, options);
  Scene scene = emptyScene(path);
  scene.meshes.emplace_back().name = fs::path(path).stem().string();
  FileLoads loads;
  const bool has_sky = addSkyFile(path, options, loads, scene);
  scene.unread.push_back(std::string("a mesh before a default camera") +
                         (has_sky ? "" : "; unless its materials emit, the light is a default"));
  return scene;
}

}  // namespace saccade
