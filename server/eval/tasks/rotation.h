// The angular velocity of a camera that turns, by the contrast of warped events.
#pragma once

#include <span>

#include "base/units.h"
#include "base/vec.h"
#include "eval/tasks/warped_events.h"
#include "scene/camera/lens.h"

namespace saccade::eval {

// Radians per second, in the camera's axes. Events are turned to where they would be at `reference`, and the
// variance of their image is largest [G18]. `start`: where the search begins; it moves by about
// two pixels over `span_s`, the time of the events.
Vec3d rotationOf(std::span<const Event> events, const CameraModel& camera, TimeNs reference, double span_s,
                 Vec3d start);

}  // namespace saccade::eval
