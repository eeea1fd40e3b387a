// A smooth path, drawn by a seed, through the free space around the surfaces of a scene.
#pragma once

#include <stdexcept>
#include <stop_token>
#include <string>

#include "scene/camera/free_space.h"
#include "scene/camera/motion.h"

namespace saccade {

// There is no path. `clearance` is the largest found that has one; 0 where there is none.
struct NoRoom : std::runtime_error {
  NoRoom(const std::string& message, double clearance) : std::runtime_error(message), clearance(clearance) {}
  double clearance;
};

// A path of the kind kRoam that repeats for ever, with a continuous acceleration. `start` says what is up.
//   room   It lies in the free space that straight lines lead to from the start. None of it is nearer to
//          a surface than the clearance. In an open scene it does not go behind it, see surroundings.h.
//   view   In 128 frames spread over it, half of the picture shows surfaces, neither too near nor too far; or
//          half of the best view from the start. Where no try has that, it is the try that shows most.
//   speed  The median speed of the images over the path is as asked, see pace.h.
// A path that lacks the room or the view is drawn anew, a bounded number of times. Throws NoRoom; Cancelled
// once `stop` is requested.
Trajectory makeRoam(const Motion& motion, const Pose& start, const FreeSpace& space, const Lens& lens,
                    const std::stop_token& stop = {});

}  // namespace saccade
