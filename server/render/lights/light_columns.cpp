#include "render/lights/light_columns.h"

#include <bit>

#include "render/lights/analytic_light.h"
#include "render/lights/lights.h"

namespace saccade {

LightColumns::LightColumns(const Lights& lights, const AnalyticLight& analytic)
    : cdf_(lights.cdf()), last_(static_cast<float>(cdf_.size()) - 1) {
  const auto set = [&](Column x, Vec3 v) {
    columns_[x].push_back(v.x), columns_[x + 1].push_back(v.y), columns_[x + 2].push_back(v.z);
  };
  for (std::size_t i = 0; i < cdf_.size(); ++i) {
    const bool triangle = i < lights.areaLights().size() && lights.areaLights()[i].radius == 0;
    const AreaLight light = triangle ? lights.areaLights()[i] : AreaLight{};
    all_triangles_ = all_triangles_ && triangle;
    set(kCornerX, light.corner);
    set(kEdge1X, light.edge1);
    set(kEdge2X, light.edge2);
    set(kNormalX, triangle ? normalize(cross(light.edge1, light.edge2)) : Vec3{});
    set(kRed, light.radiance);
    columns_[kLuminance].push_back(luminance(light.radiance));
    columns_[kPdf].push_back(lights.pdf(light.radiance));
    columns_[kClosedForm].push_back(triangle && analytic.holds(light.geometry) ? 1.f : 0.f);
    columns_[kTriangle].push_back(triangle ? 1.f : 0.f);
    columns_[kGeometry].push_back(triangle ? static_cast<float>(light.geometry) : 0.f);
  }
  cdf_.resize(std::bit_ceil(cdf_.size()), 2.f);
}

}  // namespace saccade
