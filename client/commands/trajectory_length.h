// Warns of a trajectory that is shorter or longer than its stream.
#pragma once

#include <string>

namespace saccade::client {

// Returns a sentence if the last pose, at `trajectory_s`, comes before the end of the stream at `stream_s`
// (0: there is no end). Returns one too if it comes `frame_s` or more after that, or if the unit of the
// file's times looks wrong. Empty otherwise. All in seconds.
std::string trajectoryWarning(double trajectory_s, double stream_s, double frame_s);

}  // namespace saccade::client
