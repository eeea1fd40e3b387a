// `saccade-eval compare-events`, from files on.
#include <gtest/gtest.h>

#include <fstream>

#include "client/scratch_folder.h"
#include "eval/files/file_comparison.h"

namespace saccade::eval {
namespace {

struct CompareFiles : testing::Test {
  ScratchFolder folder;

  // Events at these microseconds, in a pixel each.
  std::string file(const std::string& name, const std::vector<std::int64_t>& times) const {
    std::ofstream text(folder.at(name));
    text << "t_us,x,y,p\n";
    for (std::size_t i = 0; i < times.size(); ++i) text << times[i] << ',' << i << ",1,1\n";
    return folder.at(name);
  }
  FileComparison compare(const std::string& a, const std::string& b, bool align = false) const {
    EventWindows of_a(a, {16, 8}, align), of_b(b, {16, 8}, align);
    return compareFiles(of_a, of_b, 10'000'000);
  }
};

TEST_F(CompareFiles, TakesWindowByWindow) {
  const FileComparison same = compare(file("a.csv", {100, 9'999, 10'000, 70'000'000}),
                                      file("b.csv", {100, 9'999, 10'000, 70'000'000}));
  EXPECT_EQ(same.of_a.events(), 4u);
  EXPECT_EQ(same.of_b.events(), 4u);
  EXPECT_EQ(same.distance.chamferPx(), 0);
  EXPECT_EQ(same.distance.countError(), 0);
  // 9,999 us has nothing to be compared with in its window.
  const FileComparison other = compare(file("a.csv", {9'999}), file("b.csv", {10'000}));
  EXPECT_EQ(other.distance.alone(), 2u);
}

TEST_F(CompareFiles, AlignsTheFirstEvents) {
  const std::string a = file("a.csv", {100, 3'100}), b = file("b.csv", {1'700'000'100, 1'700'003'100});
  EXPECT_EQ(compare(a, b).distance.alone(), 4u);
  const FileComparison aligned = compare(a, b, true);
  EXPECT_EQ(aligned.distance.alone(), 0u);
  EXPECT_EQ(aligned.distance.chamferPx(), 0);
}

TEST_F(CompareFiles, RefusesSizesThatDiffer) {
  const std::string a = file("a.csv", {1});
  EventWindows small(a, {16, 8}), large(a, {32, 8});
  EXPECT_THROW(compareFiles(small, large, 1000), std::invalid_argument);
  EXPECT_THROW(EventWindows(a, {}), std::invalid_argument);
}

TEST_F(CompareFiles, RefusesPixelsOutsideAndTimesThatRunBack) {
  const std::string a = file("a.csv", {5, 4});
  EventWindows late(a, {16, 8}), narrow(a, {1, 8});
  Events events;
  EXPECT_THROW(late.until(INT64_MAX, events), client::FileFault);
  EXPECT_THROW(narrow.until(INT64_MAX, events), client::FileFault);
}

}  // namespace
}  // namespace saccade::eval
