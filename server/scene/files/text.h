// Text read piece by piece: lines, words, numbers.
#pragma once

#include <optional>
#include <string_view>

namespace saccade {

// Takes the first line off `text`, without its end (LF or CRLF).
std::string_view takeLine(std::string_view& text);

// Takes the next word off `text`; blanks, tabs, line ends and the characters of `also` part words. Empty at
// the end.
std::string_view takeWord(std::string_view& text, std::string_view also = {});

// Without blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

// The finite number that `word` is as a whole, or none.
std::optional<double> parseNumber(std::string_view word);
std::optional<long long> parseInteger(std::string_view word);

}  // namespace saccade
