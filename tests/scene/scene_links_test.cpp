// Names and links never lead out of the folder of the scenes.
#include "scene/library/scene_library.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/scene_texts.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using test::kSensor, test::kTriangle;

// A scene of `body` beside a folder `secret` that is not the library's.
std::string errorOfOutsider(const Scratch& files, const std::string& body) {
  files.write("secret/a.obj", kTriangle);
  files.write("scenes/meshes/b.obj", kTriangle);
  files.write("scenes/mine/scene.xml", kSensor + ("\n" + body) + "</scene>");
  return errorOf([&] { SceneLibrary(files.path("scenes")).load("mine"); });
}

TEST(SceneLinks, AScenesFilesStayWithinTheFolderOfTheScenes) {
  const Scratch files;
  const auto mesh = [](const std::string& filename) {
    return "<shape type='obj'><string name='filename' value='" + filename + "'/></shape>";
  };
  EXPECT_EQ(errorOfOutsider(files, mesh("../meshes/b.obj")), "no error");
  for (const std::string& name : {std::string("../../secret/a.obj"), files.path("secret/a.obj")}) {
    const std::string error = errorOfOutsider(files, mesh(name));
    expectContains(error, "scene.xml:2: ");
    expectContains(error, "a.obj leads out of the folder of the scenes");
  }
  fs::create_directory_symlink(files.path("secret"), files.path("scenes/mine/models"));
  expectContains(errorOfOutsider(files, mesh("models/a.obj")), "leads out of the folder");
  EXPECT_NO_THROW(loadMitsubaXml(files.path("scenes/mine/scene.xml")));  // nothing confines it by hand
  expectContains(errorOfOutsider(files,
                                 "<shape type='cube'><bsdf type='diffuse'><texture type='bitmap' "
                                 "name='reflectance'><string name='filename' value='../../secret/a.png'/>"
                                 "</texture></bsdf></shape>"),
                 "a.png leads out");
}

TEST(SceneLinks, ALinkThatLeadsOutIsNoScene) {
  const Scratch files;
  files.write("secret/scene.xml", "<scene/>");
  files.write("scenes/README.md", "");
  fs::create_directory_symlink(files.path("secret"), files.path("scenes/linked"));
  const SceneLibrary library(files.path("scenes"));
  expectContains(errorOf([&] { library.load("linked"); }), "leads out of the folder");
  expectContains(library.list().at(0).unavailable, "leads out of the folder");
}

TEST(SceneLinks, LinksToOtherPeoplesTextAreNotRead) {
  const Scratch files;
  const std::string secret = files.write("secret.txt", "A password.");
  files.write("scenes/mine/scene.xml", "<scene/>");
  fs::create_directory(files.path("scenes/mine/trajectories"));
  fs::create_symlink(secret, files.path("scenes/mine/README.md"));
  fs::create_symlink(secret, files.path("scenes/mine/trajectories/path.csv"));
  const SceneLibrary library(files.path("scenes"));
  EXPECT_EQ(library.list().at(0).description, "no description: " + files.path("scenes/mine/README.md") +
                                                  " leads out of the folder of the scenes");
  expectContains(errorOf([&] { library.loadTrajectory("mine", "path"); }), "leads out of the folder");
}
}  // namespace
}  // namespace saccade
