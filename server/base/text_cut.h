// Text of unknown origin, made fit for messages: valid UTF-8 of bounded length.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace saccade {

// Bytes of the character that `text` begins with; 0 where it is no UTF-8 [RFC 3629].
std::size_t utf8Length(std::string_view text);
bool isUtf8(std::string_view text);

// The characters of `text` that fit into `max_bytes`, and "..." where there are more. Each byte that is no
// UTF-8 becomes U+FFFD.
std::string cutText(std::string_view text, std::size_t max_bytes);

// Bytes of a text that came from a client, where a reply or the log repeats it.
inline constexpr std::size_t kMaxEcho = 64;

}  // namespace saccade
