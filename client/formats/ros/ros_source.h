// A file with messages of ROS in topics: a bag, or MCAP.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "client/formats/common/input_file.h"
#include "client/formats/common/reader.h"

namespace saccade::client {

inline constexpr std::uint64_t kMostChunk = 256 << 20;  // bytes of a chunk, as expanded

struct RosTopic {
  std::string name, type;
  bool events;  // whether its messages are events of the type that can be read

  friend bool operator==(const RosTopic&, const RosTopic&) = default;
};

// Every call throws FileFault with the place in bytes, or std::system_error when the file cannot be read.
class RosSource {
 public:
  virtual ~RosSource() = default;
  virtual const std::vector<RosTopic>& topics() const = 0;

  struct Message {
    std::size_t topic;
    std::string_view data;  // until the next call
  };
  // The next message in the order of the file; nothing at the end. A file that was not finished ends with its
  // last whole chunk.
  virtual std::optional<Message> next() = 0;

  // Calls `read`. A fault that it throws without a place gets that of the latest message.
  template <class Read>
  auto placed(const Read& read) const {
    try {
      return read();
    } catch (const FileFault&) {
      throw;
    } catch (const std::system_error&) {
      throw;
    } catch (const std::runtime_error& fault) {
      fail(fault.what());
    }
  }

 protected:
  explicit RosSource(const std::string& path) : file_(path), end_(file_.size()) {}

  // Throws FileFault with the place of the record.
  [[noreturn]] void fail(const std::string& what) const;
  std::string bytesAt(std::uint64_t at, std::uint64_t size);  // of the file; at most kMostChunk

  InputFile file_;
  std::uint64_t end_;                 // of the records with messages, byte
  std::uint64_t at_ = 0, place_ = 0;  // byte of the next record, and of the one that is being read
};

}  // namespace saccade::client
