// A set of lanes.
#pragma once

#include <bit>
#include <cstdint>

namespace saccade {

// All members are inlined, also where kernels are compiled for a wider instruction set.
struct LaneSet {
  std::uint32_t bits = 0;  // lane 0 is the lowest

  // The lanes below `count`, which is less than 32.
  [[gnu::always_inline]] static constexpr LaneSet first(int count) { return {(1u << count) - 1}; }

  [[gnu::always_inline]] constexpr bool any() const { return bits != 0; }
  [[gnu::always_inline]] constexpr bool has(int lane) const { return bits >> lane & 1; }
  [[gnu::always_inline]] constexpr int size() const { return std::popcount(bits); }
  // The lanes from `lane` on, as lanes from 0 on.
  [[gnu::always_inline]] constexpr LaneSet from(int lane) const { return {bits >> lane}; }
  // Adds a lane where a condition holds.
  [[gnu::always_inline]] constexpr void add(int lane, bool where = true) {
    bits |= std::uint32_t(where) << lane;
  }
  [[gnu::always_inline]] constexpr void remove(int lane) { bits &= ~(1u << lane); }

  [[gnu::always_inline]] friend constexpr LaneSet operator&(LaneSet a, LaneSet b) {
    return {a.bits & b.bits};
  }
  [[gnu::always_inline]] friend constexpr LaneSet operator|(LaneSet a, LaneSet b) {
    return {a.bits | b.bits};
  }
  // Of a without b.
  [[gnu::always_inline]] friend constexpr LaneSet operator-(LaneSet a, LaneSet b) {
    return {a.bits & ~b.bits};
  }
  [[gnu::always_inline]] constexpr LaneSet& operator&=(LaneSet b) { return bits &= b.bits, *this; }
  [[gnu::always_inline]] constexpr LaneSet& operator|=(LaneSet b) { return bits |= b.bits, *this; }
  friend constexpr bool operator==(LaneSet, LaneSet) = default;
};

// Calls f(lane) for each lane, from the first to the last.
template <class F>
[[gnu::always_inline]] inline void forEachLane(LaneSet lanes, const F& f) {
  for (; lanes.any(); lanes.bits &= lanes.bits - 1) f(std::countr_zero(lanes.bits));
}

}  // namespace saccade
