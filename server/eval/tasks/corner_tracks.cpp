#include "eval/tasks/corner_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "eval/bench/interrupt.h"
#include "eval/tasks/active_events.h"
#include "eval/tasks/efast.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

// A track counts once its corner has moved so far, and is lost at this distance from the truth.
constexpr float kLeastMovedPx = 3, kLostPx = 3;

float distance(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

const CornerTrack& CornerTracks::add(Vec2 corner, TimeNs t) {
  std::erase_if(tracks_, [&](const CornerTrack& track) { return t - track.end > kTrackRest; });
  const auto nearest =
      std::min_element(tracks_.begin(), tracks_.end(), [&](const CornerTrack& a, const CornerTrack& b) {
        return distance(a.last, corner) < distance(b.last, corner);
      });
  if (nearest == tracks_.end() || distance(nearest->last, corner) > kTrackReachPx)
    return tracks_.emplace_back(CornerTrack{corner, t, corner, t});
  nearest->last = corner, nearest->end = t;
  return *nearest;
}

// The share of corners further than kLostPx from where the flow carries the first corner of their track. Only
// corners that it carries by kLeastMovedPx count.
TaskScore scoreCornerTracks(const TaskInput& input) {
  ActiveEvents active(input.truth.camera.width, input.truth.camera.height);
  std::array<CornerTracks, 2> tracks;
  std::size_t lost = 0, counted = 0;
  for (const Event& e : input.events) {
    if (interrupted()) throw Interrupted{};
    if (!active.add(e) || !isCorner(active.times(e.p), e.x, e.y)) continue;
    const CornerTrack& track = tracks[e.p].add({float(e.x), float(e.y)}, TimeNs(e.t_ns));
    const Vec2 truth = input.truth.carried(track.start, track.begin, track.end);
    if (distance(truth, track.start) < kLeastMovedPx) continue;
    ++counted, lost += distance(truth, track.last) > kLostPx;
  }
  if (counted == 0) return {};
  return {static_cast<double>(lost) / static_cast<double>(counted), counted};
}

}  // namespace saccade::eval
