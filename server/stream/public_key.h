// The public key of a pair.
#pragma once

#include <string>

namespace saccade {

// Of a secret key as text, see curve_key.h.
std::string publicKeyOf(const std::string& secret_key);

}  // namespace saccade
