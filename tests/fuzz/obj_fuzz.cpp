#include "fuzz/fuzz_target.h"
#include "scene/files/scene_error.h"
#include "scene/mesh/mesh.h"
#include "scene/mesh/mesh_io.h"

namespace saccade {

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
       "# quads\r\nmtllib a b.mtl\no box\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\n"
       "g side\nusemtl red\ns 1\nf -4/1/1 -3/2/1 -2/2/1 -1/1/1\nf 1//1 2//1 3//1\nf 1/1 3/2 4/1\n"},
      {"f", "v ", "vt ", "vn ", "/", "//", "-1", "0", "9", "nan", "inf", "1e39", "99999999999999999999",
       "\n"},
      [](std::string_view bytes) {
        return accepts<SceneError>([&] {
          Mesh mesh = parseObj(bytes, "fuzz.obj");
          placeMesh(mesh, {}, false);
        });
      }};
  return target;
}

}  // namespace saccade
