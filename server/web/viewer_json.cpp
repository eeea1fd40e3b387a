#include "web/viewer_json.h"

#include <google/protobuf/util/json_util.h>

namespace saccade {
namespace {

constexpr std::size_t kMostSaid = 200;  // bytes of a parser's complaint, which repeats the text

std::string shorten(std::string text) {
  if (text.size() > kMostSaid) text.resize(kMostSaid);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = ' ';
  return text;
}

}  // namespace

v1::ViewerMessage parseViewerMessage(std::string_view json) {
  v1::ViewerMessage message;
  const auto status = google::protobuf::util::JsonStringToMessage({json.data(), json.size()}, &message);
  if (!status.ok()) {
    throw BadViewerMessage("no JSON of a ViewerMessage: " + shorten(std::string(status.message())));
  }
  if (message.message_case() == v1::ViewerMessage::MESSAGE_NOT_SET)
    throw BadViewerMessage("a ViewerMessage has request, attach or subscribe");
  return message;
}

std::string toJson(const v1::Reply& reply) {
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(reply, &json, options);
  if (!status.ok()) throw std::runtime_error("a reply has no JSON: " + std::string(status.message()));
  return json;
}

}  // namespace saccade
