// saccade keygen: writes a new pair of CURVE keys.
#pragma once

#include <string>

namespace saccade::client {

// Writes the secret key to NAME.key, which only its owner may read, and the public key to NAME.pub. Throws
// std::runtime_error with the file's name, also if it exists: a key is never overwritten.
void writeKeyPair(const std::string& name);

}  // namespace saccade::client
