// A report on the file of a scene, for people.
#pragma once

#include <string>

#include "scene/scene.h"

namespace saccade::eval {

// "holds     36 triangles, ...": a line of a report.
std::string reportLine(const std::string& what, const std::string& text);

// Lines that tell of all that is read, of the objects that may move and of the camera. Others tell what is
// not read, each of warningsOf().
std::string sceneReport(const Scene& scene);

}  // namespace saccade::eval
