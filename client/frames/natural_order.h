// The order of names by the numbers in them: "frame2" comes before "frame10".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace saccade::client {

bool naturalLess(std::string_view a, std::string_view b);

// Whether a and b differ first in a number, and b has the lesser one.
bool numberFalls(std::string_view a, std::string_view b);

}  // namespace saccade::client
