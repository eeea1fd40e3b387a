// Files of other people, which stand beside the project and are never copied into it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace saccade::test {

inline std::string outsideFolder(const char* variable, const char* name) {
  const char* set = std::getenv(variable);
  return set ? set : std::string(SACCADE_SOURCE_DIR) + "/../shared/" + name;
}
inline std::string realScene(const std::string& path) {
  return outsideFolder("SACCADE_REAL_SCENES", "scenes") + "/" + path;
}
inline std::string referenceRender(const std::string& path) {
  return outsideFolder("SACCADE_REFERENCE_RENDERS", "reference-renders") + "/" + path;
}

}  // namespace saccade::test

// Skips the test, naming the file, where it is absent.
#define SACCADE_NEEDS(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << (path)
