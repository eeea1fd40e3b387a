#include "fuzz/fuzz_target.h"
#include "scene/files/scene_error.h"
#include "scene/model/mtl_file.h"

namespace saccade {

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {"newmtl red\nKd 0.8 0.1 0.1\nKs 0.5 0.5 0.5\nNs 98\nd 0.5\nKe 1 2 3\n",
       "# two\r\nnewmtl a b\r\nKa 1 1 1\nKd 1\nTr 0.25\nmap_Kd -s 1 1 1 -clamp on my\\wood.png\nmap_d "
       "leaf.png\n"
       "newmtl c\nillum 2\nmap_Bump -bm 0.5 b.png\n"},
      {"newmtl ", "Kd ", "Ke ", "map_Kd ", "-s ", "-", "nan", "inf", "1e39", "-1", "0", "\\", "#", "\n"},
      [](std::string_view bytes) { return accepts<SceneError>([&] { parseMtl(bytes, "fuzz.mtl"); }); }};
  return target;
}

}  // namespace saccade
