#include "client/options/help_formatter.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

class Help : public testing::Test {
 protected:
  Help() {
    app_.formatter(std::make_shared<HelpFormatter>());
    app_.set_help_all_flag("--help-all", "show all options");
    app_.add_option("scene", size_, "name of a scene");
    app_.add_option("-s,--size", size_, "of the image")->group("Camera");
    app_.add_option("--distortion", size_, "of the lens")->group("Camera");
    showInHelp(app_, {"--size"});
  }

  CLI::App app_;
  std::string size_;
};

TEST_F(Help, RareOptionsAreCountedAndLeftOut) {
  const std::string text = app_.help();
  EXPECT_NE(text.find("--size"), text.npos);
  EXPECT_NE(text.find("name of a scene"), text.npos);
  EXPECT_EQ(text.find("--distortion"), text.npos) << text;
  EXPECT_NE(text.find("--help-all shows 1 more options."), text.npos) << text;
}

TEST_F(Help, AllOptionsAreShownWhereAllAreAskedFor) {
  const std::string text = app_.help("", CLI::AppFormatMode::All);
  EXPECT_NE(text.find("--size"), text.npos);
  EXPECT_NE(text.find("--distortion"), text.npos) << text;
  EXPECT_EQ(text.find("more options"), text.npos) << text;
}

}  // namespace
}  // namespace saccade::client
