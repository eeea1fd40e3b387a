#include "scene/gltf/gltf_cameras.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/names.h"
#include "scene/gltf/gltf_motions.h"

namespace saccade {
namespace {

constexpr int kLongEdge = 640;       // pixels of a picture, as glTF says the aspect alone
constexpr double kAspect = 4.0 / 3;  // where it says none
constexpr std::size_t kMostPaths = 64;
constexpr double kReach = 10;  // scene units: to what a camera sees

// The field of view and the size of the picture. fov_x from yfov [glTF 2.0, 3.10.3].
void setLens(const JsonNode& perspective, Scene& scene) {
  const double height = perspective.at("yfov").number(), aspect = perspective.number("aspectRatio", kAspect);
  if (!(height > 0 && height < std::numbers::pi)) throw perspective.error("yfov must be within (0, pi)");
  if (!(aspect >= 0.01 && aspect <= 100)) throw perspective.error("aspectRatio must be within [0.01, 100]");
  scene.fov_x_deg = 2 * std::atan(std::tan(height / 2) * aspect) * 180 / std::numbers::pi;
  const auto edge = [](double share) {
    return std::max(1, static_cast<int>(std::lround(kLongEdge * share)));
  };
  scene.width = edge(std::min(1.0, aspect)), scene.height = edge(std::min(1.0, 1 / aspect));
}

}  // namespace

void readCameras(const JsonNode& root, const std::vector<GltfNode>& nodes, const GltfAnimation& animation,
                 Scene& scene) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto index = nodes[i].json.index("camera", root.count("cameras"));
    if (!index) continue;
    const JsonNode camera = root.entry("cameras", *index);
    const std::string type = camera.at("type").text();
    if (type == "orthographic") {
      scene.unread.push_back("the camera " + nodes[i].name + " is orthographic, and not read");
      continue;
    }
    if (scene.paths.size() == kMostPaths) {
      scene.unread.push_back("the cameras after the first " + std::to_string(kMostPaths) + " are not read");
      return;
    }
    if (type != "perspective") throw camera.error("the type is not perspective or orthographic");
    std::vector<TimedPose> poses = cameraPath(animation, i, kReach);
    if (scene.paths.empty()) {
      setLens(camera.at("perspective"), scene);
      scene.T_world_camera = cameraPose(animation.worldAt(i, 0));
    }
    scene.paths.push_back({nodes[i].name, playedPath(std::move(poses), animation.length(), kReach)});
  }
}

}  // namespace saccade
