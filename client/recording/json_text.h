// The JSON form of protobuf, with equal bytes for equal messages.
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace saccade::client {

// Fields have the names of the schema, and those without a value are there too. Entries of maps are in order,
// which protobuf itself does not promise. `lines`: on many lines, for people.
std::string jsonText(const google::protobuf::Message& message, bool lines);

}  // namespace saccade::client
