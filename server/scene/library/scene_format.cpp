#include "scene/library/scene_format.h"

#include <algorithm>
#include <iterator>

#include "base/names.h"
#include "scene/files/scene_error.h"
#include "scene/library/scene_folder.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/model/model_scene.h"
#include "scene/motion/bodies.h"
#include "scene/motion/own_motions.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

const SceneFormat* findFormat(const fs::path& path) {
  for (const SceneFormat& format : sceneFormats())
    if (path.extension() == format.extension) return &format;
  return nullptr;
}

std::string join(std::string SceneFormat::*text) {
  std::vector<std::string> all;
  for (const SceneFormat& format : sceneFormats()) all.push_back(format.*text);
  return joinNames(all);
}

Scene withMotions(Scene scene, const fs::path& file, const LoadOptions& options) {
  scene.motions = readOwnMotions(file, shapeNames(scene), options);
  return scene;
}

}  // namespace

const std::vector<SceneFormat>& sceneFormats() {
  static const std::vector<SceneFormat> formats{{"Mitsuba", ".xml", loadMitsubaXml, outlineMitsubaXml},
                                                {"OBJ", ".obj", loadObjScene, outlineModelScene},
                                                {"PLY", ".ply", loadPlyScene, outlineModelScene}};
  return formats;
}

const SceneFormat& formatOf(const fs::path& path) {
  if (const SceneFormat* format = findFormat(path)) return *format;
  throw SceneError(formatFault(path));
}

Scene loadSceneFile(const fs::path& file, const LoadOptions& options) {
  return withMotions(formatOf(file).load(file.string(), options), file, options);
}

Scene outlineSceneFile(const fs::path& file, const LoadOptions& options) {
  return withMotions(formatOf(file).outline(file.string(), options), file, options);
}

std::string formatFault(const fs::path& path) {
  if (findFormat(path)) return {};
  const std::string extension = path.extension().string();
  const bool opens_in_blender = extension == ".gltf" || extension == ".glb" || extension == ".blend";
  return path.string() + " is not a scene of " + join(&SceneFormat::name) + "; read are " +
         join(&SceneFormat::extension) +
         (opens_in_blender ? "; Blender's add-on mitsuba-blender exports .xml" : "");
}

fs::path sceneFileIn(const fs::path& folder) {
  for (const char* stem : kSceneStems)
    for (const SceneFormat& format : sceneFormats())
      if (const fs::path file = folder / (stem + format.extension); !isAbsent(file)) return file;
  return folder / (kSceneStems[0] + sceneFormats().front().extension);
}

bool isSceneFile(const fs::path& file) {
  return std::find(std::begin(kSceneStems), std::end(kSceneStems), file.stem()) != std::end(kSceneStems);
}

bool looksLikeFile(const std::string& text) {
  return text.find('/') != text.npos || fs::path(text).has_extension();
}

}  // namespace saccade
