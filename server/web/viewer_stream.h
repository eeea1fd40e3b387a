// A stream that a viewer watches: its packets, as frames of a WebSocket.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "saccade/socket.h"
#include "saccade/v1/viewer.pb.h"
#include "web/connection_watch.h"
#include "web/web_socket.h"

namespace saccade {

class ViewerStream {
 public:
  static constexpr std::uint64_t kCredit = 1 << 20;     // bytes that the server may send ahead
  static constexpr std::size_t kMostPayload = 4 << 20;  // bytes; a larger packet ends it

  // Where the server's packets come from, and with which keys.
  struct Source {
    std::string data, broadcast;  // endpoints
    client::CurveKeys keys;
  };
  ViewerStream(zmq::context_t& context, const Source& source, const v1::Attach& attach);
  ViewerStream(zmq::context_t& context, const Source& source, const v1::Subscribe& subscribe);

  void* handle() { return socket_.handle(); }  // as zmq_poll() takes it

  // Queues the packets that have come; null: takes them for nobody. Tells the page of one that is too large,
  // which ends the stream. A broadcast has no credit: its packets are dropped while `viewer` is full, and the
  // page sees the gap of their seq.
  void forwardTo(WebSocket* viewer);
  // Gives back the credit of what was forwarded. Call it when that has been written.
  void giveBack();
  bool broadcast() const { return !has_credit_; }
  bool ended() const { return ended_; }  // END, or an error, has come
  // Whether the server has forgotten what was attached. A broadcast is subscribed to again by itself.
  bool lost() { return attached_ && attached_->lost(); }

 private:
  void note(const zmq::message_t& header);
  void refuse(WebSocket& viewer, std::size_t bytes);
  void send(const v1::DataRequest& request);
  void giveCredit(std::uint64_t bytes);

  zmq::socket_t socket_;
  std::optional<ConnectionWatch> attached_;
  bool has_credit_;
  bool ended_ = false, refused_ = false;
  std::uint64_t used_ = 0;  // bytes forwarded since credit was last given
};

}  // namespace saccade
