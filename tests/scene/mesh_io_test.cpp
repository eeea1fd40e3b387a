#include "scene/mesh/mesh_io.h"

#include <sys/stat.h>

#include <bit>
#include <cstdint>

#include "scene/files/limits.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

Mesh obj(const std::string& text) {
  const Scratch files;
  return loadObj(files.write("a mesh.obj", text));
}

std::string objError(const std::string& text) {
  return errorOf([&] { obj(text); });
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, PolygonsBecomeFans) {
  const Mesh mesh = obj(kSquare + "v 0 0.5 1\nf 1 2 3 4 5\n");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(mesh.positions[4], (Vec3{0, 0.5f, 1}));
}

TEST(Obj, FacesWithoutAnAreaAreLeftOut) {
  EXPECT_EQ(obj(kSquare + "f 1 2\nf 3\nf 1 2 3\n").triangles.size(), 1u);
  expectContains(objError(kSquare + "f 1 2\n"), "the file has no faces");
  expectContains(objError(kSquare + "f\n"), ":5: a face needs corners");
}

TEST(Obj, NegativeIndicesCountFromTheEndSoFar) {
  const Mesh mesh = obj(kSquare + "f -4 -3 -2\nv 9 9 9\nf -1 1 2\n");
  EXPECT_EQ(mesh.positions[mesh.triangles[0][0]], (Vec3{0, 0, 0}));
  EXPECT_EQ(mesh.positions[mesh.triangles[1][0]], (Vec3{9, 9, 9}));
}

TEST(Obj, CornersOfEqualIndicesShareAVertex) {
  const Mesh mesh = obj(kSquare + "vt 0 0\nvt 1 0\nf 1/1 2/1 3/1\nf 1/1 3/1 4/2\nf 1/2 3/1 4/2\n");
  EXPECT_EQ(mesh.positions.size(), 5u);  // four, and the first again with its other texture coordinate
  EXPECT_EQ(mesh.uvs.size(), 5u);
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(Obj, ReadsEveryFormOfCorner) {
  const std::string data = kSquare + "vt 0.5 0.25\nvn 0 0 1\n";
  EXPECT_EQ(obj(data + "f 1//1 2//1 3//1\n").normals.size(), 3u);
  EXPECT_TRUE(obj(data + "f 1//1 2//1 3//1\n").uvs.empty());
  const Mesh full = obj(data + "f 1/1/1 2/1/1 3/1/1\n");
  EXPECT_EQ(full.normals[2], (Vec3{0, 0, 1}));
  EXPECT_FLOAT_EQ(full.uvs[2].y, 0.25f);
}

TEST(Obj, NormalsThatSomeCornersLackAreLeftOut) {
  EXPECT_TRUE(obj(kSquare + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n").normals.empty());
}

TEST(Obj, ReadsPastWhatIsNotGeometry) {
  const Mesh mesh =
      obj("# made by hand\nmtllib no such file.mtl\no an object\ng a group with blanks\ns 1\r\n" + kSquare +
          "usemtl red paint\nf 1 2 3 # a comment\n");
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Obj, NamesTheLineOfAFault) {
  expectContains(objError(kSquare + "f 1 2 9\n"), "a mesh.obj:5: vertex index '9'");
  expectContains(objError(kSquare + "f 1 2 -5\n"), ":5: vertex index '-5'");
  expectContains(objError(kSquare + "f 0 1 2\n"), ":5: vertex index '0'");
  expectContains(objError(kSquare + "f 1 2 99999999999999999999\n"), ":5: vertex index");
  expectContains(objError(kSquare + "f 1/1 2/1 3/1\n"), ":5: texture coordinate index '1'");
  expectContains(objError(kSquare + "f 1/1/1/1 2 3\n"), ":5: a corner");
  expectContains(objError("v 0 nan 0\n"), ":1: expected 3 finite numbers, found 'nan'");
  expectContains(objError("v 0 1e39 0\n"), ":1: expected 3 finite");
  expectContains(objError("v 0 0\n"), ":1: expected 3 finite");
  expectContains(objError(kSquare), "no faces");
  expectContains(errorOf([] { loadObj("/no/such/file.obj"); }), "/no/such/file.obj: cannot be read");
}

Mesh ply(const std::string& bytes) {
  const Scratch files;
  return loadPly(files.write("mesh.ply", bytes));
}

std::string plyError(const std::string& bytes) {
  return errorOf([&] { ply(bytes); });
}

std::string header(const std::string& format, const std::string& properties,
                   const std::string& index = "int") {
  return "ply\nformat " + format + " 1.0\ncomment by hand\nelement vertex 4\n" + properties +
         "element face 1\nproperty list uchar " + index + " vertex_indices\nend_header\n";
}
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

TEST(Ply, ReadsAsciiQuads) {
  const Mesh mesh = ply(header("ascii", kXyz) + "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n4 0 1 2 3\n");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.positions[3], (Vec3{0, 1, 0.5f}));
  EXPECT_TRUE(mesh.normals.empty() && mesh.uvs.empty());
}

TEST(Ply, ReadsNormalsAndBothNamesOfTextureCoordinates) {
  const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
  for (const std::string uv :
       {"property float u\nproperty float v\n", "property float s\nproperty float t\n"}) {
    std::string rows;
    for (int i = 0; i < 4; ++i) rows += "0 0 " + std::to_string(i) + " 0 1 0 0.25 0.75\n";
    const Mesh mesh = ply(header("ascii", kXyz + normals + uv) + rows + "3 0 1 2\n");
    EXPECT_EQ(mesh.normals[3], (Vec3{0, 1, 0}));
    EXPECT_FLOAT_EQ(mesh.uvs[3].x, 0.25f);
    EXPECT_FLOAT_EQ(mesh.uvs[3].y, 0.75f);
  }
}

// Appends a value in the byte order asked for.
template <class Bits>
void append(std::string& bytes, Bits bits, bool big) {
  for (std::size_t i = 0; i < sizeof bits; ++i)
    bytes += static_cast<char>(bits >> 8 * (big ? sizeof bits - 1 - i : i));
}

TEST(Ply, ReadsBinaryOfBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string bytes =
        header(big ? "binary_big_endian" : "binary_little_endian",
               "property double x\nproperty short y\nproperty float z\nproperty uchar red\n", "ushort");
    for (int i = 0; i < 4; ++i) {
      append(bytes, std::bit_cast<std::uint64_t>(0.5 * i), big);
      append(bytes, static_cast<std::uint16_t>(-300 * i), big);
      append(bytes, std::bit_cast<std::uint32_t>(0.25f * static_cast<float>(i)), big);
      bytes += '\x7f';
    }
    bytes += '\3';
    for (const std::uint16_t i : {3, 1, 2}) append(bytes, i, big);
    const Mesh mesh = ply(bytes);
    EXPECT_EQ(mesh.positions[3], (Vec3{1.5f, -900, 0.75f}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{3, 1, 2}}));
  }
}

TEST(Ply, ReadsPastOtherElementsAndLists) {
  const Mesh mesh =
      ply("ply\nformat ascii 1.0\nelement camera 1\nproperty float a\nproperty list int int b\nelement "
          "vertex 3\n" +
          kXyz +
          "element face 1\nproperty uchar flags\nproperty list uchar int vertex_index\nend_header\n"
          "7 2 8 9\n0 0 0\n1 0 0\n0 1 0\n255 3 0 1 2\n");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(Ply, FaultsAreErrors) {
  const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  expectContains(plyError("obj\n"), "mesh.ply:1: not a PLY");
  expectContains(plyError("ply\nformat utf8 1.0\n"), ":2: unknown format");
  expectContains(plyError("ply\nformat ascii 1.0\nelement vertex 3\n"), "ends within its header");
  expectContains(plyError("ply\nformat ascii 1.0\nproperty float x\n"), ":3: a property before");
  expectContains(plyError("ply\nformat ascii 1.0\nelement vertex -1\n"), ":3: expected 'element");
  expectContains(plyError("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n"),
                 ":4: unknown type 'half'");
  expectContains(plyError(header("ascii", "property float x\n") + vertices), "lack x, y or z");
  expectContains(plyError(header("ascii", kXyz) + "0 0 0\n"), "ends within its data");
  expectContains(plyError(header("ascii", kXyz) + "0 nan 0\n"), "'nan' is not a finite number");
  expectContains(plyError(header("ascii", kXyz) + vertices + "3 0 1 4\n"), "face 0: an index");
  expectContains(plyError(header("ascii", kXyz) + vertices + "3 0 1 -1\n"), "face 0: an index");
  expectContains(plyError(header("ascii", kXyz) + vertices + "2 0 1\n"), "face 0 has fewer");
}

TEST(Ply, AHugeCountEndsWithTheFile) {
  for (const std::string format : {"ascii", "binary_little_endian"})
    expectContains(plyError("ply\nformat " + format + " 1.0\nelement vertex 9000000000000000000\n" + kXyz +
                            "end_header\n0 0 0\n"),
                   "ends within its data");
  expectContains(plyError("ply\nformat ascii 1.0\nelement vertex 9000000000000000000\nend_header\n"),
                 "no properties");
  expectContains(
      plyError("ply\nformat ascii 1.0\nelement vertex 1\n" + kXyz +
               "element face 1\nproperty list uint uint vertex_index\nend_header\n0 0 0\n4000000000 0 0 0\n"),
      "more than 100000000 triangles");
}

TEST(MeshFiles, AreNoLargerThanTheirLimit) {
  const Scratch files;
  const std::string path = files.write("large.obj", "");
  std::filesystem::resize_file(path, kMaxMeshBytes + 1);  // a hole, which takes no space
  expectContains(errorOf([&] { loadObj(path); }), "large.obj: has more than 4294967296 bytes");
  expectContains(errorOf([&] { loadPly(path); }), "large.obj: has more than 4294967296 bytes");
  expectContains(errorOf([&] { loadObj(files.path("")); }), "cannot be read");  // a folder
}

TEST(MeshFiles, AFifoIsNotWaitedFor) {
  const Scratch files;
  ASSERT_EQ(mkfifo(files.path("a.obj").c_str(), 0600), 0);
  expectContains(errorOf([&] { loadObj(files.path("a.obj")); }),
                 "a.obj: cannot be read: is not a plain file");
}

}  // namespace
}  // namespace saccade
