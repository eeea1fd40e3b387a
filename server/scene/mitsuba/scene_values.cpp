#include "scene/mitsuba/scene_values.h"

#include <filesystem>
#include <sstream>

#include "base/text_cut.h"
#include "scene/files/scene_error.h"
#include "scene/files/toml_file.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxFileBytes = 1 << 20;

std::string textOf(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  std::ostringstream text;
  node.visit([&](const auto& value) { text << toml::node_view<const toml::node>(value); });
  return text.str();
}

}  // namespace

SceneValues readSceneValues(const std::string& scene_file, const LoadOptions& options) {
  const auto file = std::filesystem::path(scene_file).parent_path() / kValuesFile;
  SceneValues values{file.string(), {}};
  const auto table = readToml(file, kMaxFileBytes, options);
  if (!table) return values;
  for (const auto& [key, node] : *table) {
    const auto line = static_cast<long>(node.source().begin.line);
    if (!node.is_string() && !node.is_number() && !node.is_boolean())
      throw SceneError(
          values.file, line,
          "'" + cutText(key.str(), kMaxEcho) + "' must be a text in quotes, a number, true or false");
    values.by_name[std::string(key.str())] = {textOf(node), line};
  }
  return values;
}

}  // namespace saccade
