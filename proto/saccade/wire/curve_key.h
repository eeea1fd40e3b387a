// Keys of CURVE as text: 32 bytes as 40 characters of Z85 [ZeroMQ RFC 32].
#pragma once

#include <string>
#include <string_view>

namespace saccade {

bool isCurveKey(std::string_view text);

// The key in a file that holds nothing else but blanks. Throws std::invalid_argument naming the file.
std::string readCurveKey(const std::string& path);

// The same, and throws for a file that `saccade keygen` wrote for the other key: NAME.key is secret, and
// NAME.pub is public.
std::string readSecretKey(const std::string& path);
std::string readPublicKey(const std::string& path);
void requirePublic(const std::string& path);  // by its name alone

// A warning if every user of this machine may read the secret key in the file; else empty.
std::string warningOfOpenKey(const std::string& path);

}  // namespace saccade
