// Values that a file beside a Mitsuba scene file gives its $names, as `-D NAME=VALUE` does in Mitsuba.
#pragma once

#include <map>
#include <string>

#include "scene/files/load_options.h"

namespace saccade {

inline constexpr const char* kValuesFile = "values.toml";

struct SceneValues {
  struct Value {
    std::string text;
    long line;  // of the file, from 1
  };
  std::string file;
  std::map<std::string, Value> by_name;
};

// Reads `NAME = VALUE` lines of values.toml in the folder of `scene_file`: texts, numbers, true and false.
// Without that file there are none. Throws SceneError with file and line.
SceneValues readSceneValues(const std::string& scene_file, const LoadOptions& options);

}  // namespace saccade
