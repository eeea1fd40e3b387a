#include "web/viewer_gateway.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "web/viewer.h"
#include "web/web_handshake.h"

namespace saccade {

ViewerGateway::ViewerGateway(ViewerSettings settings) : settings_(std::move(settings)) {}

ViewerGateway::~ViewerGateway() {
  stop();
}

HttpUpgrade ViewerGateway::upgrade() {
  return {.answer = [this](const HttpHeader& header) { return answer(header); },
          .take = [this](UpgradedSocket socket) { take(std::move(socket)); }};
}

std::size_t ViewerGateway::viewers() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(
      std::count_if(seats_.begin(), seats_.end(), [](const Seat& seat) { return !seat.done; }));
}

HttpAnswer ViewerGateway::answer(const HttpHeader& header) const {
  if (viewers() >= settings_.max_viewers)
    return {.status = 503,
            .body = "limit viewers: " + std::to_string(settings_.max_viewers) + " are watching\n"};
  return answerHandshake(header, settings_.loopback_only);
}

// Counts again: several connections may have been answered before the first is taken.
void ViewerGateway::take(UpgradedSocket socket) {
  if (viewers() >= settings_.max_viewers) return;
  const std::lock_guard lock(mutex_);
  if (stopped_) return;
  std::erase_if(seats_, [](const Seat& seat) { return seat.done.load(); });
  Seat& seat = seats_.emplace_back();
  // std::function cannot hold the socket, but std::jthread can.
  seat.thread = std::jthread(
      [this, &seat](std::stop_token stopped, UpgradedSocket own) {
        serve(std::move(own), std::move(stopped));
        seat.done = true;
      },
      std::move(socket));
}

void ViewerGateway::serve(UpgradedSocket socket, std::stop_token stopped) {
  try {
    Viewer(std::move(socket), context_, settings_.control, settings_.source).run(std::move(stopped));
  } catch (const std::exception& fault) {
    log_.write(spdlog::level::warn, std::string("a viewer was cut off: ") + fault.what());
  }
}

void ViewerGateway::stop() {
  std::list<Seat> seats;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    seats.swap(seats_);
  }
  for (Seat& seat : seats) seat.thread.request_stop();
}

}  // namespace saccade
