// The content of the packets of one sensor or truth channel.
#pragma once

#include <gtest/gtest.h>

#include "mock/mock_subscriber.h"

namespace saccade {

template <class Item>
std::vector<Item> itemsOf(const Packets& packets, std::vector<Item> PacketContent::*items) {
  std::vector<Item> all;
  for (const Received& packet : packets) {
    PacketContent content;
    EXPECT_EQ(decodePacket(packet.header, packet.payload, content), "");
    all.insert(all.end(), (content.*items).begin(), (content.*items).end());
  }
  return all;
}

inline Events eventsOf(const Packets& packets) {
  return itemsOf(packets, &PacketContent::events);
}

inline TruthSamples samplesOf(const Packets& packets) {
  return itemsOf(packets, &PacketContent::truth);
}

}  // namespace saccade
