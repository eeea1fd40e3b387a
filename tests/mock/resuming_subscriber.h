// A client that attaches anew whenever it is told that its connection is lost, and goes on where it was.
#pragma once

#include <functional>
#include <memory>

#include "mock/mock_subscriber.h"

namespace saccade {

class ResumingSubscriber {
 public:
  // Of a stream with one sensor; `credit` bytes are given to each connection, and what has come is given back
  // and acknowledged.
  ResumingSubscriber(std::string data_endpoint, v1::StreamOpened stream, std::uint64_t credit);

  // The next packet that it has not got yet, in the order of seq. Where none comes for a moment it asks
  // `lost` whether to attach anew. Throws std::runtime_error at an ERROR and where nothing comes for
  // kPatience.
  Received receive(const std::function<bool()>& lost);
  Received receive(std::chrono::milliseconds silence);    // after which a connection counts as lost
  Packets receiveAll(const std::function<bool()>& lost);  // to END
  int attached() const { return attached_; }              // how often

 private:
  void attach();

  const std::string endpoint_;
  const v1::StreamOpened stream_;
  const std::uint64_t credit_;
  std::uint64_t due_ = 0;  // seq
  int attached_ = 0;
  std::unique_ptr<MockSubscriber> connection_;
};

}  // namespace saccade
