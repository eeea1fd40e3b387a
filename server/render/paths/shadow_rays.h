// Shadow rays of a stage: traced in packets, and the light of those that nothing blocks is added.
#pragma once

#include <bit>

#include "render/paths/batch.h"
#include "render/paths/lane_queue.h"
#include "render/paths/trace_batch.h"

namespace saccade {

template <int W, PathKind K>
class ShadowRays {
  static constexpr int C = K.channels;
  using F = Floats<W>;

 public:
  struct Lanes {
    Vec3T<F> origin, segment;
    F reach;
    Uints<W> slot;
    F pdf_light, pdf_bsdf;        // pdf_bsdf 0: only samples of the lights find this light
    std::array<F, C> light;       // of the path, over pdf_light, before the balance of both pdfs
    std::array<F, C> unoccluded;  // split: of a white surface, where the lamp's light has a closed form
    F closed_form;
  };

  explicit ShadowRays(const Batch<C>& batch) : b_(batch) {}

  void add(LaneSet lanes, const Lanes& rays) {
    typename Queue::Entries e;
    put(rays, e);
    queue_.push(lanes, e);
    if (queue_.full()) trace();
  }
  void finish() {
    if (queue_.size() > 0) trace();
    if (unblocked_.size() > 0) traceThrough();
  }

 private:
  static constexpr int kFields = 10 + C + (K.split ? C + 1 : 0);
  using Queue = LaneQueue<W, kFields>;
  using Entries = typename Queue::Entries;

  static void put(const Lanes& r, Entries& e) {
    e = {};
    e[0] = r.origin.x, e[1] = r.origin.y, e[2] = r.origin.z;
    e[3] = r.segment.x, e[4] = r.segment.y, e[5] = r.segment.z;
    e[6] = r.reach, e[7] = std::bit_cast<F>(r.slot), e[8] = r.pdf_light, e[9] = r.pdf_bsdf;
    for (int k = 0; k < C; ++k) e[10 + k] = r.light[k];
    if constexpr (K.split) {
      for (int k = 0; k < C; ++k) e[10 + C + k] = r.unoccluded[k];
      e[10 + 2 * C] = r.closed_form;
    }
  }

  // Entries as memory.
  struct Unpacked {
    explicit Unpacked(const Entries& e) {
      store(e[6], reach), store(std::bit_cast<Uints<W>>(e[7]), slot);
      store(e[8], pdf_light), store(e[9], pdf_bsdf), store(balance(e[8], e[9]), weight);
      for (int k = 0; k < C; ++k) store(e[10 + k], light[k]);
      if constexpr (K.split) {
        for (int k = 0; k < C; ++k) store(e[10 + C + k], unoccluded[k]);
        store(e[10 + 2 * C], closed_form);
      }
    }
    static Color<C> at(const float (&lanes)[C][W], int i) {
      if constexpr (C == 1) return Color<1>(lanes[0][i]);
      if constexpr (C == 3) return Color<3>(Rgb{lanes[0][i], lanes[1][i], lanes[2][i]});
    }
    alignas(64) float reach[W], pdf_light[W], pdf_bsdf[W], weight[W], light[C][W], unoccluded[C][W],
        closed_form[W];
    alignas(64) std::uint32_t slot[W];
  };

  // Adds the light of a ray, of which so much comes through.
  void add(const Unpacked& rays, int i, Color<C> through, float weight) {
    const Color<C> found = Unpacked::at(rays.light, i) * through * weight;
    b_.results.radiance.add(rays.slot[i], found);
    if constexpr (K.split) {
      b_.results.visible.add(rays.slot[i], Unpacked::at(rays.unoccluded, i) * through);
      if (rays.closed_form[i] > 0) b_.results.mis_weighted.add(rays.slot[i], found);
    }
  }

  void trace() {
    Entries e;
    const LaneSet all = LaneSet::first(queue_.take(e));
    setRays<W>(e, e[6], packet_);
    const LaneSet open = b_.t.moved ? openOfBoth(all, e) : openOf(all);
    if (has_panes_) {
      unblocked_.push(open, e);
      if (unblocked_.full()) traceThrough();
      return;
    }
    const Unpacked rays(e);
    forEachLane(open, [&](int i) { add(rays, i, Color<C>(1.f), rays.weight[i]); });
  }

  // Returns the rays that nothing blocks.
  LaneSet openOf(LaneSet rays) {
    b_.t.scene.geometry().template occluded<W>(packet_, rays);
    return notBlocked(rays);
  }
  LaneSet notBlocked(LaneSet rays) const { return rays - lanesOf(load<W>(packet_.far) < 0.f); }

  // The same. Marks the paths of rays that arrive in this frame alone, or in the frame before alone. Asks the
  // shapes that stand once for both.
  LaneSet openOfBoth(LaneSet rays, const Entries& e) {
    const PosedShapes shapes = b_.t.scene.geometry();
    shapes.still().template occluded<W>(packet_, rays);
    rays = notBlocked(rays);
    if (!rays.any()) return rays;
    const auto slots = std::bit_cast<Uints<W>>(e[7]);
    LaneSet met = notTouched<W>(b_, rays & b_.t.moved->metBy(packet_), slots);
    // Direct light in closed form that diffuse surfaces reflect is known otherwise.
    if constexpr (K.split && !K.mixed) met = met - lanesOf(e[10 + 2 * C] > 0.f);
    const LaneSet before = met - b_.t.moved->blockedBefore(packet_, met);
    shapes.bodies()->template occluded<W>(packet_, rays);
    rays = notBlocked(rays);
    const LaneSet now = met & rays;
    // Panes of bodies may dim those that arrive in both.
    markTouched<W>(b_, has_panes_ ? now | before : (now | before) - (now & before), slots);
    return rays;
  }

  // The panes and masks in the way of rays that nothing else blocks.
  void traceThrough() {
    Entries e;
    const int count = unblocked_.take(e);
    RayPacket<W> packet;
    setRays<W>(e, e[6], packet);
    b_.t.scene.straight().template intersect<W>(packet, LaneSet::first(count),
                                                EmbreeTracer::Rays::kScattered);
    const Unpacked rays(e);
    for (int i = 0; i < count; ++i) {
      const Hit hit = packet.hit(i);
      if (!hit.valid) {
        add(rays, i, Color<C>(1.f), rays.weight[i]);
        continue;
      }
      Ray ray = packet.ray(i);
      ray.tfar = rays.reach[i];  // the packet has that of the hit
      const Transmittance through = b_.stages.transmit(b_.t, ray, hit);
      if (through.probability > 0)
        add(rays, i, Color<C>(through.fraction),
            balance(rays.pdf_light[i], rays.pdf_bsdf[i] * through.probability));
    }
  }

  const Batch<C>& b_;
  const bool has_panes_ = K.mixed && b_.t.scene.still().hasStraightTransmission();
  Queue queue_, unblocked_;
  RayPacket<W> packet_{has_panes_ ? kBlockingMask : kBlockingMask | kStraightMask};
};

}  // namespace saccade
