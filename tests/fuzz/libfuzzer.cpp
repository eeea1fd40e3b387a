// Called by libFuzzer.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "fuzz/draws.h"
#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  saccade::fuzzTarget().read({reinterpret_cast<const char*>(data), size});
  return 0;
}

// libFuzzer's own changes of bytes.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  const saccade::FuzzTarget& target = saccade::fuzzTarget();
  saccade::Draws draw(seed);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  if (size <= 1 || draw.oneIn(256)) {
    bytes = target.seeds[draw.below(target.seeds.size())];
  } else if (target.mutate && !draw.oneIn(8)) {
    bytes = target.mutate(bytes, draw);
  } else {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  bytes.resize(std::min(bytes.size(), max_size));
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}
