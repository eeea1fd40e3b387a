#include "client/options/usage_check.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

class UsageCheck : public testing::Test {
 protected:
  UsageCheck() {
    CLI::App* record = app_.add_subcommand("record");
    record->add_option("scene", scene_);
    record->add_option("--size", size_);
    record->add_option("-o,--output", output_);
    record->add_option("--threshold", thresholds_)->allow_extra_args(false);
    record->add_flag("--jitter", jitter_);
    app_.add_subcommand("list");
  }
  std::string faultOf(const std::vector<std::string>& words) const { return usageFault(app_, words); }

 private:
  CLI::App app_;
  std::string scene_, size_, output_;
  std::vector<double> thresholds_;
  bool jitter_ = false;
};

TEST_F(UsageCheck, ARightCommandLineHasNoFault) {
  EXPECT_EQ(faultOf({}), "");
  EXPECT_EQ(faultOf({"--help"}), "");
  EXPECT_EQ(faultOf({"list"}), "");
  EXPECT_EQ(faultOf({"record", "box", "--size=3x4", "-o", "a", "--threshold", "1", "--threshold", "-1",
                     "--jitter"}),
            "");
}

TEST_F(UsageCheck, AMisspeltCommandIsTold) {
  EXPECT_EQ(faultOf({"recrod", "box"}), "unknown command 'recrod'; did you mean record?");
  EXPECT_EQ(faultOf({"fly"}), "unknown command 'fly'");
}

TEST_F(UsageCheck, AMisspeltOptionIsTold) {
  EXPECT_EQ(faultOf({"record", "box", "--treshold", "0.2"}),
            "unknown option '--treshold'; did you mean --threshold?");
  EXPECT_EQ(faultOf({"record", "--sise=3x4"}), "unknown option '--sise'; did you mean --size?");
  EXPECT_EQ(faultOf({"list", "--frobnicate"}), "unknown option '--frobnicate'");
}

TEST_F(UsageCheck, AnUnknownShortOptionIsTold) {
  EXPECT_EQ(faultOf({"record", "-V"}), "unknown option '-V'");
  EXPECT_EQ(faultOf({"-V"}), "unknown option '-V'");
  EXPECT_EQ(faultOf({"record", "-oa.csv"}), "");
}

TEST_F(UsageCheck, AnEmptyValueIsTold) {
  EXPECT_EQ(faultOf({"record", "--size", ""}), "--size is empty");
  EXPECT_EQ(faultOf({"record", "--size="}), "--size is empty");
  EXPECT_EQ(faultOf({"record", ""}), "an argument is empty");
}

TEST_F(UsageCheck, AnOptionThatIsGivenTwiceIsTold) {
  EXPECT_EQ(faultOf({"record", "--size", "1x1", "--size", "2x2"}), "--size is given twice");
  EXPECT_EQ(faultOf({"record", "-o", "a", "--output=b"}), "--output is given twice");
}

}  // namespace
}  // namespace saccade::client
