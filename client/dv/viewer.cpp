#include "client/dv/viewer.h"

#include <sys/socket.h>

#include <cerrno>

namespace saccade::client::dv {

void Viewer::send(const std::shared_ptr<const Message>& message) {
  if (gone()) return;
  unsent_.push_back(message);
  unsent_bytes_ += message->bytes.size();
  unsent_events_ += message->events;
  write();
  if (unsent_bytes_ > backlog_ && !gone()) cut();
}

void Viewer::write() {
  while (pending() && !gone()) {
    const Message& message = *unsent_.front();
    const ssize_t sent = ::send(descriptor(), message.bytes.data() + begun_, message.bytes.size() - begun_,
                                MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (sent < 0) {
      state_ = State::kLeft;
      return;
    }
    begun_ += static_cast<std::size_t>(sent);
    unsent_bytes_ -= static_cast<std::size_t>(sent);
    if (begun_ < message.bytes.size()) return;
    sent_events_ += message.events;
    unsent_events_ -= message.events;
    begun_ = 0;
    unsent_.pop_front();
  }
}

void Viewer::read() {
  char ignored[4096];
  const ssize_t got = recv(descriptor(), ignored, sizeof ignored, MSG_DONTWAIT);
  const bool later = got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
  if (got <= 0 && !later && !gone()) state_ = State::kLeft;
}

std::string Viewer::farewell() const {
  const std::string sent = std::to_string(sent_events_) + " events were sent to it";
  if (state_ == State::kLeft) return peer() + " has left; " + sent;
  return peer() + " was too slow and is cut: " + sent + ", " + std::to_string(unsent_events_) +
         " more waited in " + std::to_string(unsent_bytes_) + " bytes";
}

}  // namespace saccade::client::dv
