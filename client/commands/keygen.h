// saccade keygen: a new pair of CURVE keys.
#pragma once

#include <string>

namespace saccade::client {

// Writes NAME.key, the secret one, which only its owner may read, and NAME.pub. Throws std::runtime_error
// naming the file, also where it exists: what is in use is never overwritten.
void writeKeyPair(const std::string& name);

}  // namespace saccade::client
