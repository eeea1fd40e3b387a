// The list of clients that may connect: their public keys, names and rights.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace saccade {

struct ListedClient {
  std::string name;    // empty: it has none
  bool admin = false;  // may see and close the streams of all clients
};

// Counts of all clients of one name, since the name came onto the list.
struct ClientCounts {
  std::atomic<std::uint64_t> sent_bytes = 0;  // headers and payloads of the packets of their streams
  std::atomic<std::uint64_t> refusals = 0;    // answers to requests with another code than CODE_OK
};

// Read from a file with a line KEY [NAME [admin]] for each client. The word "#" begins a remark. Several keys
// may have one name. All members may be called from any thread.
class ClientKeys {
 public:
  static constexpr std::size_t kMaxNameBytes = 64;
  using CountsByName = std::map<std::string, std::shared_ptr<ClientCounts>>;

  explicit ClientKeys(const std::string& path);  // throws std::runtime_error naming file and line

  // Reads the file again. Throws as the constructor does, and then keeps the old list.
  void reload();
  bool allow(const std::string& key) const;
  ListedClient find(const std::string& key) const;  // without a name and rights where it is not on the list
  std::size_t size() const;

  std::shared_ptr<ClientCounts> countsOf(const std::string& key) const;  // null: it has no name
  CountsByName counts() const;

  void countRefused() { ++refused_; }                 // a connection whose key is not on the list
  std::uint64_t refused() const { return refused_; }  // such connections so far

 private:
  const std::string path_;
  mutable std::mutex mutex_;
  std::map<std::string, ListedClient> clients_;  // by key
  CountsByName counts_;
  std::atomic<std::uint64_t> refused_ = 0;
};

}  // namespace saccade
