#include "scene/gltf/json_node.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace saccade {
namespace {

using nlohmann::json;

// Counts what is parsed, so that a small file cannot take much memory.
class Bounds {
 public:
  explicit Bounds(const std::string& file) : file_(file) {}

  bool operator()(int depth, json::parse_event_t event, json&) {
    if (depth > kMaxJsonDepth)
      throw SceneError(file_ + ": the JSON is nested more than " + std::to_string(kMaxJsonDepth) + " deep");
    const bool ends = event == json::parse_event_t::object_end || event == json::parse_event_t::array_end;
    if (!ends && ++values_ > kMaxJsonValues)
      throw SceneError(file_ + ": the JSON has more than " + std::to_string(kMaxJsonValues) + " values");
    return true;
  }

 private:
  const std::string& file_;
  std::size_t values_ = 0;
};

}  // namespace

json parseJson(std::string_view text, const std::string& file) {
  try {
    return json::parse(text.begin(), text.end(), Bounds(file));
  } catch (const json::exception& fault) {  // its text names line and column
    throw SceneError(file + ": " + fault.what());
  }
}

SceneError JsonNode::error(const std::string& what) const {
  return SceneError(place_ + ": " + what);
}

JsonNode JsonNode::child(const json& value, const std::string& step) const {
  return {value, place_ + step};
}

const json* JsonNode::member(const char* key) const {
  if (!value_->is_object()) throw error("is not an object");
  const auto found = value_->find(key);
  return found == value_->end() ? nullptr : &*found;
}

std::optional<JsonNode> JsonNode::find(const char* key) const {
  const json* found = member(key);
  if (!found) return {};
  return child(*found, std::string(".") + key);
}

JsonNode JsonNode::at(const char* key) const {
  const auto found = find(key);
  if (!found) throw error(std::string("has no ") + key);
  return *found;
}

JsonNode JsonNode::object(const char* key) const {
  static const json kEmpty = json::object();
  const auto found = find(key);
  return found ? *found : child(kEmpty, std::string(".") + key);
}

std::vector<JsonNode> JsonNode::list(const char* key) const {
  std::vector<JsonNode> nodes;
  const json* found = member(key);
  if (!found) return nodes;
  if (!found->is_array()) throw error(std::string(key) + " is not an array");
  for (const json& value : *found)
    nodes.push_back(child(value, std::string(".") + key + "[" + std::to_string(nodes.size()) + "]"));
  return nodes;
}

std::size_t JsonNode::count(const char* key) const {
  const json* found = member(key);
  if (found && !found->is_array()) throw error(std::string(key) + " is not an array");
  return found ? found->size() : 0;
}

JsonNode JsonNode::entry(const char* key, std::size_t i) const {
  const json* found = member(key);
  const std::string step = std::string(key) + "[" + std::to_string(i) + "]";
  if (!found || !found->is_array() || i >= found->size()) throw error("has no " + step);
  return child((*found)[i], "." + step);
}

std::vector<std::string> JsonNode::keys() const {
  if (!value_->is_object()) throw error("is not an object");
  std::vector<std::string> keys;
  for (auto entry = value_->begin(); entry != value_->end(); ++entry) keys.push_back(entry.key());
  return keys;
}

double JsonNode::number() const {
  if (!value_->is_number()) throw error("is not a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) throw error("is not finite");
  return number;
}

// Writers also give whole numbers as 3.0.
std::size_t JsonNode::size() const {
  constexpr double kMost = 0x1p53;
  const double given = number();
  if (!(given >= 0 && given <= kMost) || given != std::floor(given))
    throw error("is not a whole number of at least 0");
  return static_cast<std::size_t>(given);
}

std::size_t JsonNode::index(std::size_t count) const {
  const std::size_t given = size();
  if (given >= count) throw error("is " + std::to_string(given) + ", and there are " + std::to_string(count));
  return given;
}

std::string JsonNode::text() const {
  if (!value_->is_string()) throw error("is not a text");
  return value_->get<std::string>();
}

std::vector<double> JsonNode::numbers(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count)
    throw error("is not an array of " + std::to_string(count) + " numbers");
  std::vector<double> all;
  for (const json& value : *value_) all.push_back(child(value, "[]").number());
  return all;
}

double JsonNode::number(const char* key, double fallback) const {
  const auto given = find(key);
  return given ? given->number() : fallback;
}

std::size_t JsonNode::size(const char* key, std::size_t fallback) const {
  const auto given = find(key);
  return given ? given->size() : fallback;
}

std::optional<std::size_t> JsonNode::index(const char* key, std::size_t count) const {
  const auto given = find(key);
  if (!given) return {};
  return given->index(count);
}

std::string JsonNode::text(const char* key, const std::string& fallback) const {
  const auto given = find(key);
  return given ? given->text() : fallback;
}

bool JsonNode::flag(const char* key, bool fallback) const {
  const json* given = member(key);
  if (!given) return fallback;
  if (!given->is_boolean()) throw error(std::string(key) + " is not true or false");
  return given->get<bool>();
}

std::optional<JsonNode> JsonNode::extension(const char* name) const {
  const auto extensions = find("extensions");
  return extensions ? extensions->find(name) : std::nullopt;
}

}  // namespace saccade
