// THE list of the scene formats that are read. A new format needs a row there and a folder of its own beside
// scene/mitsuba.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/files/load_options.h"
#include "scene/scene.h"

namespace saccade {

struct SceneFormat {
  std::string name;       // "Mitsuba", for messages
  std::string extension;  // ".xml"
  // Both throw SceneError. outline() throws where load() would, but reads no mesh and no picture: its meshes
  // have names alone.
  Scene (*load)(const std::string& path, const LoadOptions& options);
  Scene (*outline)(const std::string& path, const LoadOptions& options);
  bool has_paths = false;   // its files may have Scene::paths
  bool has_values = false;  // values.toml may stand beside its files
  bool takes_sky = true;    // sky.toml may stand beside its files
  // The names of the animations of a file, in its order, of which LoadOptions or motion.toml may choose one.
  // Null: there are none. Throws SceneError.
  std::vector<std::string> (*animations)(const std::string& path, const LoadOptions& options) = nullptr;
};

const std::vector<SceneFormat>& sceneFormats();

// The format of a file, by its extension. Throws SceneError with formatFault().
const SceneFormat& formatOf(const std::filesystem::path& path);
// The scene of a file, with the motions that its folder gives it, and without the paths of which its folder
// has a trajectory. Both throw SceneError; outlineSceneFile() is as SceneFormat::outline.
Scene loadSceneFile(const std::filesystem::path& file, const LoadOptions& options);
Scene outlineSceneFile(const std::filesystem::path& file, const LoadOptions& options);
// "a.fbx is not a scene of Mitsuba, ...; read are .xml, ...", and what to do with Blender's files; empty
// where the format is known.
std::string formatFault(const std::filesystem::path& path);

// The names of a scene's file in its folder, without extension; the first comes before the others.
inline constexpr const char* kSceneStems[] = {"scene", "model"};

// "scene.xml, scene.gltf, ...", for messages: the first of these names with each extension.
std::string sceneFileNames();

// The file of the scene in `folder`: one of these names, with the extension of the first format that has a
// file there. Where none has, the first name and that of the first format.
std::filesystem::path sceneFileIn(const std::filesystem::path& folder);

// Whether a file has one of these names, so that the scene has the name of its folder.
bool isSceneFile(const std::filesystem::path& file);

// Whether someone who gives `text` for a scene means a file rather than a name.
bool looksLikeFile(const std::string& text);

}  // namespace saccade
