#include "client/formats/ros/bag_file.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

// The bytes of a field `chunk_pos=` of 8 bytes, as wiki.ros.org/Bags/Format/2.0 has it.
TEST(BagFile, AChunkBeyondFourGibibytesKeepsItsPosition) {
  std::string records;
  appendChunkInfo(records, {0x0123456789, {1, 2}, {3, 4}, {5}});
  const std::string field("\x12\0\0\0chunk_pos=\x89\x67\x45\x23\x01\0\0\0", 22);
  EXPECT_NE(records.find(field), std::string::npos);
}

}  // namespace
}  // namespace saccade::client
