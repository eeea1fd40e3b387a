// The header of a PLY file: the properties of its elements.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace saccade {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

// A number type: its size in bytes, and what the bytes mean.
struct PlyType {
  int bytes;
  bool is_float, is_signed;
};

struct PlyProperty {
  std::string name;
  bool is_list;
  PlyType count_type, type;  // count_type: of lists only
};

struct PlyElement {
  std::string name;
  long long count;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format;
  std::vector<PlyElement> elements;
};

// Takes the header off `bytes`, so that the data remains. Throws SceneError that names the line.
PlyHeader takePlyHeader(std::string_view& bytes, const std::string& path);

}  // namespace saccade
