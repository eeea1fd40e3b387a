// The surfaces that a pixel shows, and how much of it each of them covers.
#pragma once

#include <algorithm>
#include <numeric>

#include "render/primary/blocks.h"
#include "render/primary/sub_pixel.h"

namespace saccade {

// Whether two points of a pixel lie on one smooth piece of surface, whose light they share.
inline bool isOneSurface(const PrimaryHit& a, const PrimaryHit& b, float pixel) {
  constexpr float kLeastCosine = 0.9f, kMostOffset = 0.25f;  // the latter in pixels
  const Guide &g = a.guide, &h = b.guide;
  if (luminance(g.emission) != luminance(h.emission)) return false;
  if (!g.hit || !h.hit || g.has_base != h.has_base) return g.hit == h.hit && !g.hit;
  const float offset = std::abs(dot(g.plane_normal, h.point - g.point));
  return dot(g.normal, h.normal) > kLeastCosine && offset < kMostOffset * pixel * g.t;
}

// The surfaces that the sub-pixels of a pixel show: kSubPixels of them, or kEdgeSubPixels where they lie on
// several surfaces.
template <Shading S>
class SubPixels {
 public:
  SubPixels(const PixelContext& view, int x, int y) : view_(view), x_(x), y_(y) {
    const auto first = traceSubPixels<S>(view_, x_, y_, kCentreAndSubPixelOffsets);
    centre_ = first[0];
    keep(std::span(first).subspan(1));
    const auto others = std::find_if_not(hits_.begin() + 1, hits_.begin() + count_, [this](const auto& hit) {
      return isOneSurface(hits_[0], hit, pixel());
    });
    if (others != hits_.begin() + count_) keep(traceSubPixels<S>(view_, x_, y_, kEdgeSubPixelOffsets));
    for (std::uint32_t i = 0; i < count_; ++i) albedo_[i] = luminance(hits_[i].guide.albedo) / count_;
  }

  const PrimaryHit& centre() const { return centre_; }  // what the centre of the pixel shows
  float albedo() const { return std::accumulate(albedo_.begin(), albedo_.begin() + count_, 0.f); }
  float emission() const {
    float E = 0;
    for (std::uint32_t i = 0; i < count_; ++i) E += luminance(hits_[i].guide.emission) / count_;
    return E;
  }
  // Calls f(its brightest sub-pixel, the albedo of all that show it) for the surfaces that they show,
  // kSubPixels at most. The last one takes all further ones.
  void forEachSurface(const auto& f) const {
    std::array<bool, kEdgeSubPixels> told{};
    std::uint32_t surfaces = 0;
    for (std::uint32_t i = 0; i < count_; ++i) {
      if (told[i]) continue;
      const bool last = ++surfaces == kSubPixels;
      std::uint32_t shown = i;
      float A = 0;
      for (std::uint32_t j = i; j < count_; ++j) {
        if (told[j] || (j > i && !last && !isOneSurface(hits_[i], hits_[j], pixel()))) continue;
        told[j] = true;
        A += albedo_[j];
        if (albedo_[j] > albedo_[shown]) shown = j;
      }
      f(hits_[shown], A);
    }
  }

 private:
  void keep(std::span<const PrimaryHit> hits) {
    count_ = static_cast<std::uint32_t>(hits.size());
    std::ranges::copy(hits, hits_.begin());
  }

  float pixel() const { return view_.now.camera.pixelAt(hits_[0].direction); }

  const PixelContext& view_;
  int x_, y_;
  std::uint32_t count_ = 0;
  PrimaryHit centre_;
  std::array<PrimaryHit, kEdgeSubPixels> hits_;
  std::array<float, kEdgeSubPixels> albedo_{};
};

}  // namespace saccade
