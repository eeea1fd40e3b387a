// Tells systemd the state of a service of Type=notify [sd_notify(3)]. Does nothing without systemd.
#pragma once

#include <string>

namespace saccade {

class ServiceManager {
 public:
  ServiceManager();  // on the socket that NOTIFY_SOCKET names
  ~ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  // Sends "READY=1", "STOPPING=1" or "WATCHDOG=1"; a failure is ignored. From any thread.
  void tell(const std::string& state) const;

 private:
  int socket_ = -1;  // connected; -1: no systemd
};

}  // namespace saccade
