#include "scene/library/scene_format.h"

#include <algorithm>
#include <iterator>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/files/scene_error.h"
#include "scene/gltf/gltf.h"
#include "scene/library/scene_folder.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/mitsuba/scene_values.h"
#include "scene/model/model_scene.h"
#include "scene/motion/bodies.h"
#include "scene/motion/own_motions.h"
#include "scene/sky/sky_file.h"

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

// Throws where a file beside a scene is one that no scene of its format reads.
void refuseUnread(const fs::path& scene) {
  const SceneFormat& format = formatOf(scene);
  const auto refuse = [&](const char* name, const char* why) {
    const fs::path file = scene.parent_path() / name;
    if (!isAbsent(file))
      throw SceneError(file.string() + " stands beside a scene of " + format.name + ", which has " + why);
  };
  if (!format.takes_sky) refuse(kSkyFile, "emitters of its own: use one of constant or envmap");
  if (!format.has_values && isSceneFile(scene)) refuse(kValuesFile, "no $names");
}

// Motions and trajectories beside the file come before those in it.
Scene withFilesBeside(Scene scene, const fs::path& file, const LoadOptions& options) {
  if (const auto chosen = chosenAnimation(file, options); chosen && !formatOf(file).animations)
    throw chosen->error("there is no animation '" + cutText(chosen->name, kMaxEcho) +
                        "': only files of glTF have any");
  refuseUnread(file);
  for (OwnMotion& motion : readOwnMotions(file, objectNames(scene), options)) {
    std::erase_if(scene.motions, [&](const OwnMotion& other) { return other.name == motion.name; });
    scene.motions.push_back(std::move(motion));
  }
  std::ranges::sort(scene.motions, {}, &OwnMotion::name);
  if (scene.paths.empty()) return scene;
  for (const std::string& name : csvNames(file.parent_path() / "trajectories"))
    std::erase_if(scene.paths, [&](const ScenePath& path) { return path.name == name; });
  return scene;
}

}  // namespace

const std::vector<SceneFormat>& sceneFormats() {
  const auto gltf = [](const char* name, const char* extension) -> SceneFormat {
    return {.name = name,
            .extension = extension,
            .load = loadGltf,
            .outline = outlineGltf,
            .has_paths = true,
            .animations = animationsOfGltf};
  };
  static const std::vector<SceneFormat> formats{
      {.name = "Mitsuba",
       .extension = ".xml",
       .load = loadMitsubaXml,
       .outline = outlineMitsubaXml,
       .has_paths = true,
       .has_values = true,
       .takes_sky = false},
      gltf("glTF", ".gltf"),
      gltf("binary glTF", ".glb"),
      {.name = "OBJ", .extension = ".obj", .load = loadObjScene, .outline = outlineModelScene},
      {.name = "PLY", .extension = ".ply", .load = loadPlyScene, .outline = outlineModelScene}};
  return formats;
}

const SceneFormat& formatOf(const fs::path& path) {
  if (const SceneFormat* format = findFormat(path)) return *format;
  throw SceneError(formatFault(path));
}

Scene loadSceneFile(const fs::path& file, const LoadOptions& options) {
  return withFilesBeside(formatOf(file).load(file.string(), options), file, options);
}

Scene outlineSceneFile(const fs::path& file, const LoadOptions& options) {
  return withFilesBeside(formatOf(file).outline(file.string(), options), file, options);
}

std::string sceneFileNames() {
  std::vector<std::string> all;
  for (const SceneFormat& format : sceneFormats()) all.push_back(kSceneStems[0] + format.extension);
  return joinNames(all);
}

std::string formatFault(const fs::path& path) {
  if (findFormat(path)) return {};
  const bool is_blender = path.extension() == ".blend";
  return path.string() + " is not a scene of " + join(&SceneFormat::name) + "; read are " +
         join(&SceneFormat::extension) + (is_blender ? "; Blender exports glTF" : "");
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
