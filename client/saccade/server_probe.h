// Checks an endpoint before use, and finds out why nothing answers there.
#pragma once

#include <string>

#include "saccade/control_client.h"

namespace saccade::client {

// Resolves the host of a tcp:// endpoint, which may take a DNS query. Throws std::invalid_argument for a port
// outside 1 to 65535 and for an unknown host. Other endpoints are left to ZeroMQ.
void checkEndpoint(const std::string& endpoint);

// One line that says what listens at the silent endpoint, if anything, and what to do. Takes up to 2 s.
std::string explainSilence(const NoAnswer& silence);

}  // namespace saccade::client
