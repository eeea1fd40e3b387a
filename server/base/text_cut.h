// Makes text of unknown origin fit for messages: valid UTF-8 of bounded length.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace saccade {

// Bytes of the first character of `text`; 0 where it is not UTF-8 [RFC 3629].
std::size_t utf8Length(std::string_view text);
bool isUtf8(std::string_view text);

// The first characters of `text` that fit into `max_bytes`, then "..." if there are more. Each byte that is
// not UTF-8 becomes U+FFFD.
std::string cutText(std::string_view text, std::size_t max_bytes);

// A reply or the log repeats at most this many bytes of a client's text.
inline constexpr std::size_t kMaxEcho = 64;
// A fault lists at most this many bytes of names that would be valid.
inline constexpr std::size_t kMostNames = 1024;

}  // namespace saccade
