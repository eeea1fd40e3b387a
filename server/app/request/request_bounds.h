// Counts on the wire what parsing a request would make, before any of it is made: elements, texts, and fields
// that nobody knows.
#pragma once

#include <string_view>

#include "saccade/v1/control.pb.h"

namespace saccade {

// Throws Refusal naming the first field that has too much, or where the bytes cannot be parsed. Takes time in
// proportion to the bytes.
void checkBounds(std::string_view request);

// What checkBounds() lets through, parsed. Throws Refusal.
v1::Request parseRequest(std::string_view bytes);

}  // namespace saccade
