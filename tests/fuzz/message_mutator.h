// Changes of a message by its fields: changes of its bytes rarely reach deep.
#pragma once

#include <google/protobuf/message.h>
#include <google/protobuf/text_format.h>

#include <string>
#include <vector>

#include "base/check.h"
#include "fuzz/draws.h"

namespace saccade {

// One change: a field, at any depth, is cleared, set to an odd value, or repeated once more, less, or
// elsewhere. `words`: for texts.
void mutateMessage(google::protobuf::Message& message, const std::vector<std::string>& words, Draws& draw);

// FuzzTarget::mutate of a serialized M. Bytes that are none become an empty one.
template <class M>
std::string mutateBytesOf(const std::string& bytes, const std::vector<std::string>& words, Draws& draw) {
  M message;
  if (!message.ParseFromString(bytes)) message.Clear();
  mutateMessage(message, words, draw);
  return message.SerializeAsString();
}

// A serialized M from its text format.
template <class M>
std::string bytesOf(const std::string& text) {
  M message;
  SACCADE_CHECK(google::protobuf::TextFormat::ParseFromString(text, &message));
  return message.SerializeAsString();
}

}  // namespace saccade
