#include "render/paths/found_light.h"

#include <algorithm>

namespace saccade {

template <int C, bool kSplit>
void addFound(const Tracing& t, const Found& found, Color<C> throughput, float pdf, bool from_start,
              PathResults<C>& results) {
  const EmitterPoint& at = found.emitter;
  const float pdf_light = t.scene.lights().lamps().pdf(t.lightsOf(from_start), at, found.vertex);
  const float weight = pdf == kDeltaPdf ? 1 : balance(pdf, pdf_light);
  const Color<C> light = throughput * Color<C>(at.radiance) * (weight * t.scene.strengths()[at.geometry]);
  results.radiance.add(found.slot, light);
  if constexpr (kSplit)
    if (from_start && t.scene.analyticLight().holds(at.geometry)) results.mis_weighted.add(found.slot, light);
}

template <int C>
bool endsAtKnownLight(const Tracing& t, const SecondVertex& v, const PathSampler& sampler, std::uint32_t slot,
                      Color<C>& throughput, PathResults<C>& results) {
  constexpr float kLeastAlbedo = 1e-3f;
  constexpr float kPartThatGoesOn = 1.f / 8;  // of the paths, so that light is known better
  // Of a cell's edge. Single cells would show where they are near, and in directions like a mirror's.
  constexpr float kLeastCone = RayCone::kDiffuseSpread;
  if (!t.known.grid || std::min({v.albedo.x, v.albedo.y, v.albedo.z}) < kLeastAlbedo) return false;
  const BounceCell cell(v.point, v.normal, t.known.pixel * length(v.point - t.known.eye));
  if (v.width < kLeastCone * cell.edge) return false;
  if (const auto known = t.known.grid->find(cell)) {
    results.radiance.add(slot, throughput * Color<C>(v.albedo * known->light));
    if (known->well || sampler.u(kGoOn) >= kPartThatGoesOn) return true;
    throughput = Color<C>();  // what the path finds from here on is for the grid alone
  }
  results.suffix_cell[slot] = cell.key, results.suffix_albedo[slot] = v.albedo;
  results.before.set(slot, results.radiance.at(slot)), results.carried.set(slot, throughput);
  results.radiance.set(slot, Color<C>()), throughput = Color<C>(1.f);
  return false;
}

#define INSTANTIATE(C)                                                                                      \
  template void addFound<C, false>(const Tracing&, const Found&, Color<C>, float, bool, PathResults<C>&);   \
  template void addFound<C, true>(const Tracing&, const Found&, Color<C>, float, bool, PathResults<C>&);    \
  template bool endsAtKnownLight<C>(const Tracing&, const SecondVertex&, const PathSampler&, std::uint32_t, \
                                    Color<C>&, PathResults<C>&);
INSTANTIATE(1)
INSTANTIATE(3)

}  // namespace saccade
