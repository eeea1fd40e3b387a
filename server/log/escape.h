// Escapes text of unknown origin for one line of the log.
//
// Control characters could begin another line or command the terminal: they become escapes such as \n and
// \u001b. Bytes that are not UTF-8 become U+FFFD.
#pragma once

#include <string>
#include <string_view>

namespace saccade {

std::string escapeControls(std::string_view text);
// The same as a JSON string, in quotes.
std::string quoteJson(std::string_view text);

}  // namespace saccade
