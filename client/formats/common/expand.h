// Expands compressed parts of files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace saccade::client {

// Both replace `to`, and throw std::runtime_error if `bytes` are not one whole frame, or give more than
// `most` bytes.
void expandLz4(std::string& to, std::string_view bytes, std::size_t most);
void expandZstd(std::string& to, std::string_view bytes, std::size_t most);

}  // namespace saccade::client
