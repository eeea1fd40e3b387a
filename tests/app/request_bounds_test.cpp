// The results of a request are counted before they are made.
#include "app/request/request_bounds.h"

#include <gtest/gtest.h>

#include <set>

#include "app/request/refusal.h"
#include "saccade/wire/protocol.h"
#include "saccade/wire/ranges.h"
#include "stream/raw_request.h"

namespace saccade {
namespace {

std::string varint(std::size_t value) {
  std::string bytes;
  for (; value >= 128; value >>= 7) bytes += static_cast<char>(value | 128);
  return bytes + static_cast<char>(value);
}

// A field of bytes: a message, a text, or what a newer client may mean by it.
std::string field(int number, const std::string& value) {
  return varint(static_cast<std::size_t>(number) << 3 | 2) + varint(value.size()) + value;
}

std::string times(std::size_t count, const std::string& bytes) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += bytes;
  return all;
}

std::string opening(const std::string& rest) {
  return field(v1::Request::kOpenStreamFieldNumber, rest);
}
std::string keys(std::size_t count) {
  return field(3, field(3, times(count, field(2, ""))));
}

struct Case {
  std::string bytes, field;
};

void expectRefused(const std::string& bytes, const std::string& at) {
  try {
    checkBounds(bytes);
    FAIL() << at;
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.code, v1::CODE_INVALID_ARGUMENT);
    EXPECT_EQ(refusal.field, at) << refusal.what();
  }
}

TEST(RequestBounds, NameTheFieldThatHasTooMuch) {
  constexpr std::size_t kMany = 1'000'000;
  const std::vector<Case> cases{
      {opening(times(kMany, field(7, ""))), "sensors"},
      {opening(keys(ranges::kKeyframes.max + 1)), "trajectory.keyframes.keys"},
      {opening(keys(ranges::kKeyframes.max) + keys(1)), "trajectory.keyframes.keys"},
      {opening(field(5, times(65, field(3, "")))), "method.params"},
      {opening(field(2, field(5, field(2, std::string(41 * 8, 0))))), "view.distortion.coefficients"},
      {opening(field(2, field(5, times(41, "\x11" + std::string(8, 0))))), "view.distortion.coefficients"},
      {opening(field(5, field(3, field(1, std::string(300, 'x'))))), "method.params.key"},
      {opening(field(6, times(kMany, field(5, "")))), "quality.disabled_features"},
      {opening(field(1, std::string(257, 'x'))), "scene"},
      {opening(field(3, field(4, std::string((8 << 20) + 1, ' ')))), "trajectory.csv"},
      {opening(times(65, field(14, ""))), "objects"},
      {opening(field(14, field(1, std::string(257, 'x')))), "objects.name"},
      {opening(field(14, field(2, field(3, std::string((8 << 20) + 1, ' '))))), "objects.path.csv"},
      {opening(times(kMany, field(99, ""))), ""},
      {opening(times(kMany, field(9, ""))), ""},  // the seed is a number
      {field(12, field(1, std::string(257, 'x'))), "stream_id"},
  };
  for (const auto& [bytes, at] : cases) expectRefused(bytes, at);
}

TEST(RequestBounds, RefuseWhatIsNoMessage) {
  const std::string good = opening(field(1, "cornell-box"));
  for (std::size_t left = 1; left < good.size(); ++left) expectRefused(good.substr(0, left), "");
  expectRefused(opening("\x0b\x0c"), "");  // a group
  expectRefused(opening(std::string("\0\0", 2)), "");
  expectRefused(std::string(20, '\xff'), "");
}

TEST(RequestBounds, LetThroughAsMuchAsMayBe) {
  v1::Request request;
  v1::OpenStream& open = *request.mutable_open_stream();
  open.set_scene(std::string(256, 'x'));
  for (int i = 0; i < ranges::kSensors.max; ++i) open.add_sensors()->set_threshold(0.1);
  for (int i = 0; i < ranges::kKeyframes.max; ++i)
    open.mutable_trajectory()->mutable_keyframes()->add_keys()->set_time_s(i);
  for (int i = 0; i < 64; ++i) open.mutable_quality()->add_disabled_features("textures");
  for (int i = 0; i < 64; ++i) (*open.mutable_method()->mutable_params())[std::to_string(i)] = i;
  const std::string newer = field(99, std::string(4000, 'x'));
  EXPECT_NO_THROW(checkBounds(request.SerializeAsString() + opening(newer)));
  v1::Request long_text;
  long_text.mutable_open_stream()->mutable_trajectory()->set_csv(std::string(ranges::kMaxCsvBytes, ' '));
  EXPECT_NO_THROW(checkBounds(long_text.SerializeAsString()));
}

// Every field that could hold any number of elements is in the table.
void expectBounded(const google::protobuf::Descriptor& type, const std::vector<int>& path,
                   std::set<std::string>& seen) {
  if (!seen.insert(type.full_name()).second) return;
  for (int i = 0; i < type.field_count(); ++i) {
    const auto& one = *type.field(i);
    SCOPED_TRACE(one.full_name());
    if (one.is_repeated()) {
      EXPECT_TRUE(!one.is_packable() || one.type() == one.TYPE_DOUBLE) << "packed numbers count as doubles";
      std::string bytes = field(one.number(), "");
      for (auto outer = path.rbegin(); outer != path.rend(); ++outer) bytes = field(*outer, bytes);
      EXPECT_NO_THROW(checkBounds(bytes)) << "it has no bound, and so may not come at all";
    }
    std::vector<int> inner = path;
    inner.push_back(one.number());
    if (one.message_type()) expectBounded(*one.message_type(), inner, seen);
  }
}

TEST(RequestBounds, KnowEveryRepeatedField) {
  std::set<std::string> seen;
  expectBounded(*v1::Request::descriptor(), {}, seen);
  EXPECT_EQ(seen.count("saccade.v1.Keyframe"), 1u);
}

RawRequest headOf(const std::string& bytes, v1::Code expected) {
  RawRequest raw{.message = std::make_shared<const std::string>(bytes)};
  EXPECT_EQ(readHead(raw).code(), expected);
  return raw;
}

TEST(RequestHead, IsReadWithoutTheRest) {
  v1::Request request;
  request.set_request_id(~0ull);
  request.set_protocol_version(kProtocolVersion);
  const std::string head = request.SerializeAsString();
  const RawRequest raw = headOf(head + opening("no message at all"), v1::CODE_OK);
  EXPECT_EQ(raw.id, ~0ull);
  EXPECT_EQ(raw.call, v1::Request::kOpenStream);
  headOf(head, v1::CODE_UNIMPLEMENTED);
  headOf(opening(""), v1::CODE_UNIMPLEMENTED);
  headOf(head + field(12, std::string(5000, 'x')), v1::CODE_INVALID_ARGUMENT);  // close_stream is short
  headOf(head + times(1'000'000, "\x08\x01"), v1::CODE_INVALID_ARGUMENT);
  headOf(head + opening("x").substr(0, 2), v1::CODE_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace saccade
