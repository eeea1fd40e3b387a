#include "farm/recipe/toml_value.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "farm/recipe/recipe_fault.h"

namespace saccade::farm {
namespace {

std::string shown(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << toml::node_view<const toml::node>(value); });
  return text.str().substr(0, 60);
}

// The text of a text or a number; nothing for other types.
std::optional<std::string> plainText(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
  if (const auto number = node.value_exact<double>()) return exactText(*number);
  return std::nullopt;
}

}  // namespace

void TomlPlace::fail(const std::string& message) const {
  throw RecipeFault(file, line, (key.empty() ? "" : key + ": ") + message);
}

TomlPlace TomlPlace::below(const std::string& name, const toml::node& node) const {
  return {file, key.empty() ? name : key + "." + name, lineOf(node) > 0 ? lineOf(node) : line};
}

std::vector<std::pair<std::string, const toml::node*>> inOrder(const toml::table& table) {
  std::vector<std::pair<std::string, const toml::node*>> entries;
  for (const auto& [key, value] : table) entries.emplace_back(std::string(key), &value);
  const auto place = [](const auto& entry) {
    const toml::source_position& begin = entry.second->source().begin;
    return std::pair(begin.line, begin.column);
  };
  std::ranges::sort(entries, {}, place);
  return entries;
}

int lineOf(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

std::string textOf(const toml::node& node, const TomlPlace& place) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  place.fail(shown(node) + " is not a text in quotes");
}

std::uint64_t wholeOf(const toml::node& node, std::uint64_t min, std::uint64_t max, const TomlPlace& place) {
  const auto number = node.value_exact<std::int64_t>();
  if (number && *number >= 0 && static_cast<std::uint64_t>(*number) >= min &&
      static_cast<std::uint64_t>(*number) <= max)
    return static_cast<std::uint64_t>(*number);
  place.fail(shown(node) + " is not a whole number from " + std::to_string(min) + " to " +
             std::to_string(max));
}

double numberOf(const toml::node& node, const TomlPlace& place) {
  const auto number = node.is_number() ? node.value<double>() : std::nullopt;
  if (number && std::isfinite(*number)) return *number;
  place.fail(shown(node) + " is not a finite number");
}

Value valueOf(const toml::node& node, const TomlPlace& place) {
  if (const auto text = plainText(node)) return {true, {*text}};
  if (const auto flag = node.value_exact<bool>()) return {*flag, {}};
  const toml::array* list = node.as_array();
  if (!list)
    place.fail(shown(node) + " is not a text, a number, true, false or an array of texts and numbers");
  Value value;
  for (const toml::node& element : *list) {
    const auto text = plainText(element);
    if (!text) place.fail("the array holds " + shown(element) + ", which is not a text or a number");
    value.texts.push_back(*text);
  }
  value.present = !value.texts.empty();
  return value;
}

}  // namespace saccade::farm
