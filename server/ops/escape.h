// Text of unknown origin as part of one line: control characters, which could begin another line or command
// the terminal, become escapes such as \n and \u001b. What is no UTF-8 becomes U+FFFD.
#pragma once

#include <string>
#include <string_view>

namespace saccade {

std::string escapeControls(std::string_view text);
// The same in quotes, as JSON has it.
std::string quoteJson(std::string_view text);

}  // namespace saccade
