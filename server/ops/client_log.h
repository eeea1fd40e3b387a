// Lines of the log that clients cause: no client fills it.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace saccade {

// Each client may cause kBurst lines at once, and then one in each kPause.
class LogLimit {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kBurst = 50;
  static constexpr std::chrono::milliseconds kPause{200};

  static constexpr std::size_t kMaxAccounts = 4096;  // beyond these, clients share one

  // Whether a line may be written now: nothing, or how many were not since the last one.
  std::optional<std::uint64_t> ask(const std::string& client, Clock::time_point now);
  // How many lines were not written of clients that have been forgotten since the last call.
  std::uint64_t takeForgotten() { return std::exchange(forgotten_, 0); }

 private:
  struct Account {
    Clock::time_point paid_until = Clock::time_point::min();  // each line written costs kPause
    std::uint64_t held = 0;
  };
  Account& accountOf(const std::string& client, Clock::time_point now);
  void forgetQuietOnes(Clock::time_point now);

  std::map<std::string, Account> accounts_;
  std::uint64_t forgotten_ = 0;
};

class ClientLog {
 public:
  // `client` is a public key; empty where there are no keys: then all clients together are one. From any
  // thread. A long line is cut.
  void info(const std::string& client, const std::string& line);

 private:
  std::mutex mutex_;
  LogLimit limit_;
};

}  // namespace saccade
