// Text read piece by piece (lines, words, numbers), and lists of names for messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace saccade {

// Takes the first line off `text`, without its end (LF or CRLF).
std::string_view takeLine(std::string_view& text);

// Takes the next word off `text`; blanks, tabs, line ends and the characters of `also` part words. Empty at
// the end.
std::string_view takeWord(std::string_view& text, std::string_view also = {});

// The finite number that `word` is as a whole, or none.
std::optional<double> parseNumber(std::string_view word);
std::optional<long long> parseInteger(std::string_view word);

// "a, b, c", or "none", for messages that list what is valid.
std::string joinNames(const std::vector<std::string>& names);

}  // namespace saccade
