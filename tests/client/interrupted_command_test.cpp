// `saccade record` that ends early.
#include <thread>

#include "client/command.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace test;

// A recording that events have come to: before that a server that stops would not know of its receiver.
class Interrupted : public CommandAndServer {
 protected:
  Child startRecord(const std::string& duration) {
    Child child(SACCADE_COMMAND
                " record cornell-box --trajectory right --size 32x24 --retry-time 0 --duration " +
                duration + " -o " + file_ + server_.option());
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!begun() && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    return child;
  }
  const std::string file_ = folder_.at("a.csv"), partial_ = folder_.at("a.csv.partial");

 private:
  bool begun() const { return fs::exists(partial_) && fs::file_size(partial_) > kHeading.size(); }
  static constexpr std::string_view kHeading = "t,x,y,p\n";
};
TEST_F(Interrupted, CtrlCKeepsTheEventsThatCame) {
  Child record = startRecord("1000");
  record.signal(SIGINT);
  const Result result = finish(record);
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result, "interrupted") && holds(result, partial_)) << result.output;
  EXPECT_TRUE(fs::exists(partial_) && !fs::exists(file_));
}
TEST_F(Interrupted, CtrlCIsTheEndOfAnEndlessStream) {
  Child record = startRecord("0");
  record.signal(SIGINT);
  const Result result = finish(record);
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(fs::exists(file_) && !fs::exists(partial_));
}
TEST_F(Interrupted, AServerThatStopsLeavesNoWholeFile) {
  Child record = startRecord("1000");
  server_.stop();
  const Result result = finish(record);
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result, "the server has stopped and ended the stream at frame")) << result.output;
  EXPECT_TRUE(fs::exists(partial_) && !fs::exists(file_));
}

}  // namespace
}  // namespace saccade
