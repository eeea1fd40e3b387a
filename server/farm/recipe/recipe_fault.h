// A fault in a recipe.
#pragma once

#include <stdexcept>
#include <string>

namespace saccade::farm {

// "FILE:LINE: message"
struct RecipeFault : std::runtime_error {
  RecipeFault(const std::string& file, int line, const std::string& message)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + message) {}
};

}  // namespace saccade::farm
