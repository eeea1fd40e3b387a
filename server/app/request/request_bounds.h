// Bounds what parsing a request allocates, by a scan of its bytes before parsing.
#pragma once

#include <string_view>

#include "saccade/v1/control.pb.h"

namespace saccade {

// Counts the elements of repeated fields, the bytes of texts and those of unknown fields. Throws Refusal
// naming the first field that has too many, or where the bytes cannot be parsed. Linear in the bytes.
void checkBounds(std::string_view request);

// checkBounds(), then parses. Throws Refusal.
v1::Request parseRequest(std::string_view bytes);

}  // namespace saccade
