// The poses of cameras and objects as text in the format of the TUM RGB-D benchmark, which evo and others
// read. A line is "t x y z qx qy qz qw": seconds, and T_world_camera or T_world_object in scene units.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/formats/common/output_file.h"
#include "saccade/v1/control.pb.h"
#include "saccade/wire/packet.h"

namespace saccade::client {

// PATH.tum.txt of view 0, and PATH.cam1.tum.txt, ... of further views that have a truth channel `pose`. With
// `object_poses` also PATH.object-NAME.tum.txt of each object that the request moves. A resolved one names
// those that the scene moves, too.
std::vector<std::string> tumNames(const std::string& path, const v1::OpenStream& request);

class TumFiles {
 public:
  // Starts the files, each called NAME.partial until close(). Throws std::system_error, as all members do;
  // add() throws StreamFault where there are poses of more objects than `resolved` moves.
  TumFiles(const std::string& path, const v1::OpenStream& resolved);

  void add(const DecodedPacket& batch);  // of any channel of the stream
  void close();                          // the last call

 private:
  struct File {
    std::string name;
    std::unique_ptr<OutputFile> output;
  };
  struct Channel {
    std::uint32_t number;              // PacketHeader.sensor
    std::size_t begin = 0;             // of the pose in a row
    std::vector<File> files = {};      // of a camera, or of each object
    std::vector<double> objects = {};  // their numbers, in the order of `files`, as far as they are known
  };
  static File start(const std::string& name);
  static File& fileOf(Channel& channel, const TruthSample& row);

  std::vector<Channel> channels_;
};

}  // namespace saccade::client
