#include "cache/grid/grid_reader.h"

#include <algorithm>
#include <cmath>

#include "cache/grid/ray_visibility.h"

namespace saccade {
namespace {

const VertexTable kNoVertices;

}  // namespace

void GridReader::read(std::span<const PointSample> at, std::span<PlaceLight> out) {
  at_.clear();
  for (std::uint32_t k = 0; k < at.size(); ++k)
    if (at[k].kind != SurfaceKind::kNone && !out[k].known && hasLevels(at[k].place))
      at_.add(at[k].place, at[k].kind, k, params_.cell_px);
  if (at_.empty()) return;
  at_.makeTaps();
  memory_->readers.clear();
  for (int l = at_.least_level; l <= at_.most_level; ++l) {
    const GridLevel* level = levels_.find(l);
    memory_->readers.emplace_back(level ? level->table : kNoVertices);  // a level between those of two points
  }
  for (int slot = 0; slot < kSlots; ++slot) findVertices(slot);
  PointLanes lanes;
  for (std::size_t i = 0; i < at_.points.size(); ++i) {
    lanes.add(levels_, at_, i);
    if (!lanes.full() && i + 1 < at_.points.size()) continue;
    readLanes(lanes, at, out);
    lanes.count = 0;
  }
}

// Whether the grid has cells of all sizes that a point takes part in.
bool GridReader::hasLevels(const SurfacePlace& place) const {
  const int l = gridPoint(place, params_.cell_px).level;
  for (int slot = 0; slot < kSlots; ++slot) {
    const GridLevel* level = levels_.find(l + slot);
    if (!level || level->table.size() == 0) return false;
  }
  return true;
}

void GridReader::findVertices(int slot) {
  TetrahedronLanes lanes;
  constexpr std::size_t kLanes = TetrahedronLanes::kLanes;
  for (std::size_t first = 0; first < at_.points.size(); first += kLanes) {
    const auto points = std::span(at_.points).subspan(first, std::min(kLanes, at_.points.size() - first));
    alignas(64) float inv_h[kLanes] = {};
    for (std::size_t i = 0; i < points.size(); ++i) {
      lanes.setPoint(static_cast<int>(i), points[i].position);
      inv_h[i] = std::ldexp(1.f, -points[i].level - slot);
    }
    lanes.find(load<TetrahedronLanes::kLanes>(inv_h));
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::uint32_t t = points[i].first; t < points[i].first + points[i].count; ++t)
        setTaps(lanes, static_cast<int>(i), points[i], t, slot);
  }
}

void GridReader::setTaps(const TetrahedronLanes& lanes, int lane, const GridPoint& point, std::uint32_t t,
                         int slot) {
  Taps& taps = at_.taps[slot][t];
  const auto keys = Tetrahedron::corners(lanes.lowest(lane, at_.bins[t]), lanes.order(lane));
  const Quad weights = lanes.weights(lane) * at_.bin_weights[t];
  const int l = point.level + slot;
  VertexTable::Reader& reader = memory_->readers[l - at_.least_level];
  for (int c = 0; c < 4; ++c) {
    const std::uint32_t v = reader.indexOf(keys[c]);
    const bool known = v != VertexTable::kNone;
    taps.vertex[c] = known ? levels_[l].cuts.of(v, point.position) : 0;
    taps.weight[c] = known ? weights[c] : 0;
  }
}

void GridReader::readLanes(const PointLanes& lanes, std::span<const PointSample> at,
                           std::span<PlaceLight> out) const {
  const LevelBlend<PointFloats> blend = lanes.blend(params_.blend);
  LaneMemory<2> values;
  store(blend.residual.value, values.values[0]), store(blend.visibility.value, values.values[1]);
  const int slot = params_.pixelSlot();
  for (int i = 0; i < lanes.count; ++i) {
    if (!(lanes.light[kTop].values[0][i] > 0)) continue;
    const std::uint32_t k = at_.points[lanes.points[i]].index;
    const float shadow = shadowVariance(lanes.light[slot].at<Quad>(i), lanes.evidence[slot].at<Octet>(i),
                                        at[k].place.unoccluded, params_.blend);
    out[k] = {true, values.values[0][i], values.values[1][i], shadow, shadow > 0};
  }
}

}  // namespace saccade
