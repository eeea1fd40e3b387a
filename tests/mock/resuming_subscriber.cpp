#include "mock/resuming_subscriber.h"

#include <stdexcept>

namespace saccade {

ResumingSubscriber::ResumingSubscriber(std::string data_endpoint, v1::StreamOpened stream,
                                       std::uint64_t credit)
    : endpoint_(std::move(data_endpoint)), stream_(std::move(stream)), credit_(credit) {
  attach();
}

void ResumingSubscriber::attach() {
  connection_ = std::make_unique<MockSubscriber>(endpoint_);
  connection_->attach(stream_, {due_});
  connection_->giveCredit(credit_);
  ++attached_;
}

Received ResumingSubscriber::receive(const std::function<bool()>& lost) {
  constexpr std::chrono::milliseconds kMoment{20};
  // Moments, not time: its process may be stopped for longer than that.
  for (auto left = kPatience / kMoment; left > 0;) {
    auto packet = connection_->receive(kMoment);
    if (!packet) {
      --left;
      if (lost()) attach();
      continue;
    }
    if (packet->header.kind() == v1::KIND_ERROR) {
      // ZeroMQ has made the connection anew by itself: the server does not know us.
      if (!packet->payload.starts_with("attach to a stream before"))
        throw std::runtime_error(packet->payload);
      attach();
      continue;
    }
    connection_->giveCredit(packet->bytes);
    if (packet->header.seq() < due_) continue;  // was under way already
    connection_->acknowledge(0, packet->header.seq());
    due_ = packet->header.seq() + 1;
    return *packet;
  }
  throw std::runtime_error("no packet came");
}

Received ResumingSubscriber::receive(std::chrono::milliseconds silence) {
  auto since = std::chrono::steady_clock::now();
  return receive([&] {
    const auto now = std::chrono::steady_clock::now();
    const bool lost = now - since > silence;
    if (lost) since = now;
    return lost;
  });
}

Packets ResumingSubscriber::receiveAll(const std::function<bool()>& lost) {
  Packets packets;
  while (packets.empty() || packets.back().header.kind() != v1::KIND_END) packets.push_back(receive(lost));
  return packets;
}

}  // namespace saccade
