// The streams that are being opened, for their owners to list and to cancel.
#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "log/client_log.h"
#include "stream/change_notifier.h"
#include "stream/control_server.h"

namespace saccade {

struct PendingOpen {
  const Peer peer;
  const std::uint64_t request_id;
  const ChangeNotifier::Clock::time_point began = ChangeNotifier::Clock::now();
  std::stop_source stop{};
  std::string scene{};                        // empty until the request is read
  const char* doing = "reading the request";  // for people
  double done = 0;                            // of that step
};

// All members may be called from any thread.
class PendingOpens {
 public:
  // Adds an opening, which is listed until it is destroyed. This must outlive it.
  std::shared_ptr<PendingOpen> add(const Peer& peer, std::uint64_t request_id);
  void setScene(PendingOpen& opening, const std::string& scene);
  // Notes the next step. Throws Cancelled where the opening was cancelled.
  void begin(PendingOpen& opening, const char* doing);
  void setDone(PendingOpen& opening, double share);  // of that step

  // Those of a client, or of all, as StreamRegistry::list() has it.
  std::vector<v1::OpeningInfo> list(const Peer& peer, bool all, const ClientLog& names) const;
  bool cancel(const Peer& peer, std::uint64_t request_id);  // false: there is none; see CancelOpen
  void cancelAllOf(const std::string& connection);
  void cancelAll();

 private:
  template <class Mine>
  bool cancelWhere(Mine mine);

  mutable std::mutex mutex_;
  std::set<PendingOpen*> all_;
};

}  // namespace saccade
