// Where the scenes are.
#pragma once

#include <string>

namespace saccade {

// The folder of scenes of this program's installation, else of the source tree that it was built from.
std::string findScenes();

}  // namespace saccade
