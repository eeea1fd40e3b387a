// Joins the corners of one polarity to tracks.
#pragma once

#include <vector>

#include "base/units.h"
#include "base/vec.h"

namespace saccade::eval {

inline constexpr float kTrackReachPx = 3;        // from the last corner of a track to the next
inline constexpr TimeNs kTrackRest{50'000'000};  // a track without a corner for longer has ended

struct CornerTrack {
  Vec2 start;
  TimeNs begin;
  Vec2 last;
  TimeNs end;  // of the last corner
};

class CornerTracks {
 public:
  // Adds a corner, in time order, to the nearest track within reach, or begins one. Returns its track, which
  // is valid until the next call.
  const CornerTrack& add(Vec2 corner, TimeNs t);

 private:
  std::vector<CornerTrack> tracks_;  // those that have not ended
};

}  // namespace saccade::eval
