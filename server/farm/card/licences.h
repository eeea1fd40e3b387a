// Where the scenes of a data set come from. The README.md of a scene tells its licence in a paragraph that
// begins with "Licence:".
#pragma once

#include <string>

namespace saccade::farm {

// The text behind "Licence:" in scenes/SCENE/README.md, on one line; empty: it is not known.
std::string licenceOf(const std::string& scenes, const std::string& scene);

}  // namespace saccade::farm
