// Who may connect: the list of clients' public keys.
#pragma once

#include <mutex>
#include <set>
#include <string>

namespace saccade {

// A file with one key in each line, and then perhaps a name for people. Empty lines, and those whose first
// word is "#", say nothing.
class ClientKeys {
 public:
  explicit ClientKeys(const std::string& path);  // throws std::runtime_error naming file and line

  // Reads the file again. Where that throws, as the constructor does, the list stays what it was.
  void reload();
  bool allow(const std::string& key) const;  // from any thread
  std::size_t size() const;

 private:
  const std::string path_;
  mutable std::mutex mutex_;
  std::set<std::string> keys_;
};

}  // namespace saccade
