// Paths that go on as a motion begins, and never turn back.
#pragma once

#include "scene/camera/trajectory.h"

namespace saccade::eval {

// Moves straight with the velocity of `motion` at its start, and passes its start pose at time `at` > 0.
Trajectory straightThrough(const Trajectory& motion, TimeNs at);
// The same for a motion that also turns: goes on along the screw of its first millisecond.
Trajectory turningThrough(const Trajectory& motion, TimeNs at);

}  // namespace saccade::eval
