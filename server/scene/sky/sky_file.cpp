#include "scene/sky/sky_file.h"

#include <cmath>
#include <numbers>

#include "base/text_cut.h"
#include "scene/files/find_file.h"
#include "scene/files/limits.h"
#include "scene/files/scene_error.h"
#include "scene/files/toml_file.h"
#include "scene/sky/sky_picture.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileBytes = 1 << 20;

class SkyReader {
 public:
  explicit SkyReader(fs::path file) : file_(std::move(file)) {}

  SceneError error(const toml::node& at, const std::string& what) const {
    return SceneError(file_.string(), static_cast<long>(at.source().begin.line), what);
  }

  void checkKeys(const toml::table& table) const {
    for (const auto& [key, node] : table)
      if (key != "radiance" && key != "picture" && key != "turn")
        throw error(node, "there is no key '" + cutText(key.str(), kMaxEcho) +
                              "'; there are: radiance, picture, turn");
  }

  Rgb radiance(const toml::table& table) const {
    const toml::node* node = table.get("radiance");
    if (!node) return {1, 1, 1};
    const toml::array* colors = node->as_array();
    if (colors && colors->size() != 3) throw error(*node, "radiance is one number, or three in brackets");
    const auto color = [&](std::size_t i) {
      const toml::node& at = colors ? *colors->get(i) : *node;
      const double value = at.value<double>().value_or(-1);
      if (!at.is_number() || !(value >= 0 && value <= kMaxRadiance))
        throw error(*node, "radiance must be numbers within [0, 1e18]");
      return static_cast<float>(value);
    };
    return {color(0), color(1), color(2)};
  }

  // About +y. From above, counter-clockwise is from +z to +x.
  Affine turn(const toml::table& table) const {
    const toml::node* node = table.get("turn");
    if (!node) return {};
    const double degrees = node->value<double>().value_or(kMaxTurn + 1);
    if (!node->is_number() || !(std::abs(degrees) <= kMaxTurn))
      throw error(*node, "turn must be a number of degrees within [-360, 360]");
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
  }

  std::string picture(const toml::node& node, const LoadOptions& options) const {
    const auto name = node.value_exact<std::string>();
    if (!name) throw error(node, "picture is not a text in quotes");
    try {
      return findFile(*name, file_.parent_path(), options);
    } catch (const SceneError& fault) {
      throw error(node, fault.what());
    }
  }

 private:
  static constexpr double kMaxTurn = 360;

  const fs::path file_;
};

}  // namespace

bool addSkyFile(const fs::path& scene_file, const LoadOptions& options, FileLoads& loads, Scene& scene) {
  const fs::path file = scene_file.parent_path() / kSkyFile;
  const auto table = readToml(file, kMaxFileBytes, options);
  if (!table) return false;
  const SkyReader sky(file);
  sky.checkKeys(*table);
  scene.environment = Environment{sky.radiance(*table), {}, sky.turn(*table)};
  const toml::node* picture = table->get("picture");
  if (!picture) return true;
  addSkyPicture(
      [fault = sky.error(*picture, "")](const std::string& what) { return SceneError(fault.what() + what); },
      sky.picture(*picture, options), loads, scene);
  return true;
}

}  // namespace saccade
