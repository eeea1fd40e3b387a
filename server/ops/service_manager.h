// What systemd is told of a service of Type=notify [sd_notify(3)]; nothing where it does not ask.
#pragma once

#include <string>

namespace saccade {

class ServiceManager {
 public:
  ServiceManager();  // on the socket that NOTIFY_SOCKET names
  ~ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  // "READY=1", "STOPPING=1", "WATCHDOG=1". From any thread; what cannot be sent is lost.
  void tell(const std::string& state) const;

 private:
  int socket_ = -1;  // connected; -1: nobody asks
};

}  // namespace saccade
