// A value of a JSON file, with its place in the file for messages.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/files/scene_error.h"

namespace saccade {

// Values, arrays within arrays, and so on: limits of a file.
inline constexpr std::size_t kMaxJsonValues = 8'000'000;
inline constexpr int kMaxJsonDepth = 64;

// Throws SceneError with file and line where the text is not JSON, or beyond the limits.
nlohmann::json parseJson(std::string_view text, const std::string& file);

// All members throw SceneError where the value is not of the type asked for. Numbers are finite.
class JsonNode {
 public:
  // `place`: of the file, and of the value in it, such as "nodes[3]". The value must outlive the node.
  JsonNode(const nlohmann::json& value, std::string place) : value_(&value), place_(std::move(place)) {}

  std::optional<JsonNode> find(const char* key) const;   // none: absent
  JsonNode at(const char* key) const;                    // throws where absent
  JsonNode object(const char* key) const;                // an empty one where absent
  std::vector<JsonNode> list(const char* key) const;     // of an array; empty where absent
  std::size_t count(const char* key) const;              // of entries of an array; 0 where absent
  JsonNode entry(const char* key, std::size_t i) const;  // of an array that has it
  std::vector<std::string> keys() const;                 // of an object

  double number() const;
  std::size_t size() const;                    // a whole number, at least 0
  std::size_t index(std::size_t count) const;  // below `count`
  std::string text() const;
  std::vector<double> numbers(std::size_t count) const;  // an array of so many

  // A property that may be absent.
  double number(const char* key, double fallback) const;
  std::size_t size(const char* key, std::size_t fallback) const;
  std::optional<std::size_t> index(const char* key, std::size_t count) const;
  std::string text(const char* key, const std::string& fallback = {}) const;
  bool flag(const char* key, bool fallback) const;
  template <std::size_t N>
  std::array<double, N> numbers(const char* key, std::array<double, N> fallback) const {
    const auto given = find(key);
    if (!given) return fallback;
    const std::vector<double> all = given->numbers(N);
    for (std::size_t i = 0; i < N; ++i) fallback[i] = all[i];
    return fallback;
  }
  std::optional<JsonNode> extension(const char* name) const;

  const std::string& place() const { return place_; }
  SceneError error(const std::string& what) const;

 private:
  const nlohmann::json* member(const char* key) const;
  JsonNode child(const nlohmann::json& value, const std::string& step) const;

  const nlohmann::json* value_;
  std::string place_;
};

}  // namespace saccade
