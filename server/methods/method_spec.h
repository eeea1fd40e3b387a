// Reads methods as commands name them: "svgf", "svgf:as_falcor=1", "event_svgf:alpha=0.2:iterations=3".
#pragma once

#include <string>
#include <vector>

#include "methods/method.h"

namespace saccade {

struct MethodSpec {
  std::string text;           // as given
  std::string name;           // of methodTable()
  ParamValues params;         // resolved
  bool takes(int spp) const;  // whether the passes can share that many paths, see takesSpp()
};

// Throws std::runtime_error, which names the valid choices.
MethodSpec parseMethod(const std::string& text);
// `settings`: "name=number".
MethodSpec parseMethod(const std::string& name, const std::vector<std::string>& settings);

}  // namespace saccade
