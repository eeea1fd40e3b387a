// The streams of this server, from the reply that opens one until it is closed or forgotten.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/feeds/pace.h"
#include "app/streams/stream.h"
#include "log/client_log.h"
#include "stream/control_server.h"
#include "stream/session_directory.h"

namespace saccade {

struct StreamCensus {
  std::map<std::string, int> running = {};     // streams that have not ended, by the name of their delivery
  std::map<std::string, int> running_of = {};  // the same by the key of their client; empty without keys
  double lag_s = 0;                            // of the stream with the largest lag
};

class StreamRegistry {
 public:
  using Lease = std::chrono::duration<double>;

  // Adds the session of each stream to `sessions` and removes it again. A stream without a receiver for
  // `lease` is ended. One that has ended is listed, and can be resumed, for as long.
  StreamRegistry(SessionDirectory& sessions, ClientLog& log, Lease lease)
      : sessions_(sessions), log_(log), lease_(lease) {}
  ~StreamRegistry();  // stops what is left

  void add(Stream stream);  // throws Refusal after stopAll()
  // A copy of the entry. Throws Refusal: there is none, or `token` is not its token.
  Stream find(const std::string& id, const std::string& token) const;
  // Calls `use` with the entry, under the lock. Throws as find().
  void with(const std::string& id, const std::string& token,
            const std::function<void(const Stream&)>& use) const;
  // The streams of a client; and those of all others too, where `all` is set and it is an admin.
  std::vector<v1::StreamInfo> list(const Peer& peer, bool all) const;
  StreamCensus census() const;
  PaceLoad load(const FeedRunner* feed) const;  // of all streams, and of those of `feed`

  // Ends the stream at its next frame, if it has not ended; what it has made is still sent. Throws as find().
  // The key that has opened the stream, and an admin, need no token.
  void close(const std::string& id, const std::string& token, const Peer& peer);
  // Ends streams without a receiver and forgets those that are over. To be called about once a second, and
  // where their places are wanted.
  void sweep(ChangeNotifier::Clock::time_point now);
  // Waits until all closed streams have ended, but no longer than to `deadline`.
  void awaitClosed(ChangeNotifier::Clock::time_point deadline) const;
  std::uint64_t forgotten() const { return forgotten_; }  // since the server started
  // Ends all streams, for good. Returns whether, before `deadline`, all packets were taken that had a
  // receiver.
  bool stopAll(ChangeNotifier::Clock::time_point deadline);

 private:
  bool abandoned(const Stream& stream, ChangeNotifier::Clock::time_point now) const;
  bool over(const Stream& stream, ChangeNotifier::Clock::time_point now) const;

  SessionDirectory& sessions_;
  ClientLog& log_;
  const Lease lease_;
  mutable std::mutex mutex_;
  std::map<std::string, Stream> streams_;  // by id
  bool stopped_ = false;
  std::atomic<std::uint64_t> forgotten_ = 0;
};

}  // namespace saccade
