#include "app/request/request_bounds.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format.h>

#include <map>
#include <vector>

#include "app/request/refusal.h"
#include "reply/status.h"
#include "saccade/wire/ranges.h"

namespace saccade {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::internal::WireFormat;
using google::protobuf::internal::WireFormatLite;

struct Bound {
  const char* field;  // its full name
  std::int64_t most;
};

// The most elements of a repeated field, in the whole request.
constexpr Bound kElements[] = {
    {"saccade.v1.OpenStream.sensors", ranges::kSensors.max},
    {"saccade.v1.Distortion.coefficients", 5 * (1 + ranges::kFurtherViews.max)},
    {"saccade.v1.Keyframes.keys", ranges::kKeyframes.max},
    {"saccade.v1.Method.params", 64},
    {"saccade.v1.Quality.disabled_features", 64},
    {"saccade.v1.OpenStream.truth", ranges::kTruth.max},
    {"saccade.v1.OpenStream.further_views", ranges::kFurtherViews.max},
    {"saccade.v1.OpenStream.objects", ranges::kObjects.max},
    {"saccade.v1.Steer.objects", ranges::kObjects.max},
    {"saccade.v1.Sensor.changes", std::int64_t{ranges::kSensors.max} * ranges::kSensorChanges.max},
    {"saccade.v1.Truth.times_s", ranges::kTruthTimes.max}};
// The most bytes of a text that may be longer than a name.
constexpr Bound kTexts[] = {{"saccade.v1.Trajectory.csv", ranges::kMaxCsvBytes},
                            {"saccade.v1.ObjectPath.csv", ranges::kMaxCsvBytes}};
constexpr std::int64_t kMaxNameBytes = 256;
constexpr int kMaxUnknownBytes = 4 << 10;  // of fields of a newer schema

template <std::size_t N>
std::int64_t mostOf(const Bound (&bounds)[N], const FieldDescriptor& field, std::int64_t otherwise) {
  for (const Bound& bound : bounds) {
    if (field.full_name() == bound.field) return bound.most;
  }
  return otherwise;
}

class Scan {
 public:
  explicit Scan(std::string_view bytes)
      : in_(reinterpret_cast<const std::uint8_t*>(bytes.data()), static_cast<int>(bytes.size())) {
    in_.PushLimit(static_cast<int>(bytes.size()));
  }

  void read(const Descriptor& type) {
    while (const std::uint32_t tag = in_.ReadTag()) {
      const FieldDescriptor* field = type.FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
      const auto coding = WireFormatLite::GetTagWireType(tag);
      if (field && field->is_packable() && coding == WireFormatLite::WIRETYPE_LENGTH_DELIMITED) {
        readPacked(*field);
      } else if (field && coding == WireFormat::WireTypeForFieldType(field->type())) {
        readField(*field, tag);
      } else {
        skipUnknown(tag);
      }
    }
    if (!in_.ConsumedEntireMessage()) fail();
  }

 private:
  [[noreturn]] static void fail() { refuse({}, kNoRequest); }

  void readField(const FieldDescriptor& field, std::uint32_t tag) {
    path_.push_back(&field);
    if (field.is_repeated()) count(field, 1);
    if (field.type() == FieldDescriptor::TYPE_MESSAGE) {
      const auto outer = in_.PushLimit(readLength());
      read(*field.message_type());
      in_.PopLimit(outer);
    } else if (field.type() == FieldDescriptor::TYPE_STRING) {
      const int length = readLength();
      const std::int64_t most = mostOf(kTexts, field, kMaxNameBytes);
      if (length > most) refuse(path(), "the text is longer than " + std::to_string(most) + " bytes");
      if (!in_.Skip(length)) fail();
    } else if (!WireFormatLite::SkipField(&in_, tag)) {
      fail();
    }
    path_.pop_back();
  }

  // Numbers without tags between them. Such a number of the schema is a double.
  void readPacked(const FieldDescriptor& field) {
    path_.push_back(&field);
    const int length = readLength();
    count(field, length / static_cast<int>(sizeof(double)));
    if (!in_.Skip(length)) fail();
    path_.pop_back();
  }

  // A length beyond the bytes that are left is a fault of the message.
  int readLength() {
    int length = 0;
    if (!in_.ReadVarintSizeAsInt(&length) || length > in_.BytesUntilLimit()) fail();
    return length;
  }

  void count(const FieldDescriptor& field, std::int64_t elements) {
    const std::int64_t most = mostOf(kElements, field, 0);
    if ((elements_[&field] += elements) > most) refuse(path(), "there are more than " + std::to_string(most));
  }

  void skipUnknown(std::uint32_t tag) {
    const int from = in_.CurrentPosition();
    const bool group = WireFormatLite::GetTagWireType(tag) == WireFormatLite::WIRETYPE_START_GROUP;
    if (group || !WireFormatLite::SkipField(&in_, tag)) fail();
    unknown_bytes_ += in_.CurrentPosition() - from + 1;
    if (unknown_bytes_ > kMaxUnknownBytes)
      refuse(path(), "more than " + std::to_string(kMaxUnknownBytes) + " bytes of unknown fields");
  }

  // The path for refusals, without the call.
  std::string path() const {
    std::string text;
    for (std::size_t i = 1; i < path_.size(); ++i) text += (i > 1 ? "." : "") + path_[i]->name();
    return text;
  }

  google::protobuf::io::CodedInputStream in_;
  std::vector<const FieldDescriptor*> path_;
  std::map<const FieldDescriptor*, std::int64_t> elements_;
  int unknown_bytes_ = 0;
};

}  // namespace

void checkBounds(std::string_view request) {
  Scan scan(request);
  scan.read(*v1::Request::descriptor());
}

v1::Request parseRequest(std::string_view bytes) {
  checkBounds(bytes);
  v1::Request request;
  if (!request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) refuse({}, kNoRequest);
  return request;
}

}  // namespace saccade
