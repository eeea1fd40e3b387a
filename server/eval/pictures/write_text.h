// Text to a file.
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

namespace saccade::eval {

// Throws std::runtime_error.
inline void writeText(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace saccade::eval
