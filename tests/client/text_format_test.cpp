#include <filesystem>
#include <fstream>

#include "client/formats/common/event_check.h"
#include "format_test.h"

namespace saccade::client {
namespace {

const WriterInfo& kCsvWriter = writerFor("a.csv", "csv");
const WriterInfo& kTxtWriter = writerFor("a.txt", "txt");
const ReaderInfo& kCsvReader = readerFor("a.csv");
const ReaderInfo& kTxtReader = readerFor("a.txt");

const Events kEvents{{0, 1, 2, 1}, {1'234'567'000, 345, 259, 0}, {4'000'000'001'000, 0, 0, 1}};

class TextFormatTest : public FormatTest {
 protected:
  std::string fileOf(const std::string& name, const std::string& text) const {
    std::ofstream(at(name)) << text;
    return at(name);
  }
  std::string faultOf(const std::string& name, const std::string& text) const {
    const std::string file = fileOf(name, text);
    return FormatTest::faultOf(readerFor(file), file);
  }
};

TEST_F(TextFormatTest, CsvGivesItsEventsBackButNoSize) {
  write(kCsvWriter, at("a.csv"), {kEvents}, 0, aboutOf(346, 260));
  const auto reader = kCsvReader.make(at("a.csv"));
  EXPECT_EQ(reader->size().width, 0u);
  EXPECT_EQ(readBack(*reader), kEvents);
}

TEST_F(TextFormatTest, TxtGivesItsEventsAndSizeBack) {
  write(kTxtWriter, at("a.txt"), {kEvents}, 0, aboutOf(346, 260));
  const auto reader = kTxtReader.make(at("a.txt"));
  EXPECT_EQ(reader->size().width, 346u);
  EXPECT_EQ(reader->size().height, 260u);
  EXPECT_EQ(readBack(*reader), kEvents);
}

TEST_F(TextFormatTest, TimesBeforeZeroComeBack) {
  const Events events{{-1'500'000'000, 1, 2, 1}, {-1000, 1, 2, 0}, {0, 1, 2, 1}};
  for (const WriterInfo* format : {&kCsvWriter, &kTxtWriter}) {
    const std::string file = at(std::string("a") + format->extension);
    write(*format, file, {events}, 0, aboutOf(4, 3));
    EXPECT_EQ(readBack(*readerFor(file).make(file)), events) << file;
  }
}

TEST_F(TextFormatTest, TxtOfOtherProgramsMayHaveFewerDecimalsAndOtherLineEnds) {
  const std::string file = fileOf("a.txt", "4 3\r\n0.5 1 2 1\r\n0.500001 3 0 0\r\n");
  EXPECT_EQ(readBack(*kTxtReader.make(file)), (Events{{500'000'000, 1, 2, 1}, {500'001'000, 3, 0, 0}}));
}

TEST_F(TextFormatTest, MoreThanABatchIsReadInParts) {
  Events events;
  for (int i = 0; i < 100'000; ++i) events.push_back({i * 1000LL, 1, 2, static_cast<std::uint8_t>(i % 2)});
  write(kCsvWriter, at("a.csv"), {events}, 0, aboutOf(4, 3));
  const auto reader = kCsvReader.make(at("a.csv"));
  Events first;
  ASSERT_TRUE(reader->read(first));
  EXPECT_LT(first.size(), events.size());
  const Events rest = readBack(*reader);
  first.insert(first.end(), rest.begin(), rest.end());
  EXPECT_EQ(first, events);
}

TEST_F(TextFormatTest, AFaultNamesItsLine) {
  EXPECT_NE(faultOf("a.csv", "t,x,y,p\n1,2,3,1\n1,2,3\n").find("a.csv: line 3 is not of the form 't x y p'"),
            std::string::npos);
  for (const char* line : {"1,2,3,1,", "x,2,3,1", "1,-2,3,1", "1,70000,3,1", "1,2,3,1,5", "1,2,3,2",
                           "1,2.5,3,1", "1,2,3", "9223372036854775807,0,0,0"})
    EXPECT_NE(faultOf("a.csv", std::string("t,x,y,p\n1,2,3,1\n") + line + "\n"), "none") << line;
  for (const char* line : {"1.x 2 3 1", "1.0 2 3", "1.0 2 3 1 5", "1.0 2 3 300", "1e300 2 3 1", "nan 2 3 1"})
    EXPECT_NE(faultOf("a.txt", std::string("4 3\n") + line + "\n"), "none") << line;
  EXPECT_NE(faultOf("a.txt", "4\n"), "none");
  EXPECT_NE(faultOf("a.txt", "70000 3\n"), "none");
  EXPECT_NE(faultOf("a.txt", ""), "none");
}

TEST_F(TextFormatTest, ALineHasAtMost4KiB) {
  const std::string zeros(4096 - 7, '0');
  EXPECT_EQ(readBack(*kCsvReader.make(fileOf("a.csv", "t,x,y,p\r\n" + zeros + "1,2,3,1\r\n"))),
            (Events{{1000, 2, 3, 1}}));
  EXPECT_NE(faultOf("a.csv", "t,x,y,p\n" + zeros + "01,2,3,1\n").find("line 2 is longer than 4 KiB"),
            std::string::npos);
  for (const char* name : {"a.csv", "a.txt"}) {
    const std::string file = fileOf(name, "");
    std::filesystem::resize_file(file, std::uintmax_t{1} << 40);
    EXPECT_NE(FormatTest::faultOf(readerFor(file), file).find("line 1 is longer than 4 KiB"),
              std::string::npos);
  }
}

TEST_F(TextFormatTest, AFileThatIsNotThereIsNamed) {
  EXPECT_THROW(kCsvReader.make(at("none.csv")), std::system_error);
}

TEST(EventCheck, NamesTheEventAtFault) {
  const auto faultOf = [](const Event& event) -> std::string {
    EventCheck check("a.csv", {4, 3});
    check.check({{1000, 3, 2, 1}, {1000, 0, 0, 0}});
    try {
      check.check({event});
    } catch (const FileFault& fault) {
      return fault.what();
    }
    return "none";
  };
  EXPECT_EQ(faultOf({1000, 3, 2, 1}), "none");
  EXPECT_EQ(faultOf({0, 0, 0, 1}), "a.csv: event 3 is 1 us earlier than the one before");
  EXPECT_EQ(faultOf({1000, 4, 0, 1}), "a.csv: event 3 is at (4, 0), outside of 4x3 pixels");
  EXPECT_EQ(faultOf({1000, 0, 3, 1}), "a.csv: event 3 is at (0, 3), outside of 4x3 pixels");
}

}  // namespace
}  // namespace saccade::client
