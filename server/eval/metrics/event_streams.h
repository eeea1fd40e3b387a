// Distances between two streams of events. Both cover the same pixels and the same time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "saccade/wire/event.h"

namespace saccade::eval {

// Counts per pixel: mean |n - n_ref| / mean n_ref over the pixels, ON and OFF events counted apart.
// 0 if both streams are empty, infinite if only ref is; so is the next one.
double countError(const Events& x, const Events& ref);

// ON less OFF events in voxels of a pixel and `bin_ns` > 0, bins beginning at time 0:
// sum |v - v_ref| / sum |v_ref|. Events that cancel within a voxel do not count.
double voxelError(const Events& x, const Events& ref, std::int64_t bin_ns = 5'000'000);

struct TimeError {
  double mean_ns;      // mean |dt| over the events of x, each at most the cap; NaN if x has none
  std::size_t capped;  // events with no match within the cap
};

// For each event of x, the time to the nearest event of ref in the same pixel with the same polarity, cap_ns
// at most. It misses events that only ref has: swap the streams to measure them.
TimeError nearestTimeError(const Events& x, const Events& ref, std::int64_t cap_ns = 5'000'000);

}  // namespace saccade::eval
