// Methods as commands name them: "svgf", "svgf:as_falcor=1", "event_svgf:alpha=0.2:iterations=3".
#pragma once

#include <string>
#include <vector>

#include "methods/method.h"

namespace saccade {

struct MethodSpec {
  std::string text;           // as given
  std::string name;           // of methodTable()
  ParamValues params;         // resolved
  bool takes(int spp) const;  // correlated methods need an even number
};

// Throws std::runtime_error naming what is wrong and what is valid.
MethodSpec parseMethod(const std::string& text);
// "name=number" pairs for a method.
MethodSpec parseMethod(const std::string& name, const std::vector<std::string>& settings);

}  // namespace saccade
