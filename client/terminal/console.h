// Text for the terminal. Text of a server or a file cannot command it.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace saccade::client {

// The text with its control characters as escapes such as \n and \u001b.
std::string printable(std::string_view text);

// As std::fprintf() and std::printf(), with all control characters but the end of the line as escapes.
[[gnu::format(printf, 2, 3)]] void print(std::FILE* out, const char* format, ...);
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);

}  // namespace saccade::client
