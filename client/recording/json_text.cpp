#include "client/recording/json_text.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/type_resolver.h>
#include <google/protobuf/util/type_resolver_util.h>

#include <memory>
#include <stdexcept>

namespace saccade::client {
namespace {

namespace pb = google::protobuf;

constexpr const char* kPrefix = "type.googleapis.com";

std::string inOrder(const pb::Message& message) {
  std::string bytes;
  pb::io::StringOutputStream text(&bytes);
  pb::io::CodedOutputStream out(&text);
  out.SetSerializationDeterministic(true);
  message.SerializeToCodedStream(&out);
  out.Trim();
  return bytes;
}

}  // namespace

// JSON of bytes has the order of the bytes, and that of a message has the order of its hash tables.
std::string jsonText(const pb::Message& message, bool lines) {
  static const std::unique_ptr<pb::util::TypeResolver> types(
      pb::util::NewTypeResolverForDescriptorPool(kPrefix, pb::DescriptorPool::generated_pool()));
  pb::util::JsonPrintOptions options;
  options.add_whitespace = lines;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string text;
  const std::string type = std::string(kPrefix) + "/" + message.GetDescriptor()->full_name();
  if (!pb::util::BinaryToJsonString(types.get(), type, inOrder(message), &text, options).ok())
    throw std::logic_error("a message has no JSON form");
  return text;
}

}  // namespace saccade::client
