// Log lines that clients cause, limited so that no client can fill the log.
#pragma once

#include <spdlog/common.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace saccade {

inline constexpr std::size_t kMaxLineBytes = 1000;

// Lets each client cause kBurst lines at once, and then one in each kPause.
class LogLimit {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kBurst = 50;
  static constexpr std::chrono::milliseconds kPause{200};

  static constexpr std::size_t kMaxAccounts = 4096;  // beyond these, clients share one

  // Asks to write a line now. Returns how many lines of this client were held back since its last one, or
  // nothing if this one must be held back too.
  std::optional<std::uint64_t> ask(const std::string& client, Clock::time_point now);
  // How many lines were held back of clients that have been forgotten since the last call.
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
  using NameOf = std::function<std::string(const std::string& key)>;  // empty: it has none

  // `name_of`: the names of public keys.
  explicit ClientLog(NameOf name_of = [](const std::string&) { return std::string(); })
      : name_of_(std::move(name_of)) {}

  // Logs a line, cut if it is long. `client`: a public key; empty without keys, where all clients share one
  // account. From any thread.
  void info(const std::string& client, const std::string& line);
  void error(const std::string& client, const std::string& line);
  // The name of a client, or else the first 8 characters of its key.
  std::string nameOf(const std::string& client) const;

 private:
  void write(spdlog::level::level_enum level, const std::string& client, const std::string& line);

  const NameOf name_of_;
  std::mutex mutex_;
  LogLimit limit_;
};

}  // namespace saccade
