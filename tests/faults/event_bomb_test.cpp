// A frame of very many events: their number is bounded before they are in memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "app/admission/limits.h"
#include "faults/event_bomb.h"
#include "mock/server_process.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

TEST(EventBomb, TakesNoMoreThanItsLimitAndTellsWhatIsMissing) {
  ServerProcess server;
  MockClient client(server.control());
  client.close(client.open(tinyRequest()));
  const Usage before = server.usage();
  const auto stream = client.open(eventBomb(24, 65536));
  MockSubscriber subscriber(server.data());
  subscriber.attach(stream);
  subscriber.giveCredit(1);
  Packets packets{subscriber.receive().value()};  // all that the client takes until the bomb is in memory
  const auto made = [&] { return client.streams().streams(0).events(); };
  const auto deadline = ChangeNotifier::Clock::now() + kPatience;
  while (made() == 0 && ChangeNotifier::Clock::now() < deadline) {
  }
  const double grown = static_cast<double>(server.usage().resident_bytes - before.resident_bytes);
  RecordProperty("grown_mib", std::to_string(grown / (1 << 20)));
  EXPECT_LT(grown / (1 << 20), 280);  // 800 of 14 million events
  const double most = Limits()[Limit::kEvents];
  subscriber.giveCredit(1 << 30);
  std::ranges::move(subscriber.receiveAll(1)[0], std::back_inserter(packets));
  std::uint64_t suppressed = 0;
  for (const Received& packet : packets) suppressed += packet.header.suppressed();
  EXPECT_EQ(stream.resolved().sensors(0).max_events_per_frame(), most);
  EXPECT_EQ(checkPackets(packets).events, most);
  EXPECT_GT(suppressed, most);
}

// A stream that is opened elsewhere again would not get the events it had.
TEST(EventBomb, AStreamThatWasAllowedMoreElsewhereIsRefused) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  *request.add_sensors() = request.sensors(0);
  const auto most = static_cast<std::uint64_t>(Limits()[Limit::kEvents]) / 2;
  request.mutable_sensors(1)->set_max_events_per_frame(most);
  EXPECT_EQ(server.client().open(request).resolved().sensors(1).max_events_per_frame(), most);
  request.mutable_sensors(1)->set_max_events_per_frame(most + 1);
  const v1::Status status = server.client().tryOpen(request);
  EXPECT_EQ(status.limit(), "events");
  EXPECT_EQ(status.field(), "sensors[1].max_events_per_frame");
}

}  // namespace
}  // namespace saccade
