// The events that the packets of one sensor carry.
#pragma once

#include <gtest/gtest.h>

#include "mock/mock_subscriber.h"

namespace saccade {

inline Events eventsOf(const Packets& packets) {
  Events all;
  for (const Received& packet : packets) {
    PacketContent content;
    EXPECT_EQ(decodePacket(packet.header, packet.payload, content), "");
    all.insert(all.end(), content.events.begin(), content.events.end());
  }
  return all;
}

}  // namespace saccade
