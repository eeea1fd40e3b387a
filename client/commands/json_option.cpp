#include "client/commands/json_option.h"

#include <google/protobuf/util/json_util.h>

#include <stdexcept>

#include "client/terminal/console.h"

namespace saccade::client {

void addJsonOption(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "print one JSON object, whose keys are the fields of control.proto");
}

void printJson(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string text;
  if (!google::protobuf::util::MessageToJsonString(message, &text, options).ok())
    throw std::runtime_error("the reply of the server has no JSON form");
  print("%s", text.c_str());
}

}  // namespace saccade::client
