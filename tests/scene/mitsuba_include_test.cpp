#include "scene/files/limits.h"
#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

std::string include(const std::string& file) {
  return "<include filename='" + file + "'/>";
}
std::string scene(const std::string& body) {
  return "<?xml version='1.0'?>\n<scene version='3.0.0'>\n" + body + "\n</scene>\n<!-- end -->\n";
}
std::string sphere(const std::string& radius, const std::string& inside = {}) {
  return "<shape type='sphere'><float name='radius' value='" + radius + "'/>" + inside + "</shape>";
}

struct MitsubaInclude : testing::Test {
  std::string error(const std::string& body, const LoadOptions& options = {}) const {
    return errorOf([&] { loadBody(files, body, "3.0.0", options); });
  }
  Scratch files;
};

TEST_F(MitsubaInclude, PutsObjectsInTheirPlace) {
  files.write("parts/paint.xml", scene("<bsdf type='diffuse' id='red'><rgb name='reflectance' "
                                       "value='1, 0, 0'/></bsdf>"));
  files.write("parts/balls.xml",
              scene(include("parts/paint.xml") + "\n" + sphere("$size", "<ref id='red'/>") + sphere("3")));
  const Scene s = loadBody(
      files,
      sphere("1") +
          "<default name='size' value='2'/><default name='which' value='balls'/><include filename='" +
          "parts/$which.xml'></include>" + sphere("4", "<ref id='red'/>"),
      "3.0.0' comment='a > b");
  ASSERT_EQ(s.spheres.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(s.spheres[static_cast<std::size_t>(i)].radius, i + 1);
  for (const std::size_t red : {1u, 3u})
    EXPECT_EQ(s.materials[static_cast<std::size_t>(s.spheres[red].material)].name, "red");
}

TEST_F(MitsubaInclude, FaultsNameTheFileAndTheLineThatTheyAreOn) {
  files.write("ball.xml", scene("\n<!-- > -->" + sphere("2") + "\n" + sphere("none")));
  files.write("good.xml", scene("\n\n" + sphere("2")));
  files.write("torn.xml", "<scene>\n<shape>\n</scene>");
  files.write("model.xml", "\n<model/>");
  expectContains(error("\n" + include("ball.xml")), files.path("ball.xml") + ":5: 'none' is not a finite");
  expectContains(error("\n" + include("good.xml") + "\n" + sphere("none")),
                 files.path("scene.xml") + ":5: 'none'");
  expectContains(error(include("torn.xml")), files.path("torn.xml") + ":3: faulty XML");
  expectContains(error(include("model.xml")),
                 files.path("model.xml") + ":2: the root element is not <scene>");
  files.write("two.xml", "<scene>\n</scene>\n<scene/>");
  expectContains(error(include("two.xml")), files.path("two.xml") + ":3: a second root element");
  expectContains(error("\n" + include("absent.xml")), files.path("scene.xml") + ":4: ");
  expectContains(error(include("absent.xml")), "absent.xml: cannot be read");
  expectContains(error("\n" + include("$which.xml")), "scene.xml:4: $which is not defined");
  EXPECT_EQ(error(include("$which.xml")).rfind("scene.xml:3: "),
            error(include("$which.xml")).find("scene.xml:3: "));
  expectContains(error("<include/>"), "scene.xml:3: ");
  expectContains(error("<include filename='good.xml'><path/></include>"), "has no elements within it");
}

TEST_F(MitsubaInclude, EndsOfScenesInCommentsAreNoEnds) {
  files.write("a.xml",
              "<!-- <scene> --><scene><!-- </scene> -->" + sphere("2") + "</scene  ><!-- </scene> -->");
  const Scene s = loadBody(files, "<!-- </scene> -->" + include("a.xml") + sphere("3") + "<!-- -->");
  ASSERT_EQ(s.spheres.size(), 2u);
  EXPECT_EQ(s.spheres[0].radius, 2);
}

TEST_F(MitsubaInclude, AFileThatIncludesItselfIsRefused) {
  files.write("a.xml", scene(include("b.xml")));
  files.write("b.xml", scene("\n" + include("./a.xml")));
  const std::string told = error(include("a.xml"));
  expectContains(told, files.path("b.xml") + ":4: the file includes itself: ");
  expectContains(told, "a.xml, ");
  expectContains(error(include("scene.xml")), "scene.xml:3: the file includes itself: ");
}

TEST_F(MitsubaInclude, NumberDepthAndBytesAreBounded) {
  for (int i = 0; i <= static_cast<int>(kMaxIncludeDepth); ++i)
    files.write("d" + std::to_string(i) + ".xml", scene(include("d" + std::to_string(i + 1) + ".xml")));
  expectContains(error(include("d0.xml")), "or 16 within each other");
  files.write("empty.xml", "<scene/>");
  std::string many;
  for (int i = 0; i < kMaxIncludes; ++i) many += include("empty.xml");
  EXPECT_TRUE(loadBody(files, many).meshes.empty());
  expectContains(error(many + include("empty.xml")), "more than 1000 includes");
  files.write("long.xml", scene(std::string(kMaxXmlBytes / 2, ' ')));
  expectContains(error(include("long.xml") + include("long.xml")),
                 "the included files have more than 67108864");
}

TEST_F(MitsubaInclude, NoFileOutsideOfTheScenesIsIncluded) {
  const Scratch other;
  const std::string secret = other.write("secret.xml", scene(sphere("1")));
  files.write("all.xml", scene(sphere("1")));
  LoadOptions confined;
  confined.confined_to = {files.path("")};
  EXPECT_EQ(loadBody(files, include("all.xml"), "3.0.0", confined).spheres.size(), 1u);
  expectContains(error(include(secret), confined), "leads out of the folder of the scenes");
  expectContains(error("<path value='" + other.path("") + "'/>" + include("secret.xml"), confined),
                 "leads out of the folder of the scenes");
  expectContains(error("<path value='" + other.path("") + "'/>", confined),
                 "scene.xml:3: " + other.path("") + " leads out of the folder of the scenes");
}

TEST_F(MitsubaInclude, APathIsAFolderToLookIn) {
  files.write("models/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  files.write("models/part.xml", scene("<shape type='obj'><string name='filename' value='a.obj'/></shape>"));
  EXPECT_EQ(loadBody(files, "<path value='models'/>" + include("part.xml")).meshes.at(0).name, "a");
  expectContains(error(include("part.xml")), "part.xml: cannot be read");
  expectContains(error("<path value='none'/>"),
                 "scene.xml:3: a <path> needs value=\"FOLDER\"; there is no folder");
  expectContains(error("<path/>"), "scene.xml:3: a <path> needs value=\"FOLDER\"");
  expectContains(error(sphere("1", "<path value='models'/>")), "<path> is not supported in <shape");
}

}  // namespace
}  // namespace saccade
