// Serves the events of sensors as dv-processing's NetworkWriter does: DV takes each port for a camera.
//
// A client gets the header of an AEDAT 4 file, without the line before it, and then packets of events. A port
// has one stream of one type, and no packet is empty: another type ends a program of dv-processing. The
// protocol cannot tell of a loss, so a viewer that is too slow is cut.
// Sources: dv-processing io/network_writer.hpp, io/network_reader.hpp.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <span>
#include <string>
#include <vector>

#include "client/dv/listener.h"
#include "client/dv/viewer.h"
#include "client/formats/aedat4/packets.h"
#include "client/formats/common/reader.h"

namespace saccade::client::dv {

class DvServer {
 public:
  static constexpr std::size_t kMostViewers = 256;  // of all ports

  // Takes one port for each sensor: `address`, and those after it. `backlog`: bytes that a viewer may leave
  // unread. `tell` gets one line about each viewer that comes or goes. Throws std::invalid_argument if a port
  // cannot be had.
  DvServer(const Address& address, int sensors, std::size_t backlog,
           std::function<void(const std::string&)> tell);

  void listen(const ImageSize& size);  // lets viewers come; throws std::system_error
  // Sends the events, if there are any, to all viewers of the sensor; `offset_us` is added to their times.
  void send(std::uint32_t sensor, std::span<const Event> events, std::int64_t offset_us);
  // Waits up to `timeout` until a viewer comes, goes, or can be sent more, and does that.
  void serve(std::chrono::milliseconds timeout);

  // Waits for at most `patience` until all is sent, and then cuts the viewers for which that was too short.
  void finish(std::chrono::milliseconds patience);

  std::vector<std::string> names() const;  // ADDRESS:PORT of each sensor

 private:
  struct Port {
    Listener listener;
    aedat4::Compression compression;
    aedat4::PacketEncoder encoder;
    std::shared_ptr<const Message> header;
    std::list<Viewer> viewers;
  };
  void welcome(Port& port);
  void dismissGone(Port& port);
  std::size_t viewers() const;
  bool pending() const;

  const std::size_t backlog_;
  const std::function<void(const std::string&)> tell_;
  std::vector<Port> ports_;  // by sensor
};

}  // namespace saccade::client::dv
