// The materials of a Wavefront MTL file.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace saccade {

struct MtlMaterial {
  std::string name;
  Rgb diffuse{0.8f, 0.8f, 0.8f}, specular, emission;  // Kd and Ks in [0, 1], Ke
  float shininess = 0;                                // Ns, the exponent of Phong's highlight
  float opacity = 1;                                  // d, or 1 - Tr; in [0, 1]
  // Names of pictures as in the file; empty: none.
  struct Map {
    std::string file;
    long line = 0;  // of the MTL file
  };
  Map diffuse_map, opacity_map;  // map_Kd, map_d
};

struct MtlFile {
  std::vector<MtlMaterial> materials;
  std::set<std::string> unread;  // statements that would change the picture, such as map_Bump
};

// `bytes` is the content of the file at `path`. Throws SceneError with file and line: numbers that are
// missing or out of range, a statement before the first newmtl.
MtlFile parseMtl(std::string_view bytes, const std::string& path);

}  // namespace saccade
