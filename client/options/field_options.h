// The options that fill in the fields of a request.
#pragma once

#include <string>

namespace saccade::client {

// The option for a field that a server names, such as "--threshold" for "sensors[1].threshold"; empty: none.
std::string optionOf(const std::string& field);

}  // namespace saccade::client
