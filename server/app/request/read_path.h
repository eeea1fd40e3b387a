// Reads the poses that a request gives as keyframes or as text.
#pragma once

#include <string>

#include "saccade/v1/control.pb.h"
#include "scene/camera/trajectory.h"

namespace saccade {

// Fills in the interpolation. Throws Refusal naming `field`, or a member of it.
Trajectory readKeyframes(v1::Keyframes& keyframes, const std::string& field);

// Throws Refusal naming `field`, with the line at fault.
PoseText readCsv(const std::string& csv, const std::string& field);

}  // namespace saccade
