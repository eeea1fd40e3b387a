// The abilities of this build, as its ServerDescription has them.
#pragma once

#include "saccade/v1/control.pb.h"

namespace saccade {

// Adds all methods.
void describeMethods(v1::ServerDescription& description);
// Adds all features of a scene that a stream can disable.
void describeFeatures(v1::ServerDescription& description);
void describeTruth(v1::ServerDescription& description);
void describePresets(v1::ServerDescription& description);

}  // namespace saccade
