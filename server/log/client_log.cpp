#include "log/client_log.h"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "base/text_cut.h"

namespace saccade {
namespace {

constexpr std::size_t kShortKey = 8;  // characters
const std::string kOthers;            // the name of no client that has one

}  // namespace

std::optional<std::uint64_t> LogLimit::ask(const std::string& client, Clock::time_point now) {
  Account& account = accountOf(client, now);
  account.paid_until = std::max(account.paid_until, now - kBurst * kPause);
  if (account.paid_until + kPause > now) {
    ++account.held;
    return std::nullopt;
  }
  account.paid_until += kPause;
  return std::exchange(account.held, 0);
}

LogLimit::Account& LogLimit::accountOf(const std::string& client, Clock::time_point now) {
  if (const auto found = accounts_.find(client); found != accounts_.end()) return found->second;
  if (accounts_.size() >= kMaxAccounts) forgetQuietOnes(now);
  return accounts_[accounts_.size() < kMaxAccounts ? client : kOthers];
}

void LogLimit::forgetQuietOnes(Clock::time_point now) {
  std::erase_if(accounts_, [&](const auto& entry) {
    if (entry.second.paid_until > now - kBurst * kPause) return false;
    forgotten_ += entry.second.held;
    return true;
  });
}

void ClientLog::info(const std::string& client, const std::string& line) {
  write(spdlog::level::info, client, line);
}

void ClientLog::error(const std::string& client, const std::string& line) {
  write(spdlog::level::err, client, line);
}

std::string ClientLog::nameOf(const std::string& client) const {
  const std::string name = name_of_(client);
  return name.empty() ? client.substr(0, kShortKey) : name;
}

void ClientLog::write(spdlog::level::level_enum level, const std::string& client, const std::string& line) {
  std::unique_lock lock(mutex_);
  const auto held = limit_.ask(client, LogLimit::Clock::now());
  const std::uint64_t forgotten = limit_.takeForgotten();
  lock.unlock();
  if (forgotten > 0) spdlog::warn("{} lines of clients that are quiet now were held back", forgotten);
  if (!held) return;
  const std::string name = client.empty() ? "client" : "client " + nameOf(client);
  if (*held > 0) spdlog::warn("{}: {} lines were held back", name, *held);
  spdlog::log(level, "{}: {}", name, cutText(line, kMaxLineBytes));
}

}  // namespace saccade
