#include "stream/raw_request.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include <string>
#include <string_view>

#include "reply/status.h"
#include "saccade/wire/protocol.h"

namespace saccade {
namespace {

using google::protobuf::internal::WireFormatLite;

constexpr int kMaxFields = 16;  // of the request itself; a good one has three: id, version and call

// False where the bytes are no message, or one of too many fields.
bool readFields(google::protobuf::io::CodedInputStream& in, RawRequest& raw) {
  for (int i = 0; i <= kMaxFields; ++i) {
    const std::uint32_t tag = in.ReadTag();
    if (tag == 0) return in.ConsumedEntireMessage();
    std::uint64_t number = 0;
    const int field = WireFormatLite::GetTagFieldNumber(tag);
    switch (WireFormatLite::GetTagWireType(tag)) {
      case WireFormatLite::WIRETYPE_VARINT:
        if (!in.ReadVarint64(&number)) return false;
        if (field == v1::Request::kRequestIdFieldNumber) raw.id = number;
        if (field == v1::Request::kProtocolVersionFieldNumber)
          raw.version = static_cast<std::uint32_t>(number);
        break;
      case WireFormatLite::WIRETYPE_LENGTH_DELIMITED: {
        const auto* known = v1::Request::descriptor()->FindFieldByNumber(field);
        if (known && known->containing_oneof()) raw.call = static_cast<v1::Request::CallCase>(field);
        if (!WireFormatLite::SkipField(&in, tag)) return false;
        break;
      }
      default:
        return false;
    }
  }
  return false;
}

}  // namespace

v1::Status readHead(RawRequest& raw) {
  const std::string_view bytes = raw.message.bytes;
  google::protobuf::io::CodedInputStream in(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                            static_cast<int>(bytes.size()));
  if (!readFields(in, raw)) return makeStatus(v1::CODE_INVALID_ARGUMENT, kNoRequest);
  if (raw.version != kProtocolVersion) {
    return makeStatus(v1::CODE_UNIMPLEMENTED,
                      "protocol_version is " + std::to_string(raw.version) + "; this server knows " +
                          std::to_string(kProtocolVersion),
                      "protocol_version");
  }
  if (raw.call == v1::Request::CALL_NOT_SET) {
    return makeStatus(v1::CODE_UNIMPLEMENTED, "the request holds no call that this server knows", "call");
  }
  const bool may_be_long = raw.call == v1::Request::kOpenStream || raw.call == v1::Request::kPushFrame;
  const std::size_t most = raw.call == v1::Request::kSteer ? kMaxSteerRequest : kMaxShortRequest;
  if (!may_be_long && bytes.size() > most) {
    return makeStatus(v1::CODE_INVALID_ARGUMENT,
                      "only open_stream and push_frame may take more than " + std::to_string(most) + " bytes",
                      "call");
  }
  return okStatus();
}

}  // namespace saccade
