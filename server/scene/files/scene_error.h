// The error of a faulty scene or trajectory file, with the place in it.
#pragma once

#include <stdexcept>
#include <string>

namespace saccade {

struct SceneError : std::runtime_error {
  explicit SceneError(const std::string& what) : std::runtime_error(what) {}
  SceneError(const std::string& file, long line, const std::string& what)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + what) {}
};

}  // namespace saccade
