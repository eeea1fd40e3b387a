#include "client/recording/json_text.h"

#include <gtest/gtest.h>

#include "saccade/v1/dataset.pb.h"

namespace saccade::client {
namespace {

TEST(JsonText, HasMapsInOrderOfTheirKeys) {
  v1::DataSetSequence sequence;
  for (const char* key : {"m", "z", "a", "k", "b", "y", "c", "x"}) (*sequence.mutable_draws())[key] = "1";
  const std::string draws = R"("draws":{"a":"1","b":"1","c":"1","k":"1","m":"1","x":"1","y":"1","z":"1"})";
  EXPECT_NE(jsonText(sequence, false).find(draws), std::string::npos) << jsonText(sequence, false);
}

TEST(JsonText, NamesFieldsAsTheSchemaDoesEvenWithoutValues) {
  v1::DataSetSequence sequence;
  sequence.set_number(1ull << 60);
  sequence.add_recordings()->set_begin_ns(5);
  const std::string text = jsonText(sequence, false);
  EXPECT_NE(text.find(R"("number":"1152921504606846976","shard":0)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("begin_ns":"5","end_ns":"0")"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_NE(jsonText(sequence, true).find('\n'), std::string::npos);
}

}  // namespace
}  // namespace saccade::client
