// The XML text of a header, which describes the streams of a file or connection.
//
// dv-processing wants the root `dv` of version 2.0, in it one node `outInfo`, and in that a node for each
// stream, named by its number. It skips a stream without originalOutputName or typeIdentifier, and finds the
// events by the name "events". It wants sizeX and sizeY of type int, and a source MODEL_SERIAL.
// Sources: dv-processing io/reader.hpp, io/mono_camera_recording.hpp, io/network_reader.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/aedat4/compression.h"
#include "client/formats/common/reader.h"

namespace saccade::client::aedat4 {

inline constexpr std::int32_t kStreamId = 0;  // of the events that we write
inline constexpr const char* kEventsType = "EVTS";

struct Camera {
  ImageSize size;
  std::uint32_t sensor = 0;  // becomes its serial number
};

// As the recorder of DV writes it. Times have no offset.
std::string fileInfo(const Camera& camera, Compression compression);
// As NetworkWriter of dv-processing writes it.
std::string networkInfo(const Camera& camera, Compression compression);

struct Stream {
  std::int32_t id;
  std::string type;  // "EVTS", "FRME", ...
  ImageSize size;    // 0x0: not told
};

// The streams in the order of the text. Throws std::runtime_error if it is no such text.
std::vector<Stream> streamsOf(const std::string& info);

}  // namespace saccade::client::aedat4
