#include "app/config/config_file.h"

#include <toml++/toml.h>
#include <sstream>
#include <stdexcept>

namespace saccade {
namespace {

// A file that cannot be read has no line.
std::string originOf(const std::string& path, const toml::source_region& source) {
  return source.begin.line > 0 ? path + ":" + std::to_string(source.begin.line) : path;
}

std::string valueText(const Setting& setting, const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (!node.is_number() && !node.is_boolean()) {
    throw std::runtime_error(setting.origin + ": '" + setting.key +
                             "' is to be a text, a number, true or false");
  }
  std::ostringstream text;
  node.visit([&](const auto& value) { text << toml::node_view<const toml::node>(value); });
  return text.str();
}

}  // namespace

std::vector<Setting> readConfigFile(const std::string& path) {
  std::vector<Setting> settings;
  try {
    for (const auto& [key, node] : toml::parse_file(path)) {
      Setting setting{std::string(key), {}, originOf(path, key.source())};
      setting.value = valueText(setting, node);
      settings.push_back(std::move(setting));
    }
  } catch (const toml::parse_error& fault) {
    throw std::runtime_error(originOf(path, fault.source()) + ": " + std::string(fault.description()));
  }
  return settings;
}

std::string quoteToml(const std::string& text) {
  using Flags = toml::format_flags;
  // In the literal form there are no escapes, and one of many lines would lose a line end that it begins
  // with.
  constexpr auto kFlags =
      toml::toml_formatter::default_flags & ~Flags::allow_literal_strings & ~Flags::allow_multi_line_strings;
  const toml::value<std::string> value(text);
  std::ostringstream quoted;
  quoted << toml::toml_formatter(value, kFlags);
  return quoted.str();
}

}  // namespace saccade
