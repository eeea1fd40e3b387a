// Reads a line of a text file into a buffer, whatever the file holds.
#pragma once

#include <istream>
#include <span>
#include <string_view>

namespace saccade::client {

enum class LineRead { kLine, kEnd, kTooLong };

// Takes a line off `in`, without its end (LF or CRLF). It must be shorter than `buffer`. kEnd: there is no
// further line, or the file cannot be read (`in.bad()`).
LineRead takeLine(std::istream& in, std::span<char> buffer, std::string_view& line);

}  // namespace saccade::client
