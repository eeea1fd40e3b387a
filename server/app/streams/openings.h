// The streams that are being opened: their owners see them, and cancel them.
#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "stream/change_notifier.h"
#include "stream/control_server.h"

namespace saccade {

struct Opening {
  const Peer peer;
  const std::uint64_t request_id;
  const ChangeNotifier::Clock::time_point began = ChangeNotifier::Clock::now();
  std::stop_source stop{};
  std::string scene{};                        // empty until the request is read
  const char* doing = "reading the request";  // for people
};

// All members may be called from any thread.
class Openings {
 public:
  // Is one of them until it goes. This must outlive it.
  std::shared_ptr<Opening> add(const Peer& peer, std::uint64_t request_id);
  void setScene(Opening& opening, const std::string& scene);
  // Says what comes next. Throws Cancelled where it shall not.
  void begin(Opening& opening, const char* doing);

  std::vector<v1::OpeningInfo> list(const std::string& user) const;  // what this one opens
  bool cancel(const Peer& peer, std::uint64_t request_id);           // see CancelOpen; false: there is none
  void cancelAllOf(const std::string& connection);
  void cancelAll();

 private:
  template <class Mine>
  bool cancelWhere(Mine mine);

  mutable std::mutex mutex_;
  std::set<Opening*> all_;
};

}  // namespace saccade
