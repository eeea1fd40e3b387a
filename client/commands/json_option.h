// The option --json: prints the server's reply for machines.
#pragma once

#include <google/protobuf/message.h>

#include <CLI/CLI.hpp>

namespace saccade::client {

void addJsonOption(CLI::App& command, bool& json);

// As one object, whose keys are the fields of the message, with the names of the schema. Empty fields are
// there too.
void printJson(const google::protobuf::Message& message);

}  // namespace saccade::client
