// Whole files, and what is compressed in them.
#include "fuzz/fuzz_target.h"
#include "scene/files/scene_error.h"
#include "scene/mesh/mesh.h"
#include "scene/mesh/mesh_io.h"
#include "scene/serialized_files.h"

namespace saccade {
namespace {

bool acceptsFile(std::string_view bytes) {
  return accepts<SceneError>([&] {
    Mesh mesh = parseSerialized(bytes, "fuzz.serialized", 0);
    placeMesh(mesh, {}, false);
  });
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  const test::SerializedLayout floats{4}, doubles{3, true};
  static const FuzzTarget target{
      {test::serializedFile(4, {test::triangleData(floats, 1), test::triangleData(floats, 2)}),
       test::serializedFile(3, {test::triangleData(doubles, 1)}), test::triangleData(floats, 1),
       test::triangleData(doubles, 1)},
      {std::string("\x1c\x04", 2), std::string("\3\0", 2), std::string("\4\0", 2), "\x78\x9c",
       "\xff\xff\xff\xff", std::string("\1\0\0\0", 4), std::string("\0\0\x80\x7f", 4)},
      [](std::string_view bytes) {
        const std::string data(bytes);
        const bool whole = acceptsFile(bytes), v3 = acceptsFile(test::serializedFile(3, {data}));
        return acceptsFile(test::serializedFile(4, {data})) || v3 || whole;
      },
      nullptr,
      20000};
  return target;
}

}  // namespace saccade
