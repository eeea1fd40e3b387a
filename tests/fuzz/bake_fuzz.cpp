// The state in the file of a bake. Its digest finds damage, but anybody can compute one.
#include <stdexcept>

#include "feed/baker.h"
#include "feed/room.h"
#include "fuzz/fuzz_target.h"

namespace saccade {
namespace {

struct Tiny {
  const std::shared_ptr<const RenderScene> scene = test::room();
  BakePlan plan{.poses = {Pose{{0, 0, -0.9}, {}}}, .camera = pinhole(80, 3, 2), .memory = 1};
  TilePool pool{1};
};

Tiny& tiny() {
  static Tiny t;
  return t;
}

std::string stateAfter(int passes) {
  Baker baker(tiny().scene, tiny().plan);
  for (int i = 0; i < passes; ++i) baker.pass(tiny().pool);
  return baker.state();
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {stateAfter(0), stateAfter(1), stateAfter(3)},
      {std::string(8, '\xff'), std::string(8, '\0'), std::string("\0\0\xc0\x7f", 4),
       std::string("\0\0\x80\x7f", 4), std::string("\1\0\0\0\0\0\0\0", 8)},
      [](std::string_view bytes) {
        return accepts<std::runtime_error>([&] {
          Baker baker(tiny().scene, tiny().plan);
          baker.restore(bytes);
          if (!baker.isDone()) baker.pass(tiny().pool);
          baker.light(tiny().pool);
        });
      },
      nullptr,
      2000};
  return target;
}

}  // namespace saccade
