#include <algorithm>
#include <cstdint>
#include <iterator>

#include "fuzz/fuzz_target.h"
#include "scene/files/scene_error.h"
#include "scene/mesh/mesh.h"
#include "scene/mesh/mesh_io.h"

namespace saccade {
namespace {

std::string header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment a triangle\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "property float nx\nproperty float ny\nproperty float nz\nproperty double s\nproperty short t\n"
         "element face 1\nproperty uchar flags\nproperty list uchar int vertex_indices\nelement other 1\n"
         "property list ushort float values\nend_header\n";
}

template <class T>
void append(std::string& bytes, T value, bool big) {
  char raw[sizeof value];
  std::copy_n(reinterpret_cast<const char*>(&value), sizeof value, raw);
  if (big) std::reverse(std::begin(raw), std::end(raw));
  bytes.append(raw, sizeof value);
}

std::string binary(bool big) {
  std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian");
  for (int i = 0; i < 3; ++i) {
    for (const float v : {i == 1 ? 1.f : 0.f, i == 2 ? 1.f : 0.f, 0.f, 0.f, 0.f, 1.f}) append(bytes, v, big);
    append(bytes, 0.5, big);
    append(bytes, std::int16_t{1}, big);
  }
  bytes += "\1\3";
  for (std::int32_t i = 0; i < 3; ++i) append(bytes, i, big);
  append(bytes, std::uint16_t{1}, big);
  append(bytes, 2.f, big);
  return bytes;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {header("ascii") + "0 0 0 0 0 1 0.5 1\n1 0 0 0 0 1 0 1\n0 1 0 0 0 1 0 0\n7 3 0 1 2\n2 0.5 0.25\n",
       binary(false), binary(true)},
      {"list ", "element ", "property ", "float", "uchar", "double", "-1", "0", "1000000000",
       "9000000000000000000", "nan", "\n", "end_header\n", "\xff\xff\xff\xff"},
      [](std::string_view bytes) {
        return accepts<SceneError>([&] {
          Mesh mesh = parsePly(bytes, "fuzz.ply");
          placeMesh(mesh, {}, false);
        });
      }};
  return target;
}

}  // namespace saccade
