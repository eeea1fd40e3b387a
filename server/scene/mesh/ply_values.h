// The data of a PLY file, value by value.
#pragma once

#include <string>
#include <string_view>

#include "scene/mesh/ply_header.h"

namespace saccade {

// Every value takes at least a byte, so that a huge count ends at the end of the file. All throw SceneError.
class PlyValues {
 public:
  PlyValues(std::string_view data, PlyFormat format, const std::string& path)
      : rest_(data), format_(format), path_(path) {}

  double readNumber(PlyType type);    // ascii: finite
  long long readCount(PlyType type);  // the length of a list
  void ignore(const PlyProperty& property);

 private:
  double readBinary(PlyType type);
  [[noreturn]] void fail(const std::string& what) const;

  std::string_view rest_;
  PlyFormat format_;
  const std::string& path_;
};

}  // namespace saccade
