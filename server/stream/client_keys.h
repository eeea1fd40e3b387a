// The list of public keys of clients that may connect.
#pragma once

#include <mutex>
#include <set>
#include <string>

namespace saccade {

// Read from a file with one key in each line, optionally followed by a name. Empty lines, and lines whose
// first word is "#", are ignored.
class ClientKeys {
 public:
  explicit ClientKeys(const std::string& path);  // throws std::runtime_error naming file and line

  // Reads the file again. Throws as the constructor does, and then keeps the old list.
  void reload();
  bool allow(const std::string& key) const;  // from any thread
  std::size_t size() const;

 private:
  const std::string path_;
  mutable std::mutex mutex_;
  std::set<std::string> keys_;
};

}  // namespace saccade
