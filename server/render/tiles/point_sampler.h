// The surfaces that pixels show at any times, without frames: primary rays in packets, each with a camera of
// its own. A point equals that of a frame at the same pixel and time but for rounding, which depends on who
// shares its packet [ours].
#pragma once

#include <span>

#include "frame/point_samples.h"
#include "render/primary/ray_block.h"
#include "render/tiles/known_rays.h"
#include "render/tiles/lamp_rays.h"
#include "render/tiles/surface_place.h"

namespace saccade {

// A scene and cameras of one lens, which PixelMoment::moment numbers.
struct PointView {
  const PosedScene& scene;
  std::span<const Camera> cameras;
  const FrameMotion* motion = nullptr;  // of the interval that the moments lie in; of a scene with bodies
};

// The frames at both ends of the interval of moments, after LampShadows::trace().
struct EndShadows {
  const SurfaceSamples &now, &before;
  const FrameRays& rays;  // at t1
  int spp;                // as of LampShadows
};

// Rays of a pixel at moments before and after a point's, and then its own: numbers of KnownRays.
struct RaysAround {
  std::uint32_t before = KnownRays::kNone, after = KnownRays::kNone, own = KnownRays::kNone;
};

// Points of PointSampler::look().
struct LookedAt {
  std::span<const PixelMoment> asked;
  std::span<const PointSample> points;
  std::span<RaysAround> rays;
};

class PointSampler {
 public:
  static constexpr std::size_t kMost = 256;  // points at once

  // Finds what at most kMost pixels show. Neighbours should follow each other, whatever their times.
  void look(const PointView& view, std::span<const PixelMoment> asked, std::span<PointSample> out);
  // Traces shadow rays at the points of the last look(), where `light` asks for some. Takes them into its
  // visibility, as far as they are trusted. A point has the rays of its pixel at the ends of the interval,
  // with the same numbers. Those that are known from the rays around it are not traced. Adds its own to
  // `known`, and returns how many it has traced.
  std::size_t traceShadows(const PointView& view, const LookedAt& at, const EndShadows& ends,
                           KnownRays& known, std::span<PlaceLight> light);

 private:
  template <Shading S>
  void lookAs(const PointView& view, std::span<const PixelMoment> asked, std::span<PointSample> out);
  template <Shading S>
  void addDeltaLight(const PointView& view, std::span<const PixelMoment> asked,
                     std::span<PointSample> out) const;
  template <Shading S>
  std::size_t traceAs(const PointView& view, const LookedAt& at, int groups, const KnownRays& known);
  RayFacet facetOf(std::size_t k, const PointSample& point) const;
  void lookPlain(const PointView& view, std::size_t first, std::span<PointSample> out);
  // f(where the light of point k starts).
  void withStart(std::size_t k, const auto& f) const;

  std::array<RayBlock, kMost / kBlockPixels> blocks_;
  std::array<SurfaceStart, kMost> others_;  // of points that are not plain
  PrimaryHit hit_;
  // Shadow rays that a point gets to each group, for that variance of visibility.
  struct RayPlan {
    float wanted = 0;
    int rays = 0;
    bool at_ends = false;  // whether the frames at both ends have decided it
  };
  static RayPlan planRays(const PixelMoment& at, const EndShadows& ends, const PlaceLight& light);

  std::array<RayPlan, kMost> plans_;
  std::array<RayFacet, kMost> facets_;  // of points that a plan gives rays
  std::array<LampRays, kMost * AnalyticLight::kMaxGroups> rays_;
  std::array<RayBits, kMost * AnalyticLight::kMaxGroups> bits_;
};

}  // namespace saccade
