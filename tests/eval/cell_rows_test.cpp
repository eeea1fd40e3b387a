#include <sstream>

#include "eval/figures/cell_rows.h"

#include "eval/compared.h"
#include "scene/scratch.h"

namespace saccade::eval {
namespace {

using test::comparedCell;

ComparedCell leftOut() {
  ComparedCell cell{{"mine/box/scene.xml", "shake", 4, {17, 21}}};
  cell.left_out = "the images stand still";
  return cell;
}

std::vector<ComparedCell> twoAndOneLeftOut() {
  std::vector<ComparedCell> cells;
  cells.push_back(comparedCell(0.5, 2, 1));
  cells.push_back(comparedCell(2, 0, 1));
  cells.push_back(leftOut());
  return cells;
}

TEST(CellRows, AreARowForEachRatioAndForEachCellLeftOut) {
  const std::string csv = csvOf(twoAndOneLeftOut());
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            1 + 2 * (kComparedColumns.size() + 2) + 1);
  expectContains(csv, "\nbox,right,0.5,21,0.66,0.1,0.01,new@2,dL_l1,1,old@2,2,0.5,\n");
  expectContains(csv, "\nbox,right,0.5,21,0.66,0.1,0.01,new@2,dL_share,1,,,,\n");
  expectContains(csv, "\nbox,right,2,21,0.66,0.1,0.01,new@2,dL_l1,1,old@2,0,,no error of the baseline\n");
  expectContains(csv, "\nbox,shake,4,17:21,,,,,,,,,,left out: the images stand still\n");
  // As many fields in each row.
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);)
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 13) << line;
}

TEST(CellRows, ShowRatiosBelowTheirCandidate) {
  const std::string text = textOf(comparedCell(0.5, 0.25, 0.5));
  expectContains(text,
                 "box right 0.5px 21: 0.66 px per frame; own error of the reference 0.100, and "
                 "0.01 false and missed events each\n");
  expectContains(text, "  phase_error dI_share dL_share\n");
  expectContains(text, " cpu_ms ");
  expectContains(text, "  old@2 ");
  expectContains(text, "  new@2 ");
  // 0.25 is below three times the reference's own error.
  expectContains(
      text, "  over the better baseline                    2x          (2x)            2x            2x ");
  expectContains(textOf(comparedCell(0.5, 0, 0.5)), " (-) ");
  EXPECT_EQ(textOf(leftOut()), "box shake 4px 17:21: left out: the images stand still\n\n");
}

TEST(CellRows, AreSummedUp) {
  std::vector<ComparedCell> cells = twoAndOneLeftOut();
  const std::string text = summaryText(cells, {"new@2"});
  expectContains(text, "\nnew@2\n");
  expectContains(
      text, "  dL_l1              0.5x  cells: 1, and 1 in brackets; largest: 0.5x in box right 0.5px 21\n");
  expectContains(text, "\nleft out: 1 of 3 cells\n");
  cells.erase(cells.begin());
  expectContains(summaryText(cells, {"new@2"}), "  dL_l1                 -  cells: 0, and 1 in brackets\n");
}

}  // namespace
}  // namespace saccade::eval
