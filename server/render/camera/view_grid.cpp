#include "render/camera/view_grid.h"

#include <limits>

namespace saccade {
namespace {

// The centre of cell i of `count` cells that cover `size` pixels. Pixel centres are whole numbers.
float cellCentre(int i, int count, int size) {
  return (static_cast<float>(i) + 0.5f) * static_cast<float>(size) / static_cast<float>(count) - 0.5f;
}

// Calls f(hit, direction) for each hit of viewHits(). `direction` is that of the ray, 1 along the viewing
// axis.
template <class F>
void forEachHit(const RenderScene& scene, const Camera& camera, const ViewGrid& grid, const F& f) {
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const float x = cellCentre(column, grid.columns, grid.width);
      const float y = cellCentre(row, grid.rows, grid.height);
      const Vec3 d = camera.direction(x, y);
      const Hit hit = scene.geometry().intersect({camera.origin, d, std::numeric_limits<float>::infinity()});
      if (hit.valid) f(ViewHit{x, y, hit.t}, d);
    }
  }
}

}  // namespace

std::vector<ViewHit> viewHits(const RenderScene& scene, const Camera& camera, const ViewGrid& grid) {
  std::vector<ViewHit> hits;
  forEachHit(scene, camera, grid, [&](ViewHit hit, Vec3) { hits.push_back(hit); });
  return hits;
}

std::vector<Vec3d> probePoints(const RenderScene& scene, const Pose& T_world_camera, const Lens& lens) {
  constexpr int kWidth = 64, kHeight = 48;
  const CameraModel model = lens.isDistorted() ? lens.camera() : resized(lens.camera(), kWidth, kHeight);
  const Pose pose = scene.inScene(T_world_camera);
  const Camera camera = lens.isDistorted() ? Camera(pose, lens) : Camera(pose, model);
  const Vec3d origin = scene.description().origin;
  std::vector<Vec3d> points;
  forEachHit(scene, camera, {model.width, model.height, kWidth, kHeight}, [&](ViewHit hit, Vec3 direction) {
    points.push_back(toDouble(camera.origin + direction * hit.z) + origin);
  });
  return points;
}

}  // namespace saccade
