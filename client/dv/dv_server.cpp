#include "client/dv/dv_server.h"

#include <poll.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "client/formats/aedat4/info_node.h"
#include "client/formats/aedat4/io_header.h"

namespace saccade::client::dv {
namespace {

using aedat4::Compression;

constexpr int kHighestPort = 65535;
constexpr std::chrono::milliseconds kFinishTurn{20};

Address addressOf(const Address& first, int sensor) {
  if (first.port == 0) return first;
  const int port = first.port + sensor;
  if (port > kHighestPort)
    throw std::invalid_argument("sensor " + std::to_string(sensor) + " would have port " +
                                std::to_string(port));
  return {first.host, static_cast<std::uint16_t>(port)};
}

std::shared_ptr<const Message> headerOf(const ImageSize& size, std::uint32_t sensor,
                                        Compression compression) {
  const aedat4::IoHeader header{compression, aedat4::kNoTable,
                                aedat4::networkInfo({size, sensor}, compression)};
  return std::make_shared<Message>(Message{aedat4::encodeHeader(header)});
}

}  // namespace

DvServer::DvServer(const Address& address, int sensors, std::size_t backlog,
                   std::function<void(const std::string&)> tell)
    : backlog_(backlog), tell_(std::move(tell)) {
  for (int sensor = 0; sensor < sensors; ++sensor) {
    Listener listener(addressOf(address, sensor));
    const Compression compression = listener.loopback() ? Compression::kNone : Compression::kLz4;
    ports_.push_back({std::move(listener), compression, aedat4::PacketEncoder(compression), nullptr, {}});
  }
}

void DvServer::listen(const ImageSize& size) {
  for (std::uint32_t sensor = 0; Port & port : ports_) {
    port.header = headerOf(size, sensor++, port.compression);
    port.listener.listen();
  }
}

void DvServer::send(std::uint32_t sensor, std::span<const Event> events, std::int64_t offset_us) {
  Port& port = ports_.at(sensor);
  if (events.empty() || port.viewers.empty()) return;
  Message message;
  message.events = events.size();
  port.encoder.append(message.bytes, events, offset_us);
  const auto shared = std::make_shared<const Message>(std::move(message));
  for (Viewer& viewer : port.viewers) viewer.send(shared);
  dismissGone(port);
}

void DvServer::serve(std::chrono::milliseconds timeout) {
  std::vector<pollfd> polled;
  for (const Port& port : ports_) {
    polled.push_back({port.listener.descriptor(), POLLIN, 0});
    for (const Viewer& viewer : port.viewers) {
      const int out = viewer.pending() ? POLLOUT : 0;
      polled.push_back({viewer.descriptor(), static_cast<short>(POLLIN | out), 0});
    }
  }
  if (poll(polled.data(), polled.size(), static_cast<int>(timeout.count())) <= 0) return;
  auto next = polled.begin();
  for (Port& port : ports_) {
    const bool knocked = next++->revents != 0;
    for (Viewer& viewer : port.viewers) {
      const short events = next++->revents;
      if (events & POLLOUT) viewer.write();
      if (events & ~POLLOUT) viewer.read();
    }
    dismissGone(port);
    if (knocked) welcome(port);
  }
}

void DvServer::welcome(Port& port) {
  while (auto connection = port.listener.accept()) {
    if (viewers() >= kMostViewers) {
      tell_(connection->peer + " is refused: there are " + std::to_string(kMostViewers) + " viewers");
      continue;
    }
    tell_(connection->peer + " watches " + port.listener.name());
    port.viewers.emplace_back(std::move(*connection), backlog_).send(port.header);
  }
}

void DvServer::dismissGone(Port& port) {
  for (const Viewer& viewer : port.viewers) {
    if (viewer.gone()) tell_(viewer.farewell());
  }
  port.viewers.remove_if([](const Viewer& viewer) { return viewer.gone(); });
}

void DvServer::finish(std::chrono::milliseconds patience) {
  const auto until = std::chrono::steady_clock::now() + patience;
  while (pending() && std::chrono::steady_clock::now() < until) serve(kFinishTurn);
  for (Port& port : ports_) {
    for (Viewer& viewer : port.viewers) {
      if (viewer.pending()) viewer.cut();
    }
    dismissGone(port);
  }
}

std::size_t DvServer::viewers() const {
  return std::accumulate(ports_.begin(), ports_.end(), std::size_t{0},
                         [](std::size_t sum, const Port& port) { return sum + port.viewers.size(); });
}

bool DvServer::pending() const {
  return std::any_of(ports_.begin(), ports_.end(), [](const Port& port) {
    return std::any_of(port.viewers.begin(), port.viewers.end(),
                       [](const Viewer& viewer) { return viewer.pending(); });
  });
}

std::vector<std::string> DvServer::names() const {
  std::vector<std::string> names;
  for (const Port& port : ports_) names.push_back(port.listener.name());
  return names;
}

}  // namespace saccade::client::dv
