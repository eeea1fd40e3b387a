// Finds events of what moves against the scene, for a camera that moves too.
//
// [M18] Mitrokhin, Fermueller, Parameshwara, Aloimonos, Event-based moving object detection and tracking,
// IROS 2018.
#pragma once

#include <span>
#include <vector>

#include "base/units.h"
#include "eval/tasks/warped_events.h"

namespace saccade::eval {

// The motion of the whole picture: a shift, an expansion and a turn about its middle [M18].
struct GlobalMotion {
  double x = 0, y = 0;             // pixels per second
  double expansion = 0, turn = 0;  // per second
};

// The one of most contrast, where an event counts by the area that the motion makes of its pixel. Else events
// would fall together under a motion that shrinks the picture [SAG22]. [M18] minimises the gradient of the
// time image instead. `span_s`: of the events.
//
// [SAG22] Shiba, Aoki, Gallego, Event collapse in contrast maximization frameworks, Sensors 2022. The weights
// are ours.
GlobalMotion globalMotion(std::span<const Event> events, int width, int height, TimeNs reference,
                          double span_s);

// For each event |T - mean T| / span. T is the mean time of the events that the motion brings to its place,
// blurred. [M18] takes the same number from its time image, with the sign. Events of an edge that follows the
// motion have about the mean time. An event alone tells nothing of motion. So T is a mean with kPriorEvents
// of the mean time [ours].
inline constexpr float kPriorEvents = 1;  // per pixel
std::vector<double> motionScores(std::span<const Event> events, int width, int height,
                                 const GlobalMotion& motion, TimeNs reference, double span_s);

}  // namespace saccade::eval
