// The surface that guides the filter: the first that a pixel shows, in mirrors and through clear glass.
#pragma once

#include "render/path_tracer.h"

namespace saccade {

// Mirrors are flat and glass does not bend, as far as guides go: what they show is taken to be where it seems
// to be [Falcor: primary surface replacement].
struct Guide {
  Vec3 point;         // where it seems to be, world space
  Vec3 normal;        // unit shading normal where it is
  Vec3 plane_normal;  // unit geometric normal where it seems to be
  float t;            // along the pixel's ray
  Rgb albedo;         // fraction of light that comes from it, or off what it is seen in, into the view
  Rgb emission;       // from it, and from what it is seen in, into the view
  bool hit = true;    // false: endless; all but albedo and emission mean nothing
};

// `ray` is the pixel's, and `hit` what it meets at `start`.
template <Shading S>
Guide findGuide(const RenderScene& scene, const EmitterStrengths& strengths, const Ray& ray, const Hit& hit,
                const PathStart& start);

}  // namespace saccade
