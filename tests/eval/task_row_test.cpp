#include "eval/tasks/task_row.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/tasks/task_chart.h"

namespace saccade::eval {
namespace {

const Task& task(std::size_t i) {
  return taskTable()[i];
}

TaskRow row(const std::string& method, int spp, std::size_t i, std::vector<TaskScore> scores, double cpu_ms) {
  return {"box", kNoNoise, method, spp, &task(i), std::move(scores), cpu_ms, 0.25};
}

std::vector<TaskRow> rows() {
  return {row(kReferenceSource, 512, 0, {{0.1, 10}}, 0), row(kReferenceSource, 512, 1, {{0.2, 4}}, 0),
          row("svgf", 2, 0, {{0.3, 10}, {0.5, 20}}, 4),  row("svgf", 2, 1, {{}, {}}, 4),
          row("svgf", 8, 0, {{0.2, 10}, {0.2, 20}}, 16), row("svgf", 8, 1, {{}, {0.7, 3}}, 16)};
}

TEST(TaskRow, MeansAreOverTheSeedsWithAnAnswer) {
  const TaskRow all = rows()[2], none = rows()[3], some = rows()[5];
  EXPECT_DOUBLE_EQ(all.error(), 0.4);
  EXPECT_NEAR(all.standardError(), 0.1, 1e-12);  // sqrt(2 * 0.1^2 / 1 / 2)
  EXPECT_DOUBLE_EQ(all.answers(), 15);
  EXPECT_TRUE(std::isnan(none.error()));
  EXPECT_DOUBLE_EQ(some.error(), 0.7);
  EXPECT_TRUE(std::isnan(some.standardError()));
  EXPECT_DOUBLE_EQ(some.answers(), 1.5);
}

TEST(TaskRows, MakeATableForEachView) {
  std::vector<TaskRow> all = rows();
  EXPECT_EQ(csvOf({all[2]}),
            "scene,noise,task,method,spp,cpu_ms,events,error,standard_error,answers\n"
            "box,none,normal_flow,svgf,2,4,0.25,0.4,0.1,15\n");
  EXPECT_NE(csvOf({all[3]}).find(",0.25,nan,nan,0\n"), std::string::npos);
  for (TaskRow noisy : rows()) noisy.noise = "davis346", all.push_back(noisy);
  const std::string table = tableOf(all);
  EXPECT_EQ(table.find("box\n"), 0u) << table;
  EXPECT_NE(table.find("\nbox, noise of davis346\n"), table.npos) << table;
  EXPECT_NE(table.find("svgf@2                            4.00    0.2500          0.4000               -\n"),
            table.npos)
      << table;
}

TEST(TaskRows, MakeAPanelForEachTask) {
  const std::string svg = chartOf(rows());
  EXPECT_NE(svg.find("box: normal_flow"), svg.npos);
  EXPECT_NE(svg.find("box: patch_flow"), svg.npos);
  EXPECT_NE(svg.find(">reference<"), svg.npos);
  EXPECT_NE(svg.find(">8 spp<"), svg.npos);
  EXPECT_EQ(svg.find("nan,"), svg.npos);
  EXPECT_EQ(svg.find(",nan"), svg.npos);
}

}  // namespace
}  // namespace saccade::eval
