#include "ops/client_log.h"

#include <spdlog/spdlog.h>

#include <algorithm>

namespace saccade {
namespace {

constexpr std::size_t kMaxAccounts = 4096;

}  // namespace

std::optional<std::uint64_t> LogLimit::ask(const std::string& client, Clock::time_point now) {
  if (accounts_.size() >= kMaxAccounts) forgetQuietOnes(now);
  Account& account = accounts_[client];
  account.paid_until = std::max(account.paid_until, now - kBurst * kPause);
  if (account.paid_until + kPause > now) {
    ++account.held;
    return std::nullopt;
  }
  account.paid_until += kPause;
  return std::exchange(account.held, 0);
}

void LogLimit::forgetQuietOnes(Clock::time_point now) {
  std::erase_if(accounts_, [&](const auto& entry) {
    return entry.second.held == 0 && entry.second.paid_until <= now - kBurst * kPause;
  });
}

void ClientLog::info(const std::string& client, const std::string& line) {
  std::unique_lock lock(mutex_);
  const auto held = limit_.ask(client, LogLimit::Clock::now());
  lock.unlock();
  if (!held) return;
  const std::string name = client.empty() ? "client" : "client " + client.substr(0, 8);
  if (*held > 0) spdlog::warn("{}: {} lines were held back", name, *held);
  spdlog::info("{}: {}", name, line);
}

}  // namespace saccade
