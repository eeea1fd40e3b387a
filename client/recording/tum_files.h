// The poses of cameras as text in the format of the TUM RGB-D benchmark, which evo and others read. A line is
// "t x y z qx qy qz qw": seconds, and T_world_camera in scene units.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/formats/common/output_file.h"
#include "saccade/v1/control.pb.h"
#include "saccade/wire/packet.h"

namespace saccade::client {

// PATH.tum.txt of view 0, and PATH.cam1.tum.txt, ... of further views that have a truth channel `pose`.
std::vector<std::string> tumNames(const std::string& path, const v1::OpenStream& request);

class TumFiles {
 public:
  // Starts the files, each called NAME.partial until close(). Throws std::system_error, as all members do.
  TumFiles(const std::string& path, const v1::OpenStream& resolved);

  void add(const DecodedPacket& batch);  // of any channel of the stream
  void close();                          // the last call

 private:
  struct Channel {
    std::uint32_t number;  // PacketHeader.sensor
    std::string name;
    std::unique_ptr<OutputFile> file;
  };
  std::vector<Channel> channels_;
};

}  // namespace saccade::client
