// PendingOpens are seen and ended by their owners alone.
#include "app/streams/pending_opens.h"

#include <gtest/gtest.h>

#include "base/tile_pool.h"

namespace saccade {
namespace {

const Peer kAlice{"1", "alice"}, kAliceToo{"2", "alice"}, kBob{"3", "bob"}, kNobody{"4", ""}, kOther{"5", ""};

const ClientLog kNames([](const std::string& key) { return key == "alice" ? "Alice" : ""; });

auto list(const PendingOpens& all, const Peer& peer) {
  return all.list(peer, false, kNames);
}

TEST(PendingOpens, AreListedToTheirOwnerUntilTheyGo) {
  PendingOpens all;
  auto one = all.add(kAlice, 7);
  all.setScene(*one, std::string(100, 'x'));
  all.begin(*one, "waiting");
  ASSERT_EQ(list(all, kAlice).size(), 1u);
  EXPECT_EQ(list(all, kAlice)[0].request_id(), 7u);
  EXPECT_EQ(list(all, kAlice)[0].scene(), std::string(64, 'x') + "...");
  EXPECT_EQ(list(all, kAlice)[0].doing(), "waiting");
  all.setDone(*one, 0.25);
  EXPECT_EQ(list(all, kAlice)[0].done(), 0.25);
  all.begin(*one, "doing another thing");
  EXPECT_EQ(list(all, kAlice)[0].done(), 0);
  EXPECT_TRUE(list(all, kBob).empty());
  one.reset();
  EXPECT_TRUE(list(all, kAlice).empty());
}

TEST(PendingOpens, OfAllAreListedToAnAdminWhoAsksForThem) {
  PendingOpens all;
  const auto one = all.add(kAlice, 7);
  const Peer admin{"6", "carol", true};
  EXPECT_TRUE(list(all, admin).empty());
  EXPECT_TRUE(all.list(kBob, true, kNames).empty());
  ASSERT_EQ(all.list(admin, true, kNames).size(), 1u);
  EXPECT_EQ(all.list(admin, true, kNames)[0].client(), "Alice");
}

TEST(PendingOpens, AreCancelledByTheirConnectionOrKey) {
  PendingOpens all;
  const auto one = all.add(kAlice, 7), other = all.add(kNobody, 7);
  EXPECT_FALSE(all.cancel(kBob, 7));
  EXPECT_FALSE(all.cancel(kOther, 7));  // without keys nobody is the same client
  EXPECT_FALSE(all.cancel(kAlice, 8));
  EXPECT_NO_THROW(all.begin(*one, "going on"));
  EXPECT_TRUE(all.cancel(kAliceToo, 7));
  EXPECT_THROW(all.begin(*one, "going on"), Cancelled);
  EXPECT_FALSE(all.cancel(kAlice, 7));  // it is already
  EXPECT_NO_THROW(all.begin(*other, "going on"));
  EXPECT_TRUE(all.cancel(kNobody, 7));
  EXPECT_TRUE(other->stop.stop_requested());
}

TEST(PendingOpens, EndWithTheirConnection) {
  PendingOpens all;
  const auto gone = all.add(kAlice, 7), also = all.add(kAlice, 8), stays = all.add(kAliceToo, 7);
  all.cancelAllOf(kAlice.connection);
  EXPECT_TRUE(gone->stop.stop_requested() && also->stop.stop_requested());
  EXPECT_FALSE(stays->stop.stop_requested());
  all.cancelAll();
  EXPECT_TRUE(stays->stop.stop_requested());
}

}  // namespace
}  // namespace saccade
