#include "stream/large_packets.h"

#include <gtest/gtest.h>

#include <vector>

namespace saccade {
namespace {

using Payload = std::shared_ptr<const std::string>;

Payload payload(std::size_t bytes) {
  return std::make_shared<const std::string>(bytes, 'x');
}

TEST(LargePackets, NoMoreThanSoManyAreHeld) {
  LargePackets packets;
  std::vector<Payload> held;
  for (int i = 0; i < kMostLargePackets; ++i) {
    held.push_back(packets.lend(payload(kLargePacket + 1)));
    ASSERT_TRUE(held.back());
    EXPECT_EQ(held.back()->size(), kLargePacket + 1);
  }
  const Payload next = payload(kLargePacket + 1);
  EXPECT_FALSE(packets.lend(next));
  EXPECT_TRUE(packets.lend(payload(kLargePacket)));  // small ones are not counted
  Payload copy = held.front();
  held.erase(held.begin());
  EXPECT_FALSE(packets.lend(next));  // the copy holds it
  copy.reset();
  EXPECT_EQ(packets.lend(next), next);
}

// A stream ends before a slow receiver has taken its last packet.
TEST(LargePackets, AHeldOneOutlivesItsStream) {
  Payload held;
  {
    LargePackets packets;
    held = packets.lend(payload(kLargePacket + 1));
  }
  EXPECT_EQ(held->back(), 'x');
}

}  // namespace
}  // namespace saccade
