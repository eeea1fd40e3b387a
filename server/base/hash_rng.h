// Random numbers that are addressed, never drawn in order. Equal addresses give equal numbers on any thread,
// in any order.
#pragma once

#include <cstdint>

namespace saccade {

// A bijective 64-bit mixer (the finaliser of SplitMix64).
constexpr std::uint64_t mix64(std::uint64_t v) {
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
  return v ^ (v >> 31);
}

// The key of a sub-stream. It hashes hashes, so that (1, 2) and (2, 1) differ.
constexpr std::uint64_t hashKey(std::uint64_t seed, std::uint64_t address) {
  return mix64(seed ^ mix64(address + 0x9e3779b97f4a7c15ull));
}

// A bijective 32-bit mixer, of numbers or of lanes of them. It is cheap enough for one call per random
// number.
template <class Bits = std::uint32_t>
constexpr Bits mix32(Bits v) {
  v = (v ^ (v >> 16)) * 0x21f0aaadu;
  v = (v ^ (v >> 15)) * 0xd35a2d97u;
  return v ^ (v >> 15);
}

// Uniform in [0, 1). It uses the top 24 bits, so that rounding never gives 1.
constexpr float toUnit(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}
constexpr float toUnit(std::uint64_t bits) {
  return toUnit(static_cast<std::uint32_t>(bits >> 32));
}

}  // namespace saccade
