// Folders of scenes that hold odd things.
#include <sys/stat.h>

#include "base/text_cut.h"
#include "scene/camera/motion.h"
#include "scene/library/scene_library.h"
#include "scene/scene_texts.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using test::kSensor;

// Folders that hold odd things, beside one that is as it should be.
class OddFolders : public testing::Test {
 protected:
  OddFolders() { files_.write("good/scene.xml", kGood); }

  const std::string kGood = std::string(kSensor) + "</scene>";

  std::string at(const std::string& name) { return files_.path(name); }
  void makeFifo(const std::string& name) { ASSERT_EQ(mkfifo(at(name).c_str(), 0600), 0) << name; }
  void makeHuge(const std::string& name) {
    files_.write(name, "Much.\n");
    fs::resize_file(at(name), std::uintmax_t{2} << 30);  // a hole, that takes no place on the disk
  }
  // Lists the scenes: `name`, and the good one, which is not touched.
  SceneEntry entry(const std::string& name) {
    const auto entries = SceneLibrary(files_.path("")).list();
    EXPECT_EQ(entries.size(), name == "good" ? 1u : 2u);
    SceneEntry found;
    for (const SceneEntry& entry : entries) {
      if (entry.name == name) found = entry;
      EXPECT_TRUE(entry.name == name || entry.unavailable.empty()) << entry.unavailable;
      EXPECT_TRUE(isUtf8(entry.name) && isUtf8(entry.description) && isUtf8(entry.unavailable));
    }
    EXPECT_EQ(found.name, name);
    return found;
  }
  void expectUnavailable(const std::string& name, const std::string& why) {
    expectContains(entry(name).unavailable, why);
    if (isUtf8(name)) expectContains(errorOf([&] { SceneLibrary(files_.path("")).load(name); }), why);
    EXPECT_EQ(entry(name).trajectories, motionNames());
  }

  const Scratch files_;
};

TEST_F(OddFolders, AFifoOrAFolderIsNoSceneFile) {
  fs::create_directories(at("fifo"));
  makeFifo("fifo/scene.xml");
  expectUnavailable("fifo", "fifo/scene.xml: cannot be read: is not a plain file");
  fs::remove_all(at("fifo"));
  fs::create_directories(at("folder/scene.xml"));
  expectUnavailable("folder", "folder/scene.xml: cannot be read: is not a plain file");
}

TEST_F(OddFolders, LinksInCirclesAreToldBySceneAndHurtNoOther) {
  fs::create_symlink("loop", at("loop"));
  expectUnavailable("loop", "loop/scene.xml: Too many levels of symbolic links");
  fs::remove(at("loop"));
  fs::create_directories(at("scene"));
  fs::create_symlink("scene.xml", at("scene/scene.xml"));
  expectUnavailable("scene", "scene/scene.xml: Too many levels of symbolic links");
  fs::remove(at("scene/scene.xml"));
  files_.write("scene/scene.xml", kGood);
  fs::create_symlink("trajectories", at("scene/trajectories"));
  expectContains(entry("scene").unavailable, "scene/trajectories: is not a folder that can be read");
}

TEST_F(OddFolders, ALinkThatLeadsNowhereIsTold) {
  fs::create_directories(at("scene"));
  fs::create_symlink("nowhere", at("scene/scene.xml"));
  expectUnavailable("scene", "scene/scene.xml: cannot be read: No such file or directory");
}

TEST_F(OddFolders, AReadmeOfAnyKindLeavesItsSceneAlone) {
  makeFifo("good/README.md");
  expectContains(entry("good").description, "no description: " + at("good/README.md"));
  fs::remove(at("good/README.md"));
  fs::create_directories(at("good/README.md"));
  expectContains(entry("good").description, "no description: ");
  fs::remove(at("good/README.md"));
  fs::create_symlink("README.md", at("good/README.md"));
  expectContains(entry("good").description, "no description: ");
  fs::remove(at("good/README.md"));
  files_.write("good/README.md", "# good\n\n\xFF" + std::string(5000, 'a'));
  EXPECT_EQ(entry("good").description, "\uFFFD" + std::string(997, 'a') + "...");
}

TEST_F(OddFolders, ATitleAndAPictureOfAReadmeDescribeNothing) {
  files_.write("good/README.md", "# good\n\n![what it shows](a.png)\n\nA box.\n");
  EXPECT_EQ(entry("good").description, "A box.");
}

TEST_F(OddFolders, HugeFilesAreNotReadToTheirEnds) {
  makeHuge("good/README.md");
  EXPECT_EQ(entry("good").description, "Much.");
  makeHuge("huge/scene.xml");
  expectUnavailable("huge", "huge/scene.xml: has more than 67108864 bytes");
}

TEST_F(OddFolders, ANameThatIsNoUtf8IsShownButCannotBeAsked) {
  files_.write("x\xFF/scene.xml", "<scene/>");
  expectContains(entry("x\uFFFD").unavailable, "is not UTF-8");
  files_.write("good/trajectories/\xFF.csv", "0 0 0 0 0 0 0 1");
  files_.write("good/trajectories/path.csv", "0 0 0 0 0 0 0 1");
  fs::remove_all(at("x\xFF"));
  EXPECT_EQ(entry("good").trajectories.size(), motionNames().size() + 1);
}

TEST_F(OddFolders, AFifoAsTrajectoryIsNamed) {
  fs::create_directories(at("good/trajectories"));
  makeFifo("good/trajectories/path.csv");
  expectContains(errorOf([&] { SceneLibrary(at("")).loadTrajectory("good", "path"); }),
                 "path.csv: cannot be read: is not a plain file");
}
}  // namespace
}  // namespace saccade
