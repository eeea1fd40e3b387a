// Tells a fault where it is.
#pragma once

#include <pugixml.hpp>

#include "scene/files/scene_error.h"

namespace saccade {

// Returns act(). A SceneError that it throws is told at an element of `file`, with file and line.
template <class File, class Act>
auto toldAt(const File& file, pugi::xml_node at, Act act) {
  try {
    return act();
  } catch (const SceneError& fault) {
    throw file.error(at, fault.what());
  }
}

}  // namespace saccade
