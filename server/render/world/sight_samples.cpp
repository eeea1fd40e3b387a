#include "render/world/sight_samples.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/hash_rng.h"
#include "render/bsdf/sampling.h"
#include "render/bsdf/shading_frame.h"
#include "render/world/ray_offset.h"

namespace saccade {
namespace {

constexpr std::size_t kRays = 4096;  // from all lamps together

// The random numbers of a sample, in order.
struct Numbers {
  std::uint32_t used;
  float next() { return toUnit(mix32(used++)); }
};
constexpr std::uint32_t kNumbers = 8;  // of a ray, at most

Ray towards(Vec3 origin, Vec3 axis, Vec3 local) {
  return {origin, ShadingFrame<float>(axis).toWorld(local), std::numeric_limits<float>::infinity()};
}

// Uniform within the cone.
Ray rayFrom(const SpotLight& lamp, Numbers u) {
  const float z = 1 - u.next() * (1 - std::cos(lamp.cutoff)), r = std::sqrt(std::max(0.f, 1 - z * z));
  const float turn = 2 * std::numbers::pi_v<float> * u.next();
  return towards(lamp.position, lamp.axis, {r * std::cos(turn), r * std::sin(turn), z});
}

// `edge`: of the lamp's shape, see ShapeRow.
Ray rayFrom(const AreaLamp& lamp, Numbers u, float edge) {
  const auto [on_lamp, normal] = lamp.at(u.next(), u.next());
  const Vec3 origin = on_lamp + normal * rayOffset(on_lamp, on_lamp, edge);
  return towards(origin, normal, cosineHemisphere(u.next(), u.next()));
}

SightSample::Seen sightOf(const Lamps& lamps, const LampLeaf& leaf, const Receiver& at, Numbers u,
                          const EmbreeScene& geometry) {
  const auto chosen = leaf.first + static_cast<std::uint32_t>(u.next() * static_cast<float>(leaf.count));
  const IncidentLight light = lamps.sample({chosen, 1}, at.point, u.next(), u.next());
  if (!(light.pdf > 0) || luminance(light.radiance) <= 0 || dot(light.direction, at.normal) <= 0)
    return SightSample::kNothing;
  RayPacket<8> packet(kBlockingMask);
  packet.set(0, {at.point, light.segment, light.reach});
  geometry.occluded(packet, LaneSet::first(1));
  return packet.far[0] < 0 ? SightSample::kBlocked : SightSample::kLamp;
}

}  // namespace

std::vector<SightSample> sightSamples(const Lamps& lamps, LightSet set, const EmbreeScene& geometry,
                                      const std::vector<ShapeRow>& rows) {
  const std::size_t count = lamps.tree(set).count();
  std::vector<SightSample> samples;
  for (std::size_t i = 0; i < kRays; ++i) {
    const auto first = static_cast<std::uint32_t>(i * (1 + kLampGroups)) * kNumbers;
    Numbers u{first};
    const LampLeaf& from = lamps.leaves()[i * count / kRays];
    const std::uint32_t number =
        from.first + static_cast<std::uint32_t>(u.next() * static_cast<float>(from.count));
    const std::size_t areas = lamps.areaLamps().size();
    const Ray ray = number < areas
                        ? rayFrom(lamps.areaLamps()[number], u, rows[lamps.areaLamps()[number].geometry].edge)
                        : rayFrom(lamps.spots()[number - areas], u);
    const Hit hit = geometry.intersect(ray);
    if (!hit.valid) continue;
    const Vec3 normal = normalize(dot(hit.normal, ray.direction) < 0 ? hit.normal : -hit.normal);
    const Vec3 point = ray.origin + ray.direction * hit.t;
    const float offset = rayOffset(ray.origin, point, rows[hit.geometry].edge);
    SightSample sample{{point + normal * offset, normal}, {}};
    for (std::size_t k = 0; k < kLampGroups; ++k) {
      const std::span<const std::uint32_t> group = lamps.tree(set).groups()[k];
      if (group.empty()) continue;
      Numbers v{first + static_cast<std::uint32_t>(1 + k) * kNumbers};
      const auto leaf = group[static_cast<std::size_t>(v.next() * static_cast<float>(group.size()))];
      sample.seen[k] = sightOf(lamps, lamps.leaves()[leaf], sample.at, v, geometry);
    }
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace saccade
