// The texts of a viewer's WebSocket: the JSON mapping of Protobuf.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "saccade/v1/viewer.pb.h"

namespace saccade {

// A text of a page that is no ViewerMessage; what() says why.
struct BadViewerMessage : std::runtime_error {
  using runtime_error::runtime_error;
};

// Throws BadViewerMessage for a text that is no JSON of a ViewerMessage, or one without a message.
v1::ViewerMessage parseViewerMessage(std::string_view json);

// With fields that have their default. Throws std::runtime_error.
std::string toJson(const v1::Reply& reply);

}  // namespace saccade
