#include "app/request/push_request.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include "app/request/request_bounds.h"
#include "saccade/v1/control.pb.h"

namespace saccade {
namespace {

using google::protobuf::internal::WireFormatLite;

// Calls f(number, bytes) for each text and message in a message that checkBounds() has passed.
template <class F>
void eachPart(std::string_view message, const F& f) {
  google::protobuf::io::CodedInputStream in(reinterpret_cast<const std::uint8_t*>(message.data()),
                                            static_cast<int>(message.size()));
  while (const std::uint32_t tag = in.ReadTag()) {
    if (WireFormatLite::GetTagWireType(tag) != WireFormatLite::WIRETYPE_LENGTH_DELIMITED) {
      WireFormatLite::SkipField(&in, tag);
      continue;
    }
    int length = 0;
    in.ReadVarintSizeAsInt(&length);
    f(WireFormatLite::GetTagFieldNumber(tag),
      message.substr(static_cast<std::size_t>(in.CurrentPosition()), static_cast<std::size_t>(length)));
    in.Skip(length);
  }
}

}  // namespace

PushRequest readPush(std::string_view request) {
  checkBounds(request);
  PushRequest push;
  const auto take = [&](int field, std::string_view value) {
    if (field == v1::PushFrame::kStreamIdFieldNumber) push.stream_id = value;
    if (field == v1::PushFrame::kTokenFieldNumber) push.token = value;
    if (field == v1::PushFrame::kIntensityFieldNumber) push.intensity = value;
  };
  eachPart(request, [&](int field, std::string_view call) {
    if (field == v1::Request::kPushFrameFieldNumber) eachPart(call, take);
  });
  return push;
}

}  // namespace saccade
