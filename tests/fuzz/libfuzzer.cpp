#include <cstddef>
#include <cstdint>

#include "fuzz/fuzz_target.h"
#include "scene/scene_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    saccade::fuzzTarget().read({reinterpret_cast<const char*>(data), size});
  } catch (const saccade::SceneError&) {
  }
  return 0;
}
