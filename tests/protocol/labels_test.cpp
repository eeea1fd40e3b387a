// Labels of events, and events that are withheld as likely artefacts.
#include <gtest/gtest.h>

#include "mock/bad_request.h"
#include "mock/events_of.h"

namespace saccade {
namespace {

// Without labels, with them, and with a bound.
v1::OpenStream threeSensors() {
  v1::OpenStream request = tinyRequest();
  request.mutable_sensors(0)->set_seed(5);
  *request.add_sensors() = request.sensors(0);
  *request.add_sensors() = request.sensors(0);
  request.mutable_sensors(1)->set_labels(true);
  request.mutable_sensors(2)->set_max_artefact_odds(0.1);
  return request;
}

TEST(Labels, AreBesideTheSameEvents) {
  TestServer server;
  auto packets = server.run(threeSensors());
  Events plain = eventsOf(packets[0]), labelled = eventsOf(packets[1]), kept = eventsOf(packets[2]);
  EXPECT_EQ(packets[1].front().header.layout(), v1::LAYOUT_LABELLED_COLUMNS);
  EXPECT_TRUE(std::any_of(labelled.begin(), labelled.end(), [](const Event& e) { return e.artefact > 0; }));
  EXPECT_TRUE(std::all_of(labelled.begin(), labelled.end(), [](const Event& e) { return e.source == 0; }));
  const auto likely = std::erase_if(labelled, [](const Event& e) { return e.artefact > 0.1 * 255; });
  EXPECT_GT(likely, 0u);
  for (Event& event : labelled) event.artefact = 0;
  EXPECT_EQ(kept, labelled);
  std::uint64_t counted = 0;
  for (const Received& packet : packets[2]) counted += packet.header.artefacts();
  EXPECT_EQ(counted, likely);
  EXPECT_EQ(plain.size(), kept.size() + likely);
}

TEST(Labels, OddsOutOfRangeAreRefused) {
  TestServer server;
  expectRefused(server, {{threeSensors(), [](auto& r) { r.mutable_sensors(2)->set_max_artefact_odds(1.5); },
                          v1::CODE_INVALID_ARGUMENT, "sensors[2].max_artefact_odds", "1.5"}});
}

}  // namespace
}  // namespace saccade
