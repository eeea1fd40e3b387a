#include "scene/files/file_loads.h"

#include "base/cancelled.h"
#include "scene/files/limits.h"
#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

// Meshes of 1, 2, 3 ... triangles.
std::string manyMeshes(const Scratch& files, int count) {
  std::string body, mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < count; ++i) {
    const std::string name = "m" + std::to_string(i) + ".obj";
    files.write(name, mesh += "f 1 2 3\n");
    body += "<shape type='obj'><string name='filename' value='" + name + "'/></shape>\n";
  }
  return body;
}

TEST(FileLoads, MeshesStandInTheOrderOfTheFileWhateverTheThreads) {
  const Scratch files;
  const std::string body = manyMeshes(files, 20);
  for (const int threads : {1, 4}) {
    const Scene scene = loadBody(files, body, "3.0.0", {.threads = threads});
    ASSERT_EQ(scene.meshes.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_EQ(scene.meshes[i].triangles.size(), i + 1);
      EXPECT_EQ(scene.meshes[i].name, "m" + std::to_string(i));
    }
  }
}

TEST(FileLoads, ProgressCountsEveryFileOnce) {
  const Scratch files;
  const std::string body = manyMeshes(files, 9);
  std::vector<int> seen;
  loadBody(files, body, "3.0.0", {.threads = 3, .progress = [&](int done, int total) {
                                    EXPECT_EQ(total, 9);
                                    seen.push_back(done);
                                  }});
  EXPECT_EQ(seen, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(FileLoads, NoMoreFilesAreReadAfterAStop) {
  const Scratch files;
  const std::string body = manyMeshes(files, 9);
  std::stop_source stopped;
  int read = 0;
  LoadOptions options{.threads = 1, .stop = stopped.get_token()};
  options.progress = [&](int done, int) {
    if ((read = done) == 2) stopped.request_stop();
  };
  EXPECT_THROW(loadBody(files, body, "3.0.0", options), Cancelled);
  EXPECT_EQ(read, 2);
}

TEST(FileLoads, TheFirstFaultInTheFileIsTheOneThatIsTold) {
  const Scratch files;
  const std::string body = manyMeshes(files, 20);
  files.write("m7.obj", "v 0 0\n");
  files.write("m11.obj", "f 1 2 3\n");
  for (int repeat = 0; repeat < 5; ++repeat) {
    const std::string error = errorOf([&] { loadBody(files, body, "3.0.0", {.threads = 4}); });
    expectContains(error, "scene.xml:10: ");
    expectContains(error, "m7.obj:1: ");
  }
}

TEST(FileLoads, PicturesOfASceneAreBoundedTogether) {
  FileLoads loads;
  loads.takePixels(kMaxPicturePixels);
  EXPECT_NO_THROW(loads.takePixels(kMaxScenePixels - kMaxPicturePixels));
  expectContains(errorOf([&] { loads.takePixels(1); }), "more than 268435456 pixels together");
}

}  // namespace
}  // namespace saccade
