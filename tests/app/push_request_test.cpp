#include "app/request/push_request.h"

#include <gtest/gtest.h>

#include "app/request/refusal.h"
#include "saccade/v1/control.pb.h"

namespace saccade {
namespace {

std::string request(const std::string& intensity) {
  v1::Request request;
  request.set_request_id(7);
  request.set_protocol_version(1);
  request.mutable_push_frame()->set_stream_id("a stream");
  request.mutable_push_frame()->set_token("a token");
  request.mutable_push_frame()->set_intensity(intensity);
  return request.SerializeAsString();
}

TEST(PushRequest, IsReadWithoutACopyOfItsFrame) {
  const std::string frame(1 << 20, 'x'), bytes = request(frame);
  const PushRequest push = readPush(bytes);
  EXPECT_EQ(push.stream_id, "a stream");
  EXPECT_EQ(push.token, "a token");
  EXPECT_EQ(push.intensity, frame);
  EXPECT_GE(push.intensity.data(), bytes.data());
  EXPECT_LE(push.intensity.data() + push.intensity.size(), bytes.data() + bytes.size());
}

// The parser of the schema does the same.
TEST(PushRequest, TheLastOfEqualFieldsCounts) {
  const std::string bytes = request("first") + request("last");
  v1::Request parsed;
  ASSERT_TRUE(parsed.ParseFromString(bytes));
  EXPECT_EQ(readPush(bytes).intensity, parsed.push_frame().intensity());
}

TEST(PushRequest, RefusesWhatIsNoMessage) {
  const std::string whole = request("0123456789");
  for (std::size_t size = 1; size < whole.size(); ++size) {
    v1::Request parsed;
    if (parsed.ParseFromString(whole.substr(0, size))) continue;
    EXPECT_THROW(readPush(whole.substr(0, size)), Refusal) << size;
  }
  EXPECT_THROW(readPush("\xff\xff\xff"), Refusal);
}

}  // namespace
}  // namespace saccade
