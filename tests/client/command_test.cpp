// The errors of the `saccade` command, and its lists.
#include "client/command.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace test;

TEST(Command, WrongUsageIsCode2) {
  for (const char* line : {"", "fly", "record", "record cornell-box --trajectory right -o a.xyz",
                           "record cornell-box --trajectory right -o a.csv --size 3",
                           "record cornell-box --trajectory right -o a.csv --format evt3", "help fly",
                           "record cornell-box --motion pan: -o a.csv", "list --control nonsense"}) {
    EXPECT_EQ(run(line).code, 2) << line;
  }
  EXPECT_EQ(run("--help").code, 0);
}

TEST(Command, WrongUsageIsToldInOneLine) {
  for (const char* line :
       {"", "record", "recrod cornell-box", "record cornell-box --trajectory right -o a.csv --frob",
        "record cornell-box --trajectory right -o a.csv --delivery pigeon",
        "record cornell-box --trajectory none.csv -o a.csv"}) {
    const Result result = run(line);
    EXPECT_EQ(result.output.find("saccade: "), 0u) << result.output;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
  }
}

TEST(Command, AllProgramsTellOneVersion) {
  const auto told = [](const std::string& program) {
    Child child(program + " --version");
    return finish(child);
  };
  const Result version = told(SACCADE_COMMAND);
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.output, SACCADE_VERSION "\n");
  for (const std::string program : {SACCADE_SERVER, SACCADE_EVAL})
    EXPECT_EQ(told(program).output, version.output);
}

TEST(Command, HelpIsACommandToo) {
  EXPECT_EQ(run("help").output, run("--help").output);
  EXPECT_EQ(run("help record").output, run("record --help").output);
  EXPECT_EQ(run("help record").code, 0);
}

TEST(Command, WithoutAServerTheCodeIs1AndTheMessageSaysWhatToDo) {
  const Result result = run("info --wait 0.05 --control tcp://127.0.0.1:1");
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result, "no saccaded answers at tcp://127.0.0.1:1: start it with")) << result.output;
  EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1);
}
TEST(Command, WarnsAboutASecretKeyThatAllMayRead) {
  const ScratchFolder folder;
  const std::string name = folder.at("alice");
  ASSERT_EQ(run("keygen " + name).code, 0);
  const std::string info = "info --wait 0.05 --control tcp://127.0.0.1:1 --secret-key " + name +
                           ".key --server-key " + name + ".pub";
  EXPECT_FALSE(holds(run(info), "can read"));
  fs::permissions(name + ".key", fs::perms::others_read, fs::perm_options::add);
  EXPECT_TRUE(
      holds(run(info), "saccade: every user of this machine can read the secret key " + name + ".key"));
}
TEST_F(CommandAndServer, ListsScenesAndMethods) {
  const Result info = run("info --wait 30" + server_.option());
  EXPECT_EQ(info.code, 0);
  EXPECT_TRUE(holds(info, "event_svgf") && holds(info, "alpha") && holds(info, "budgets")) << info.output;
  const Result list = run("list" + server_.option());
  EXPECT_EQ(list.code, 0);
  EXPECT_TRUE(holds(list, "cornell-box") && holds(list, "right")) << list.output;
  EXPECT_TRUE(holds(list, "such as pan:10, with KIND one of dolly, truck") && holds(list, "random"))
      << list.output;
}
TEST_F(CommandAndServer, RefusalsNameWhatIsValid) {
  const Result scene = run("record nowhere --trajectory right -o a.csv" + server_.option());
  EXPECT_EQ(scene.code, 2);
  EXPECT_TRUE(holds(scene, "scene:") && holds(scene, "cornell-box")) << scene.output;
  const Result threshold = run(
      "record cornell-box --trajectory right --threshold 0.2 --threshold nan -o a.csv" + server_.option());
  EXPECT_EQ(threshold.code, 2);
  EXPECT_TRUE(holds(threshold, "--threshold: nan is outside")) << threshold.output;
  const Result output =
      run("record cornell-box --trajectory right -o " + folder_.at("none/a.csv") + server_.option());
  EXPECT_EQ(output.code, 2);
  EXPECT_TRUE(holds(output, "--output: ") && holds(output, "none/a.csv")) << output.output;
}
TEST_F(CommandAndServer, ARefusalNamesTheOptionTheValueAndWhatIsValid) {
  const struct {
    std::string options, fault, valid;
  } rows[] = {{"--motion pan", "--trajectory: 'pan' is a motion, which needs a speed, such as pan:10", ""},
              {"--motion rihgt", "--trajectory: the scene has no trajectory 'rihgt'", "KIND one of dolly"},
              {"", "--trajectory: none is given; the scene has: ", "right"},
              {"--motion pan:1 --start nan,0,0", "--start: nan is outside", "[-1000000000, 1000000000]"},
              {"--motion pan:1 --start 0,0,0,0,0,0,0", "--start: the length of the quaternion", ""},
              {"--motion right --preset eye", "--preset: there is no preset 'eye'", "davis346"},
              {"--motion right --method magic", "--method: there is no method 'magic'", "event_svgf"},
              {"--motion right --spp 3 --method event_svgf", "--spp: ", "even"},
              {"--motion right --disable sky", "--disable: ", "textures"},
              {"--motion right --truth dept", "--truth: there is no truth channel 'dept'", "depth"},
              {"--motion right --noise leak_hz=-1", "--noise: -1 is outside", "[0, 1000]"}};
  for (const auto& [options, fault, valid] : rows) {
    const Result result =
        run("record cornell-box -o " + folder_.at("a.csv") + " " + options + server_.option());
    EXPECT_EQ(result.code, 2) << options;
    EXPECT_EQ(result.output.find("saccade: " + fault), 0u) << result.output;
    EXPECT_TRUE(holds(result, valid)) << result.output;
  }
}

TEST_F(CommandAndServer, AFaultyTrajectoryIsNamedOnceByItsFile) {
  const std::string file = folder_.at("nan.csv");
  std::ofstream(file) << "0 0 0 0 0 0 0 1\n1 0 0 nan 0 0 0 1\n";
  const Result result =
      run("record cornell-box --trajectory " + file + " -o " + folder_.at("a.csv") + server_.option());
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.output, "saccade: " + file + ": line 2: 'nan' is not a finite number\n");
}

}  // namespace
}  // namespace saccade
