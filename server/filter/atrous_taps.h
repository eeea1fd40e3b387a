// The taps of the a-trous filter, compiled for one width of lanes. A result does not depend on the width.
#pragma once

#include "filter/atrous_chunk.h"

namespace saccade::detail {

// h(q) of each AtrousKernel: separable, by distance, 1 at the centre.
constexpr float kKernels[2][3] = {{1, 2.f / 3, 1.f / 6}, {1, 0.27901f / 0.44198f, 0}};

struct Tap {
  std::ptrdiff_t o;  // from the centre
  float h, inv_distance;
};
// All but the centre.
struct Taps {
  const Tap* begin() const { return taps.data(); }
  const Tap* end() const { return taps.data() + count; }
  std::array<Tap, 24> taps;
  std::size_t count = 0;
};

template <int W>
[[gnu::always_inline]] inline Floats<W> loadAnywhere(const float* p) {
  return Floats<W>(p, stdx::element_aligned);
}

// Of the pixels of some lanes: their features in one frame.
template <int W>
struct Centre {
  using F = Floats<W>;
  [[gnu::always_inline]] Centre(const AtrousFeatures& f, int x, float s_n)
      : at(f),
        x(x),
        s_n(s_n),
        nx(loadAnywhere<W>(f.nx + x)),
        ny(loadAnywhere<W>(f.ny + x)),
        nz(loadAnywhere<W>(f.nz + x)),
        z(loadAnywhere<W>(f.z + x)),
        r_z(load<W>(f.r_z + x)) {}

  // e_z + e_n between each pixel and its neighbour at the tap.
  [[gnu::always_inline]] F exponent(const Tap& tap) const {
    const std::ptrdiff_t q = x + tap.o;
    const F cosine =
        nx * loadAnywhere<W>(at.nx + q) + ny * loadAnywhere<W>(at.ny + q) + nz * loadAnywhere<W>(at.nz + q);
    return s_n * (1.f - cosine) + abs(z - loadAnywhere<W>(at.z + q)) * (r_z * tap.inv_distance);
  }

  const AtrousFeatures& at;
  int x;
  float s_n;  // sigma_n log2 e
  F nx, ny, nz, z, r_z;
};

// The sums of one signal over the taps. The centre counts fully.
template <int W>
struct Sums {
  using F = Floats<W>;
  [[gnu::always_inline]] Sums(const AtrousChannel& s, int x)
      : at(s),
        x(x),
        centre(loadAnywhere<W>(s.c + x)),
        r_l(load<W>(s.r_l + x)),
        w(1.f),
        c(centre),
        v(loadAnywhere<W>(s.v + x)) {}

  [[gnu::always_inline]] void add(const Tap& tap, const F& exponent) {
    const F c_q = loadAnywhere<W>(at.c + x + tap.o), v_q = loadAnywhere<W>(at.v + x + tap.o);
    const F weight = tap.h * fastExp2(F(-(exponent + abs(centre - c_q) * r_l)));
    w += weight;
    c += weight * c_q;
    v += weight * weight * v_q;
  }
  [[gnu::always_inline]] void store(AtrousChannel& out) const {
    const F inv = 1.f / w;
    saccade::store(F(c * inv), out.filtered + x);
    saccade::store(F(v * inv * inv), out.filtered_v + x);
  }

  const AtrousChannel& at;
  int x;
  F centre, r_l, w, c, v;
};

template <int W, AtrousSignal What>
void filterChunk(const AtrousChunk& chunk, const Taps& taps) {
  using enum AtrousSignal;
  constexpr bool kHeedsPrev = What == kBothHeedingPrev || What == kDifferenceHeedingPrev;
  constexpr bool kHasPrimal = What != kDifference && What != kDifferenceHeedingPrev;
  constexpr bool kHasDifference = What != kPrimal;
  const float s_n = chunk.sigma_n * kLog2E;
  for (int x = 0; x < chunk.n; x += W) {
    const Centre<W> cur(chunk.cur, x, s_n), prev(chunk.prev, x, s_n);
    Sums<W> primal(chunk.primal, x), difference(chunk.difference, x);
    for (const Tap& tap : taps) {
      const Floats<W> e = cur.exponent(tap);
      if constexpr (kHasPrimal) primal.add(tap, e);
      if constexpr (kHasDifference) difference.add(tap, kHeedsPrev ? Floats<W>(e + prev.exponent(tap)) : e);
    }
    if constexpr (kHasPrimal) primal.store(chunk.primal);
    if constexpr (kHasDifference) difference.store(chunk.difference);
  }
}

template <int W>
void filterChunk(AtrousSignal signal, const AtrousChunk& chunk) {
  Taps taps;
  const float(&kernel)[3] = kKernels[static_cast<int>(chunk.kernel)];
  const int radius = chunk.kernel == AtrousKernel::k5x5 ? 2 : 1;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const float distance = std::sqrt(static_cast<float>(dx * dx + dy * dy));
      taps.taps[taps.count++] = {chunk.step * (dy * chunk.stride + dx),
                                 kernel[dx < 0 ? -dx : dx] * kernel[dy < 0 ? -dy : dy],
                                 1 / (static_cast<float>(chunk.step) * distance)};
    }
  }
  using enum AtrousSignal;
  if (signal == kPrimal) return filterChunk<W, kPrimal>(chunk, taps);
  if (signal == kDifference) return filterChunk<W, kDifference>(chunk, taps);
  if (signal == kDifferenceHeedingPrev) return filterChunk<W, kDifferenceHeedingPrev>(chunk, taps);
  if (signal == kBoth) return filterChunk<W, kBoth>(chunk, taps);
  filterChunk<W, kBothHeedingPrev>(chunk, taps);
}

}  // namespace saccade::detail
