#include "render/lights/light_columns.h"

#include <bit>

#include "render/lights/analytic_light.h"

namespace saccade {

namespace {

// As ChosenLamp::pdf.
float pdfByPower(const Lamps& lamps, LightSet set, std::size_t i) {
  const LightChoice& choice = lamps.byPower(set);
  if (i < lamps.areaLamps().size()) return luminance(lamps.areaLamps()[i].radiance) * choice.inverseWeight();
  return i < choice.sums().size() ? choice.probability(i) : 0;
}

}  // namespace

LightColumns::LightColumns(const Lamps& lamps, const AnalyticLight& analytic) {
  const auto set = [&](Column x, Vec3 v) {
    columns_[x].push_back(v.x), columns_[x + 1].push_back(v.y), columns_[x + 2].push_back(v.z);
  };
  for (std::size_t i = 0; i < lamps.count(); ++i) {
    const bool triangle =
        i < lamps.areaLamps().size() && lamps.areaLamps()[i].radius == 0 && lamps.areaLamps()[i].picture < 0;
    const AreaLamp lamp = triangle ? lamps.areaLamps()[i] : AreaLamp{};
    all_triangles_ = all_triangles_ && triangle;
    set(kCornerX, lamp.corner);
    set(kEdge1X, lamp.edge1);
    set(kEdge2X, lamp.edge2);
    set(kNormalX, triangle ? normalize(cross(lamp.edge1, lamp.edge2)) : Vec3{});
    set(kRed, lamp.radiance);
    columns_[kLuminance].push_back(luminance(lamp.radiance));
    for (int k = 0; k < kLightSets; ++k)
      columns_[static_cast<std::size_t>(kPdf + k)].push_back(pdfByPower(lamps, static_cast<LightSet>(k), i));
    columns_[kClosedForm].push_back(triangle && analytic.holds(lamp.geometry) ? 1.f : 0.f);
    columns_[kTriangle].push_back(triangle ? 1.f : 0.f);
    columns_[kGeometry].push_back(triangle ? static_cast<float>(lamp.geometry) : 0.f);
  }
  choices_ = {Choice(lamps.byPower(LightSet::kAll)), Choice(lamps.byPower(LightSet::kWithExtent))};
}

LightColumns::Choice::Choice(const LightChoice& of)
    : sums(of.sums()), last(static_cast<float>(sums.size()) - 1) {
  sums.resize(std::bit_ceil(sums.size()), 2.f);
}

}  // namespace saccade
