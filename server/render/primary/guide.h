// The surface that guides the filter: the first one that the pixel shows. Mirrors and clear glass show other
// surfaces.
#pragma once

#include "render/camera/pixel_context.h"
#include "render/surface/path_start.h"

namespace saccade {

// A guide treats mirrors as flat, and glass as if it did not bend light. The surface behind them is placed
// where it appears to be [Falcor: primary surface replacement].
struct Guide {
  Vec3 point;             // apparent position, world space
  Vec3 point_before;      // the same in the frame before, as if its mirrors stood
  Vec3 normal;            // unit shading normal at the real position
  Vec3 plane_normal;      // unit geometric normal at the apparent position
  float t;                // along the pixel's ray
  Rgb albedo;             // of the surface, and of the mirrors and panes that show it
  Rgb emission;           // of the surface, and of the mirrors and panes that show it
  ShapePoint on;          // where on its shape the surface is
  bool hit = true;        // false: nothing is hit, and only albedo and emission are valid
  bool has_base = false;  // whether it has a diffuse base
};

// `ray` is the ray of the pixel. It meets `hit` at `start`.
template <Shading S>
Guide findGuide(const PixelContext& view, const Ray& ray, const Hit& hit, const PathStart& start);

// The light of lamps and the sky that the surface at `start` mirrors into the pixel, beside the view that the
// guide follows. The coat of a plastic does so, and clear glass. The image has no noise, and moves unlike the
// surface. It goes on through the mirrors, panes and masks that it shows. 0: the surface mirrors none.
template <Shading S>
Rgb mirrorImage(const PosedScene& scene, const PathStart& start);

}  // namespace saccade
