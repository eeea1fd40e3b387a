// Reads what numpy.save() writes for little-endian float32 in C order.
#pragma once

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace saccade::test {

// All values; `count` is how many there must be.
inline std::vector<float> readNpy(const std::string& path, std::size_t count) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  if (bytes.substr(1, 5) != "NUMPY" || bytes.find("'<f4'") == bytes.npos || bytes.size() < 4 * count) {
    throw std::runtime_error(path + " is not a .npy file of that many float32");
  }
  std::vector<float> values(count);
  std::copy_n(bytes.end() - static_cast<std::ptrdiff_t>(4 * count), 4 * count,
              reinterpret_cast<char*>(values.data()));
  return values;
}

}  // namespace saccade::test
