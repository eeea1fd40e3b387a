// The scenes a server offers: folders scenes/<name>/ with scene.xml, trajectories/*.csv and README.md.
// Nothing outside of scenes/ is read, wherever names and links lead, but the meshes below.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/camera/trajectory.h"
#include "scene/files/load_options.h"
#include "scene/library/scene_folder.h"
#include "scene/scene.h"

namespace saccade {

class SceneLibrary {
 public:
  // `folder` holds one folder per scene. Meshes that are not ours are found at
  //   $bunny   the Debian package glmark2-data       $dragon  $SACCADE_REAL_SCENES/meshes/dragon.obj
  // (SACCADE_REAL_SCENES defaults to ../shared/scenes beside the project folder.)
  explicit SceneLibrary(std::filesystem::path folder);

  // Sorted by name. A scene that cannot be read is among them, with the reason.
  std::vector<SceneEntry> list() const;
  // Throws SceneError: an unknown name (the message lists the valid ones), an unavailable scene, a faulty
  // file.
  Scene load(const std::string& name, const LoadProgress& progress = {}) const;
  // When the scene's scene.xml was last written; the beginning of time where there is none.
  std::filesystem::file_time_type lastChange(const std::string& name) const;
  // A trajectory from the scene's CSV files. Throws SceneError naming the valid ones.
  Trajectory loadTrajectory(const std::string& scene, const std::string& name) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace saccade
