// `saccade streams` and `saccade close`, and what --json prints.
#include <google/protobuf/util/json_util.h>

#include "client/command.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

using namespace test;

template <class Message>
Message fromJson(const std::string& arguments) {
  const Result result = run(arguments);
  EXPECT_EQ(result.code, 0) << result.output;
  Message message;
  EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(result.output, &message).ok()) << result.output;
  return message;
}

class StreamsCommand : public testing::Test {
 protected:
  TestServer server_;
  const std::string option_ = " --control '" + server_.app().controlEndpoint() + "' ";
};

TEST_F(StreamsCommand, ListsAndClosesStreams) {
  EXPECT_EQ(run("streams" + option_).output, "no streams\n");
  const std::string id = server_.client().open(tinyRequest()).stream_id();
  const Result list = run("streams" + option_);
  EXPECT_EQ(list.code, 0);
  EXPECT_TRUE(holds(list, "\n" + id + "  -  ") && holds(list, "cornell-box") && holds(list, "waiting"))
      << list.output;
  EXPECT_EQ(run("close " + id + option_).output, "closed " + id + "\n");
  const Result again = run("close nothing" + option_);
  EXPECT_EQ(again.code, 2);
  EXPECT_EQ(again.output, "saccade: stream_id: there is no stream 'nothing'\n");
  EXPECT_EQ(run("close" + option_).code, 2);
}

TEST_F(StreamsCommand, PrintsJsonWithTheNamesOfTheSchema) {
  const std::string id = server_.client().open(tinyRequest()).stream_id();
  const auto list = fromJson<v1::StreamList>("streams --json" + option_);
  ASSERT_EQ(list.streams_size(), 1);
  EXPECT_EQ(list.streams(0).stream_id(), id);
  EXPECT_EQ(fromJson<v1::ServerDescription>("info --json" + option_).SerializeAsString(),
            server_.client().server().SerializeAsString());
  EXPECT_TRUE(holds(run("streams --json" + option_), "\"frames_done\": \"0\""));
  EXPECT_TRUE(holds(run("list --json" + option_), "\"name\": \"cornell-box\""));
  fromJson<v1::SceneList>("list --json" + option_);
}

}  // namespace
}  // namespace saccade
