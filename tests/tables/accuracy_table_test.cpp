#include "tables/accuracy_table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace saccade {
namespace {

const std::string kSettings =
    "cpu=\"A CPU @ 2 GHz\" trajectory=right size=100x50 rate_hz=500 frames=17:21 bounces=4 threshold=0.2 "
    "bias=0.001";
// The columns stand in no particular order and among others.
const std::string kColumns = "scene,method,spp,trace_ms,missed_events,false_events,cpu_ms";
const std::string kRows =
    "box,event_svgf,2,1,0.03,0.02,10\n"
    "box,event_svgf,4,1,0.02,0.01,18\n"
    "box,svgf:as_falcor=1,1,1,0.04,0.05,8\n"
    "box,pt,1,1,0.01,0.9,4\n"
    "ball,pt,1,1,0.1,0.2,7\n";

class AccuracyTableTest : public testing::Test {
 protected:
  ~AccuracyTableTest() override { std::filesystem::remove(path_); }

  AccuracyTable read(const std::string& text) const {
    std::ofstream(path_) << text;
    return readAccuracyTable(path_);
  }
  AccuracyTable table() const { return read("# " + kSettings + "\n" + kColumns + "\n" + kRows); }
  std::string faultOf(const std::string& text) const {
    try {
      read(text);
    } catch (const std::runtime_error& fault) {
      return fault.what();
    }
    return "none";
  }

  const std::string path_ = testing::TempDir() + "accuracy_table_test_" + std::to_string(getpid()) + ".csv";
};

// At the table's own size and C.
SettingsQuery box(const std::string& method = {}) {
  return {"box", 100 * 50, 0.2, method, 21};
}

template <class Fault>
std::string told(const std::function<void()>& act) {
  try {
    act();
  } catch (const Fault& fault) {
    return fault.what();
  }
  return "nothing";
}

TEST_F(AccuracyTableTest, IsReadByTheNamesOfItsColumns) {
  const AccuracyTable t = table();
  EXPECT_EQ(t.settings, kSettings);
  EXPECT_EQ(t.cpu, "A CPU @ 2 GHz");
  EXPECT_EQ(t.width, 100);
  EXPECT_EQ(t.height, 50);
  EXPECT_EQ(t.frames, 21);
  EXPECT_EQ(t.bounces, 4);
  EXPECT_EQ(t.threshold, 0.2);
  EXPECT_EQ(t.scenes(), (std::vector<std::string>{"ball", "box"}));
  ASSERT_EQ(t.rows.size(), 5u);
  EXPECT_EQ(t.rows[2].scene, "box");
  EXPECT_EQ(t.rows[2].method.name, "svgf");
  EXPECT_EQ(t.rows[2].method.params.at("as_falcor"), 1);
  EXPECT_EQ(t.rows[2].spp, 1);
  EXPECT_EQ(t.rows[2].cpu_ms, 8);
  EXPECT_EQ(t.rows[2].false_events, 0.05);
  EXPECT_EQ(t.rows[2].missed_events, 0.04);
}

TEST_F(AccuracyTableTest, FaultsNameFileAndLine) {
  const std::string head = "# " + kSettings + "\n", columns = head + kColumns + "\n", good = columns + kRows;
  const std::pair<std::string, const char*> faults[] = {
      {"", ":1: this is no chart's results"},
      {kColumns + "\n", ":1: this is no chart's results"},
      {"# cpu=\"A\" size=100x50 bounces=3\n" + kColumns + "\n", ":1: there is no threshold="},
      {"# cpu=\"A\" size=100x50y bounces=3 threshold=1\n", ":1: size is \"100x50y\""},
      {"# cpu=\"A\" size=100x0 bounces=3 threshold=1\n", ":1: size is"},
      {"# cpu=\"A\" size=100x50 frames=17 bounces=3 threshold=1\n", ":1: frames is \"17\", not A:B"},
      {"# cpu=\"A\" size=100x50 bounces=2.5 threshold=1\n", ":1: bounces must be a whole number"},
      {"# cpu=\"A\" size=100x50 bounces=3 threshold=0\n", ":1: threshold: 0 is outside"},
      {"# cpu=\"A\" size=100x50 bounces=3 threshold\n", ":1: \"threshold\" has no value"},
      {head, ":2: the names of the columns are missing"},
      {head + "scene,method,spp,cpu_ms,false_events\n", ":2: no column missed_events"},
      {good + "box,pt,1,1,0.01\n", ":8: 5 values for 7 columns"},
      {good + "box,magic,1,1,0,0,1\n", ":8: there is no method 'magic'"},
      {good + "box,svgf:alpha=9,1,1,0,0,1\n", ":8: alpha: 9 is outside"},
      {good + "box,event_svgf,3,1,0,0,1\n", ":8: event_svgf cannot run at 3 spp"},
      {good + "box,pt,one,1,0,0,1\n", ":8: spp is \"one\""},
      {good + "box,pt,1,1,0,nan,1\n", ":8: false_events: nan is outside"},
      {good + "box,pt,1,1,-0.1,0,1\n", ":8: missed_events: -0.1 is outside"},
      {good + "box,pt,1,1,0,0,1ms\n", ":8: cpu_ms is \"1ms\""},
  };
  for (const auto& [text, fault] : faults) {
    const std::string told = faultOf(text);
    EXPECT_EQ(told.find(path_ + fault), 0u) << told << "\nnot: " << fault;
  }
  std::filesystem::remove(path_);
  EXPECT_EQ(told<std::runtime_error>([&] { readAccuracyTable(path_); }), path_ + ": cannot be read");
}

// Time grows with the pixels, rates with 1 / C [E (34)].
// As an evaluation that was refused once left it: a server would promise budgets that it has not.
TEST_F(AccuracyTableTest, WithoutARowIsAFault) {
  EXPECT_NE(faultOf("# " + kSettings + "\n" + kColumns + "\n").find(": no row"), std::string::npos);
}

TEST_F(AccuracyTableTest, IsScaledToWhatIsRendered) {
  const auto at = settingsFor(table(), {"ball", 200 * 75, 0.05, {}, 500});
  ASSERT_EQ(at.size(), 1u);
  EXPECT_DOUBLE_EQ(at[0].cpu_ms, 7 * 3.0);
  EXPECT_DOUBLE_EQ(at[0].false_events, 0.2 * 4);
  EXPECT_DOUBLE_EQ(at[0].missed_events, 0.1 * 4);
}

// The small picture takes 4 of 10 ms, so that 2 ms are fixed. Late frames take half as long.
TEST_F(AccuracyTableTest, KnowsTheFixedPartAndLateFramesWhereTheyWereMeasured) {
  const AccuracyTable t = read("# " + kSettings +
                               "\nscene,method,spp,missed_events,false_events,cpu_ms,small_ms,"
                               "small_late_ms\nbox,pt,1,0,0,10,4,2\nball,pt,1,0,0,10,nan,nan\n");
  const auto msOf = [&](const char* scene, double frames) {
    return settingsFor(t, {scene, 4 * 5000, 0.2, {}, frames})[0].cpu_ms;
  };
  EXPECT_DOUBLE_EQ(msOf("box", 21), 2 + 4 * 8);
  EXPECT_DOUBLE_EQ(msOf("box", 42), 0.75 * 34);
  EXPECT_DOUBLE_EQ(msOf("box", INFINITY), 0.5 * 34);
  EXPECT_DOUBLE_EQ(msOf("ball", 42), 40);
}

TEST_F(AccuracyTableTest, TheMostAccurateWithinATime) {
  const auto any = settingsFor(table(), box());
  const auto chosen = [&](double ms) {
    const MeasuredSetting s = mostAccurate(any, ms);
    return s.method.text + " " + std::to_string(s.spp);
  };
  EXPECT_EQ(chosen(1000), "event_svgf 4");
  EXPECT_EQ(chosen(18), "event_svgf 4");  // the limit itself is within it
  EXPECT_EQ(chosen(17.9), "event_svgf 2");
  EXPECT_EQ(chosen(9), "svgf:as_falcor=1 1");
  EXPECT_EQ(chosen(5), "pt 1");
  EXPECT_EQ(mostAccurate(settingsFor(table(), box("pt")), 1000).method.text, "pt");
  // Missed events count as much as false ones.
  const auto both =
      settingsFor(read("# " + kSettings + "\n" + kColumns + "\na,pt,1,1,0.05,0.01,1\na,pt,2,1,0.01,0.04,1\n"),
                  {"a", 5000, 0.2, {}, 21});
  EXPECT_EQ(mostAccurate(both, 1).spp, 2);
}

TEST_F(AccuracyTableTest, TheFastestWithinARate) {
  const auto any = settingsFor(table(), box());
  EXPECT_EQ(fastest(any, 1).method.text, "pt");
  EXPECT_EQ(fastest(any, 0.05).method.text, "svgf:as_falcor=1");
  EXPECT_EQ(fastest(any, 0.02).spp, 2);
  EXPECT_EQ(fastest(any, 0.019).spp, 4);
  EXPECT_EQ(fastest(settingsFor(table(), box("event_svgf")), 1).spp, 2);
}

TEST_F(AccuracyTableTest, NamesTheNearestRowWhereNoneFits) {
  const auto any = settingsFor(table(), box());
  EXPECT_EQ(told<NothingFits>([&] { mostAccurate(any, 3); }),
            "the fastest setting here, pt at 1 spp, takes 4 ms");
  EXPECT_EQ(told<NothingFits>([&] { fastest(any, 0.001); }),
            "the lowest rate here, of event_svgf at 4 spp, is 0.01 false events per pixel-frame");
}

TEST_F(AccuracyTableTest, NamesTheSceneOrMethodThatIsNotMeasured) {
  EXPECT_EQ(told<NotMeasured>([&] {
              settingsFor(table(), {"room", 5000, 0.2, {}, 21});
            }),
            "no scene of this name is measured: room; measured are: ball, box");
  EXPECT_EQ(told<NotMeasured>([&] { settingsFor(table(), box("pt-correlated")); }),
            "pt-correlated is not measured on box; measured are: event_svgf, pt, svgf");
}

}  // namespace
}  // namespace saccade
