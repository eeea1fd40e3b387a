#include "truth/event_objects.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/tile_pool.h"
#include "truth/object_numbers.h"
#include "truth/shape_rays.h"

namespace saccade {
namespace {

void findIn(const PosedScene& scene, const Camera& camera, std::span<const std::uint32_t> numbers,
            std::span<Event> events) {
  std::array<ShapeRay, kShapeRays> rays;
  std::array<Hit, kShapeRays> hits;
  while (!events.empty()) {
    const std::size_t count = std::min(events.size(), kShapeRays);
    for (std::size_t i = 0; i < count; ++i)
      rays[i] = {static_cast<float>(events[i].x), static_cast<float>(events[i].y)};
    meetShapes(scene, camera, std::span(rays).first(count), std::span(hits).first(count));
    for (std::size_t i = 0; i < count; ++i) events[i].object = hits[i].valid ? numbers[hits[i].geometry] : 0;
    events = events.subspan(count);
    TilePool::yieldToHighPriority();
  }
}

}  // namespace

void EventObjects::find(const RenderedInterval& interval, Events& events) {
  if (numbers_.empty()) numbers_ = objectNumbers(interval.scene.still().description());
  const std::int64_t t0 = interval.frames.prev.time.count(), t1 = interval.frames.cur.time.count();
  const auto later = std::ranges::partition_point(
      events, [&](const Event& event) { return event.t_ns - t0 < t1 - event.t_ns; });
  findIn(interval.scene_t0, interval.camera_t0, numbers_, std::span(events.begin(), later));
  findIn(interval.scene, interval.camera, numbers_, std::span(later, events.end()));
}

}  // namespace saccade
