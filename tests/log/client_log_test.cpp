#include "log/client_log.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

using Clock = LogLimit::Clock;

// How many of `lines` at one time are written.
int written(LogLimit& limit, const std::string& client, int lines, Clock::time_point now) {
  int count = 0;
  for (int i = 0; i < lines; ++i) count += limit.ask(client, now).has_value();
  return count;
}

TEST(LogLimit, TakesABurstAndThenOneInEachPause) {
  LogLimit limit;
  const Clock::time_point start{};
  EXPECT_EQ(written(limit, "a", 1000, start), LogLimit::kBurst);
  EXPECT_EQ(written(limit, "a", 10, start + LogLimit::kPause), 1);
  EXPECT_EQ(written(limit, "a", 10, start + 4 * LogLimit::kPause), 3);
  EXPECT_EQ(written(limit, "a", 1000, start + std::chrono::hours(1)), LogLimit::kBurst);
}

TEST(LogLimit, TellsOnceHowManyWereHeld) {
  LogLimit limit;
  const Clock::time_point start{};
  written(limit, "a", LogLimit::kBurst + 7, start);
  EXPECT_EQ(limit.ask("a", start + 2 * LogLimit::kPause), 7u);
  EXPECT_EQ(limit.ask("a", start + 2 * LogLimit::kPause), 0u);
}

TEST(LogLimit, OneClientDoesNotSilenceAnother) {
  LogLimit limit;
  const Clock::time_point start{};
  written(limit, "a", 1000, start);
  EXPECT_EQ(written(limit, "b", 1000, start), LogLimit::kBurst);
}

// More clients than accounts are kept, all of them long quiet but one.
TEST(LogLimit, AccountsOfQuietClientsAreForgottenAndNoOthers) {
  LogLimit limit;
  const Clock::time_point start{};
  for (int i = 0; i < 10000; ++i) limit.ask("quiet " + std::to_string(i), start);
  const auto later = start + std::chrono::minutes(1);
  written(limit, "loud", 1000, later);
  limit.ask("another", later);
  EXPECT_EQ(written(limit, "loud", 10, later), 0);
}

// Names are free where there are no keys.
TEST(LogLimit, NewNamesWithoutEndShareAnAccount) {
  LogLimit limit;
  const Clock::time_point start{};
  int written = 0;
  for (int i = 0; i < 10000; ++i) written += limit.ask("name " + std::to_string(i), start).has_value();
  EXPECT_LE(written, static_cast<int>(LogLimit::kMaxAccounts) + LogLimit::kBurst);
}

TEST(LogLimit, CountsTheLinesHeldBackOfForgottenClients) {
  LogLimit limit;
  const Clock::time_point start{};
  written(limit, "loud", LogLimit::kBurst + 7, start);
  for (std::size_t i = 0; i < LogLimit::kMaxAccounts; ++i)
    limit.ask("name " + std::to_string(i), start + std::chrono::minutes(1));
  EXPECT_EQ(limit.takeForgotten(), 7u);
  EXPECT_EQ(limit.takeForgotten(), 0u);
}

TEST(ClientLog, NamesAClientOrElseBeginsItsKey) {
  const ClientLog log([](const std::string& key) { return key == "0123456789" ? "alice" : ""; });
  EXPECT_EQ(log.nameOf("0123456789"), "alice");
  EXPECT_EQ(log.nameOf("9876543210"), "98765432");
  EXPECT_EQ(log.nameOf(""), "");
}

}  // namespace
}  // namespace saccade
