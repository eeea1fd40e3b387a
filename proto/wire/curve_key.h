// Keys of CURVE as text: 32 bytes as 40 characters of Z85 [ZeroMQ RFC 32].
#pragma once

#include <string>
#include <string_view>

namespace saccade {

bool isCurveKey(std::string_view text);

// The key in a file that holds nothing else but blanks. Throws std::invalid_argument naming the file.
std::string readCurveKey(const std::string& path);

// A warning if every user of this machine may read the secret key in the file; else empty.
std::string warningOfOpenKey(const std::string& path);

}  // namespace saccade
