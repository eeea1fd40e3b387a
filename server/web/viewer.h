// One viewer: relays between the WebSocket of a page and the sockets of this server, as a client of them.
#pragma once

#include <chrono>
#include <list>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "web/connection_watch.h"
#include "web/viewer_stream.h"
#include "web/web_socket.h"

namespace saccade {

class Viewer {
 public:
  static constexpr std::size_t kMaxStreams = 4;  // that it has joined; one more leaves the oldest
  // Joins: each takes a socket. More than kMaxStreams at once, and then one in this time, are refused.
  static constexpr std::chrono::milliseconds kJoinPause{100};
  static constexpr int kMaxInFlight = 16;  // requests that are not answered yet; one more is refused

  Viewer(UpgradedSocket socket, zmq::context_t& context, const std::string& control,
         const ViewerStream::Source& source);

  // Until the page has gone, or `stopped`, or a connection to the server's own sockets is lost; the page is
  // told. Then closes the streams that the page opened.
  void run(std::stop_token stopped);

 private:
  void waitForStreams(std::vector<zmq::pollitem_t> others);
  void take(std::string_view text);
  bool connectionLost();
  bool mayJoin();
  template <class Join>
  void join(const Join& join);
  void request(v1::Request request);
  void refuse(std::uint64_t request_id, v1::Code code, const std::string& message);
  void forwardReplies();
  void note(const v1::Reply& reply);
  void giveBack();
  void leave();

  zmq::context_t& context_;
  const ViewerStream::Source& source_;
  WebSocket page_;
  zmq::socket_t control_;
  ConnectionWatch control_watch_;
  std::list<ViewerStream> streams_;
  std::chrono::steady_clock::time_point next_join_;
  int in_flight_ = 0;
  std::map<std::string, std::string> opened_;  // tokens of the page's streams, by id
};

}  // namespace saccade
