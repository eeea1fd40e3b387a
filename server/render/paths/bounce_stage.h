// Each path goes on in a direction that its surface samples, up to the next surface.
#pragma once

#include <limits>

#include "render/bsdf/sampling.h"
#include "render/bsdf/shading_frame.h"
#include "render/paths/lane_queue.h"
#include "render/paths/plastic_lanes.h"
#include "render/paths/shade_hits.h"
#include "render/sampling/path_numbers.h"

namespace saccade {

template <int W, PathKind K>
class BounceRays {
  static constexpr int C = K.channels;
  using F = Floats<W>;

 public:
  explicit BounceRays(const Batch<C>& batch) : b_(batch) {}

  // `path`: the place of each lane's path in LivePaths.
  void add(LaneSet lanes, const Vec3T<F>& origin, const Vec3T<F>& direction, const Uints<W>& path) {
    pushOn(lanes, entries(origin, direction, path));
  }
  // The same for rays that can only find light: they are traced where a lamp is in their direction.
  void addLast(LaneSet lanes, const Vec3T<F>& origin, const Vec3T<F>& direction, const Uints<W>& path) {
    last_.push(lanes, entries(origin, direction, path));
    if (last_.full()) traceLast();
  }
  void finish() {
    if (last_.size() > 0) traceLast();
    if (on_.size() > 0) trace();
  }

 private:
  using Queue = LaneQueue<W, 7>;
  using Entries = typename Queue::Entries;

  static Entries entries(const Vec3T<F>& origin, const Vec3T<F>& direction, const Uints<W>& path) {
    return {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, std::bit_cast<F>(path)};
  }
  void pushOn(LaneSet lanes, const Entries& e) {
    on_.push(lanes, e);
    if (on_.full()) trace();
  }
  void set(const Entries& e) { setRays<W>(e, std::numeric_limits<float>::infinity(), packet_); }

  void traceLast() {
    Entries e;
    const int count = last_.take(e);
    LaneSet found = LaneSet::first(count);
    if (!b_.t.scene.still().lightMayBeAnywhere()) {
      set(e);
      b_.t.scene.emitters().template occluded<W>(packet_, found);
      found &= lanesOf(load<W>(packet_.far) < 0.f);
    }
    pushOn(found, e);
  }

  void trace() {
    Entries e;
    const int count = on_.take(e);
    set(e);
    b_.t.scene.geometry().template intersect<W>(packet_, LaneSet::first(count),
                                                EmbreeTracer::Rays::kScattered);
    const auto path = std::bit_cast<Uints<W>>(e[6]);
    if (b_.t.moved) markThatDiffer(LaneSet::first(count), gather(&b_.now->slot[0], path));
    shadeHits<W, K>(b_, packet_, count, path);
  }

  // Marks the paths whose hits are others in the frame before.
  void markThatDiffer(LaneSet lanes, const Uints<W>& slots) {
    const MovedBodies& moved = *b_.t.moved;
    const LaneSet met = notTouched<W>(b_, lanes & moved.metBy(packet_), slots);
    LaneSet hits;
    forEachLane(met, [&](int i) { hits.add(i, moved.includes(packet_.instance[i])); });
    markTouched<W>(b_, hits | moved.blockedBefore(packet_, met - hits), slots);
  }

  const Batch<C>& b_;
  Queue on_, last_;
  RayPacket<W> packet_;
};

// The changes of a bounce to the W paths from `first` on, where lanes have shaded it.
template <int W, PathKind K>
[[gnu::always_inline]] inline void keepBounce(const Batch<K.channels>& b, int first, const Mask<W>& shaded,
                                              const Floats<W>& pdf,
                                              const std::array<Floats<W>, K.channels>& throughput) {
  constexpr int C = K.channels;
  using F = Floats<W>;
  LivePaths<C>& p = *b.now;
  // As RayCone::lobeSpread().
  F spread = RayCone::kDiffuseSpread * min(F(1.f), F(1.f / sqrt(std::numbers::pi_v<float> * pdf)));
  if constexpr (!K.mixed) {
    store(pdf, &p.pdf[first]), store(spread, &p.spread[first]);
    for (int k = 0; k < C; ++k) store(throughput[k], &p.throughput.of[k][first]);
    return;
  }
  const auto keep = [&](const F& value, Plane& plane) {
    store(select(shaded, value, load<W>(&plane[first])), &plane[first]);
  };
  keep(pdf, p.pdf), keep(spread, p.spread), keep(0.f, p.distance);
  for (int k = 0; k < C; ++k) keep(throughput[k], p.throughput.of[k]);
  forEachLane(lanesOf(shaded), [&](int i) {
    std::uint32_t& state = p.state[static_cast<std::size_t>(first + i)];
    state = (state & ~(PathState::kOneBounce - 1)) + PathState::kOneBounce;
    if (b.vertex == 0) state |= PathState::kFromStart;
  });
}

template <int W, PathKind K>
void bounce(const Batch<K.channels>& b) {
  constexpr int C = K.channels;
  using F = Floats<W>;
  LivePaths<C>& p = *b.now;
  BounceRays<W, K> rays(b);
  for (int first = 0; first < p.count; first += W) {
    auto lanes = firstLanes<W>(p.count - first);
    LaneSet others, plastic;
    if constexpr (K.mixed) {
      others = lanesShadedAs<W>(ShadedAs::kOther, p, first, lanesOf(lanes));
      const Uints<W> bounces = load<W>(&p.state[first]) >> 8;
      lanes = lanes && !maskOf<W>(others) && toFloats(bounces) <= static_cast<float>(b.t.bounces);
      plastic = lanesShadedAs<W>(ShadedAs::kPlastic, p, first, lanesOf(lanes));
    }
    const PathNumbers<W> numbers{load<W>(&p.reversed_index[first]), load<W>(&p.path_key[first])};
    const auto u = numbersAt<W, K.split>(b, numbers, kBounce);
    const F u1 = u(0), u2 = u(1);
    Vec3T<F> local = cosineHemisphere(u1, u2);
    const Vec3T<F> ng = p.geometric_normal.template lanes<W>(first);
    const ShadingFrame<F> frame(p.shading_normal.template lanes<W>(first));
    F pdf = cosinePdf(local.z);
    auto weight = colorLanes<W>(p.reflectance, first);
    if constexpr (K.mixed)
      if (plastic.any()) {
        const PlasticLanes<W, C> surfaces(p, first, frame, plastic);
        const auto these = maskOf<W>(plastic);
        local = selectLanes(these, surfaces.sample(u(kLobe - kBounce), u1, u2, local), local);
        const ScatteredLanes<W, C> f = surfaces.evaluate(local);
        pdf = select(these, f.pdf, pdf);
        for (int k = 0; k < C; ++k) weight[k] = select(these, f.value[k] / f.pdf, weight[k]);
      }
    Vec3T<F> direction = frame.toWorld(local);
    Vec3T<F> origin = p.origin.template lanes<W>(first);
    auto throughput = colorLanes<W>(p.throughput, first);
    for (int k = 0; k < C; ++k) throughput[k] *= weight[k];
    lanes = lanes && pdf > 0.f && dot(direction, ng) > 0.f && luminanceOf(throughput) > 0.f;
    keepBounce<W, K>(b, first, lanes, pdf, throughput);
    LaneSet going = lanesOf(lanes), last = b.vertex >= b.t.bounces ? going : LaneSet{};
    if constexpr (K.mixed) {
      forEachLane(others, [&](int i) {
        const ScatteredRay one = b.stages.sampleBsdf(b.t, b.vertex, p, static_cast<std::uint32_t>(first + i));
        if (!one.goes) return;
        setLane(origin, i, one.origin), setLane(direction, i, one.direction);
        going.add(i);
      });
      const Uints<W> bounces = load<W>(&p.state[first]) >> 8;
      last = b.t.scene.still().hasStraightTransmission()
                 ? LaneSet{}
                 : going & lanesOf(toFloats(bounces) > static_cast<float>(b.t.bounces));
    }
    const Uints<W> path = laneNumbers<W>() + static_cast<std::uint32_t>(first);
    rays.add(going - last, origin, direction, path);
    if (last.any()) rays.addLast(last, origin, direction, path);
  }
  rays.finish();
}

}  // namespace saccade
