#include "app/config/config_file.h"

#include <toml++/toml.h>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace saccade {
namespace {

// "file:line"; the file alone where it cannot be read.
std::string originOf(const std::string& path, const toml::source_region& source) {
  return source.begin.line > 0 ? path + ":" + std::to_string(source.begin.line) : path;
}

std::string valueText(const Setting& setting, const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (!node.is_number() && !node.is_boolean()) {
    throw std::runtime_error(setting.origin + ": '" + setting.key +
                             "' must be a text in quotes, a number, true or false");
  }
  std::ostringstream text;
  node.visit([&](const auto& value) { text << toml::node_view<const toml::node>(value); });
  return text.str();
}

// The message of toml++ for a value that it cannot read, most often a text without quotes.
std::string faultText(const toml::parse_error& fault) {
  const std::string text(fault.description());
  const auto says = [&](const char* words) { return text.find(words) != std::string::npos; };
  if (!says("parsing") || says("parsing string") || says("parsing key")) return text;
  return text + "; strings need quotes, such as log-level = \"debug\"";
}

}  // namespace

std::vector<Setting> readConfigFile(const std::string& path) {
  if (std::filesystem::is_directory(path)) throw std::runtime_error(path + ": is a folder, no file");
  std::vector<Setting> settings;
  try {
    for (const auto& [key, node] : toml::parse_file(path)) {
      Setting setting{std::string(key), {}, originOf(path, key.source())};
      setting.value = valueText(setting, node);
      settings.push_back(std::move(setting));
    }
  } catch (const toml::parse_error& fault) {
    throw std::runtime_error(originOf(path, fault.source()) + ": " + faultText(fault));
  }
  return settings;
}

std::string quoteToml(const std::string& text) {
  using Flags = toml::format_flags;
  // The literal form has no escapes, and the form of many lines loses a line end at the beginning.
  constexpr auto kFlags =
      toml::toml_formatter::default_flags & ~Flags::allow_literal_strings & ~Flags::allow_multi_line_strings;
  const toml::value<std::string> value(text);
  std::ostringstream quoted;
  quoted << toml::toml_formatter(value, kFlags);
  return quoted.str();
}

}  // namespace saccade
