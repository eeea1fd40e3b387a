#include "client/formats/ros/mcap_file.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

// The fields of a Chunk Index record, as mcap.dev/spec has them.
TEST(McapFile, AChunkBeyondFourGibibytesKeepsItsPosition) {
  std::string records;
  appendChunkIndex(
      records, {.span = {1, 2, 3}, .position = 0x0123456789, .size = 0x10, .indexes = {{1, 0x0123456799}}});
  const std::string times("\1\0\0\0\0\0\0\0\2\0\0\0\0\0\0\0", 16);
  const std::string position_and_size("\x89\x67\x45\x23\1\0\0\0\x10\0\0\0\0\0\0\0", 16);
  const std::string index_of_channel("\x0a\0\0\0\1\0\x99\x67\x45\x23\1\0\0\0", 14);
  EXPECT_NE(records.find(times + position_and_size + index_of_channel), std::string::npos);
}

}  // namespace
}  // namespace saccade::client
