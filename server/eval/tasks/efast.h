// Corners among events.
#pragma once

#include "frame/image.h"

namespace saccade::eval {

inline constexpr int kCornerReach = 4;  // pixels around an event that count

// Whether the latest event, which is at (x, y), is a corner. `times`: of its polarity, seconds, -infinity
// without an event. Not within kCornerReach of the border.
//
// On the circle of radius 3 an arc of 3 to 6 pixels must be newer than all others [MBS17]. The same holds for
// the circle of radius 4, with an arc of 4 to 8.
//
// [MBS17] Mueggler, Bartolozzi, Scaramuzza, Fast event-based corner detection, BMVC 2017.
bool isCorner(const Image<double>& times, int x, int y);

}  // namespace saccade::eval
