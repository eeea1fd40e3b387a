// One part of a ZeroMQ message.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace saccade {

struct MessagePart {
  MessagePart() = default;
  MessagePart(std::string_view bytes) : bytes(bytes) {}  // the caller's
  MessagePart(const std::string& bytes) : bytes(bytes) {}
  MessagePart(std::shared_ptr<const std::string> text) : bytes(*text), owner(std::move(text)) {}
  MessagePart(std::string_view bytes, std::shared_ptr<const void> owner)
      : bytes(bytes), owner(std::move(owner)) {}

  std::string_view bytes;
  std::shared_ptr<const void> owner;  // keeps `bytes`; empty where the caller does
};

}  // namespace saccade
