// The surfaces that a pixel shows, and how much of it each of them covers.
#pragma once

#include <algorithm>
#include <span>

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

// The surfaces that the sub-pixels of a pixel show: kSubPixels of them at first. A mask and what is behind it
// share a sub-pixel by the mask's opacity.
template <Shading S>
class SubPixels {
 public:
  SubPixels(const PixelContext& view, int x, int y) : view_(view), x_(x), y_(y) {
    look(kCentreAndSubPixelOffsets);
    const auto largest = std::ranges::max_element(
        shown(), {}, [](const Layer& layer) { return layer.point == 0 ? layer.share : 0; });
    centre_ = largest->hit;
    while (layers_[first_].point == 0) ++first_;
    for (Layer& layer : shown()) layer.share /= kSubPixels, --layer.point;
  }
  // Looks at kEdgeSubPixels instead, where they lie on several surfaces.
  void lookAtEdges() {
    const Layer& one = layers_[first_];
    if (std::ranges::all_of(shown(),
                            [&](const Layer& layer) { return isOneSurface(one.hit, layer.hit, pixel()); }))
      return;
    look(kEdgeSubPixelOffsets);
    for (Layer& layer : shown()) layer.share /= kEdgeSubPixels;
  }

  const PrimaryHit& centre() const { return centre_; }  // what the centre of the pixel shows most
  float albedo() const {
    float A = 0;
    for (const Layer& layer : shown()) A += albedoOf(layer);
    return A;
  }
  float emission() const {
    float E = 0;
    for (const Layer& layer : shown()) E += luminance(layer.hit.guide.emission) * layer.share;
    return E;
  }
  // See mirrorImage().
  float image() const {
    float E = 0;
    for (const Layer& layer : shown())
      if (layer.hit.valid) E += luminance(mirrorImage<S>(view_.now.scene, layer.hit.start)) * layer.share;
    return E;
  }
  // A layer of a sub-pixel, chosen by its share of the albedo with u in [0, 1). nullptr: all of them are
  // darker than `least`.
  const PrimaryHit* choose(std::size_t sub_pixel, float least, float u) const {
    const auto all = shown();
    const auto first = std::ranges::lower_bound(all, sub_pixel, {}, &Layer::point);
    const auto end = std::ranges::upper_bound(all, sub_pixel, {}, &Layer::point);
    const std::span<const Layer> layers(first, end);
    float left = 0;
    for (const Layer& layer : layers) left += albedoOf(layer);
    if (left * kSubPixels < least) return nullptr;
    left *= u;
    const PrimaryHit* chosen = nullptr;
    for (const Layer& layer : layers) {
      if (albedoOf(layer) <= 0) continue;
      chosen = &layer.hit;
      if ((left -= albedoOf(layer)) < 0) break;
    }
    return chosen;
  }
  // Calls f(the layer of most albedo, the albedo of all that show it) for the surfaces that the sub-pixels
  // show, kSubPixels at most. The last one takes all further ones.
  void forEachSurface(const auto& f) const {
    std::array<bool, kMostHits> told{};
    std::uint32_t surfaces = 0;
    for (std::size_t i = first_; i < end_; ++i) {
      if (told[i]) continue;
      const bool last = ++surfaces == kSubPixels;
      std::size_t most = i;
      float A = 0;
      for (std::size_t j = i; j < end_; ++j) {
        if (told[j] || (j > i && !last && !isOneSurface(layers_[i].hit, layers_[j].hit, pixel()))) continue;
        told[j] = true;
        A += albedoOf(layers_[j]);
        if (albedoOf(layers_[j]) > albedoOf(layers_[most])) most = j;
      }
      f(layers_[most].hit, A);
    }
  }

 private:
  static constexpr std::size_t kMostHits = (S.extras ? 2 : 1) * kEdgeSubPixels;

  template <std::size_t kCount>
  void look(const std::array<Vec2, kCount>& offsets) {
    first_ = 0, end_ = traceLayers<S>(view_, subPixelPoints(x_, y_, offsets), layers_);
  }
  std::span<Layer> shown() { return std::span(layers_).subspan(first_, end_ - first_); }
  std::span<const Layer> shown() const { return std::span(layers_).subspan(first_, end_ - first_); }

  static float albedoOf(const Layer& layer) { return luminance(layer.hit.guide.albedo) * layer.share; }
  float pixel() const { return view_.now.camera.pixelAt(layers_[first_].hit.direction); }

  const PixelContext& view_;
  int x_, y_;
  std::size_t first_ = 0, end_ = 0;  // of the layers that count
  PrimaryHit centre_;
  std::array<Layer, kMostHits> layers_;
};

}  // namespace saccade
