// Labels of events in files of columns, where they are not as our own writers have them.
#include <fstream>

#include "client/formats/common/event_columns.h"
#include "client/formats/npz/npz_column.h"
#include "format_test.h"

namespace saccade::client {
namespace {

const ReaderInfo& kNpzReader = readerFor("a.npz");

class LabelColumnsTest : public FormatTest {
 protected:
  // An archive of two events, with these columns of small numbers beside them.
  void write(const std::vector<std::pair<std::string, std::string>>& labels) const {
    std::vector<std::pair<std::string, std::string>> arrays;
    for (const char* name : {"t", "x", "y", "p"}) arrays.emplace_back(name, std::string("\0\1", 2));
    arrays.insert(arrays.end(), labels.begin(), labels.end());
    std::string bytes;
    std::vector<ZipMember> members;
    for (const auto& [name, values] : arrays) {
      const std::string array = npyHeader("|i1", "(" + std::to_string(values.size()) + ",)") + values;
      members.push_back(zipMember(name + ".npy", array));
      members.back().offset = bytes.size();
      bytes += zipHeader(members.back()) + array;
    }
    std::ofstream(file_, std::ios::binary) << bytes + zipDirectory(members, bytes.size());
  }
  std::string faultOf() const { return FormatTest::faultOf(kNpzReader, file_); }

  const std::string file_ = at("a.npz");
};

TEST_F(LabelColumnsTest, AreThoseOfTheEvents) {
  write({{"source", std::string("\0\1", 2)}, {"artefact", "\5\x7f"}});
  const auto reader = kNpzReader.make(file_);
  EXPECT_TRUE(reader->labels());
  EXPECT_EQ(readBack(*reader), (Events{{0, 0, 0, 0, 0, 0, 5}, {1000, 1, 1, 1, 1, 0, 127}}));
}

TEST_F(LabelColumnsTest, ObjectsAreThoseOfTheEvents) {
  write({{"object", "\5\x7f"}});
  const auto reader = kNpzReader.make(file_);
  EXPECT_TRUE(reader->objects());
  EXPECT_FALSE(reader->labels());
  const Events events = readBack(*reader);
  EXPECT_EQ(events.at(0).object, 5u);
  EXPECT_EQ(events.at(1).object, 127u);
  write({{"object", "\1\xff"}});  // -1
  EXPECT_NE(faultOf().find("event 2 has object -1"), std::string::npos) << faultOf();
}

TEST_F(LabelColumnsTest, OneWithoutTheOtherIsLeftOutByName) {
  write({{"source", "\1\1"}});
  EXPECT_FALSE(kNpzReader.make(file_)->labels());
  EXPECT_EQ(kNpzReader.make(file_)->leftOut(), "source without artefact");
  EXPECT_EQ(readBack(*kNpzReader.make(file_)), (Events{{0, 0, 0, 0}, {1000, 1, 1, 1}}));
  write({{"artefact", "\1\1"}});
  EXPECT_EQ(kNpzReader.make(file_)->leftOut(), "artefact without source");
}

TEST_F(LabelColumnsTest, OfAnotherLengthAreRefused) {
  write({{"source", "\1\1"}, {"artefact", "\1"}});
  EXPECT_NE(faultOf().find("has columns of unequal lengths: t has 2 values, artefact has 1"),
            std::string::npos);
}

TEST_F(LabelColumnsTest, OutsideOfAByteAreRefusedWithTheirEvent) {
  write({{"source", "\1\1"}, {"artefact", "\1\xff"}});  // -1
  EXPECT_NE(faultOf().find("event 2 has source 1, artefact -1; source is 0 to 7, artefact 0 to 255"),
            std::string::npos)
      << faultOf();
}

}  // namespace
}  // namespace saccade::client
