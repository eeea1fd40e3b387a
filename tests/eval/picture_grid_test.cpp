#include "eval/pictures/picture_grid.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <set>

namespace saccade::eval {
namespace {

// A picture of this width, with one row.
GridPicture picture(int width, const std::string& caption) {
  GridPicture cell{caption, width, 1, {}};
  for (int x = 0; x < width; ++x)
    cell.pixels.push_back({static_cast<unsigned char>(x * x), 100, static_cast<unsigned char>(x)});
  return cell;
}

const ColorKey kKey{"down", "level", "up"};

pugi::xml_document parse(const std::string& svg) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_string(svg.c_str());
  EXPECT_TRUE(result) << result.description();
  return document;
}

// The texts of the drawing, and the addresses of its pictures.
std::multiset<std::string> texts(const pugi::xml_document& svg) {
  std::multiset<std::string> found;
  for (const auto node : svg.select_nodes("/svg/text")) found.insert(node.node().child_value());
  return found;
}
std::vector<std::string> pictures(const pugi::xml_document& svg) {
  std::vector<std::string> found;
  for (const auto node : svg.select_nodes("/svg/image"))
    found.push_back(node.node().attribute("xlink:href").value());
  return found;
}

std::string decodeBase64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned word = 0, bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    word = word << 6 | static_cast<unsigned>(digits.find(c)), bits += 6;
    if (bits >= 8) bits -= 8, bytes += static_cast<char>(word >> bits & 255);
  }
  return bytes;
}

TEST(PictureGrid, HoldsAPictureForEveryCellInOrder) {
  const std::vector<std::vector<GridPicture>> cells{{picture(4, "a"), picture(5, "b"), picture(6, "c")},
                                                    {picture(7, "d"), picture(8, "e"), picture(9, "f")}};
  const auto svg = parse(drawPictureGrid({"one", "two", "three"}, {"dI", "dL"}, cells, kKey));
  const std::vector<std::string> found = pictures(svg);
  ASSERT_EQ(found.size(), 6u);
  std::set<std::size_t> remainders;  // base64 ends in another way for each
  for (std::size_t i = 0; i < found.size(); ++i) {
    const GridPicture& cell = cells[i / 3][i % 3];
    const std::string head = "data:image/png;base64,", png = encodePng(cell.width, cell.height, cell.pixels);
    ASSERT_TRUE(found[i].starts_with(head));
    EXPECT_EQ(decodeBase64(found[i].substr(head.size())), png);
    EXPECT_EQ((found[i].size() - head.size()) % 4, 0u);
    remainders.insert(png.size() % 3);
  }
  EXPECT_EQ(remainders.size(), 3u) << "choose other pictures";
}

TEST(PictureGrid, ShowsItsTextsAsTheyAre) {
  const auto svg =
      parse(drawPictureGrid({"svgf:a<1, 2 spp"}, {"R&D"}, {{picture(4, "L1 < 0.5 & \"MAPE\" > 1")}}, kKey));
  const auto found = texts(svg);
  for (const char* text : {"svgf", "a<1", "2 spp", "R&D", "L1 < 0.5 & \"MAPE\" > 1", "down", "level", "up"})
    EXPECT_EQ(found.count(text), 1u) << text;
}

TEST(PictureGrid, BreaksTheNameOfAColumnIntoLinesAboveItsPictures) {
  const auto svg =
      parse(drawPictureGrid({"one", "svgf:a=1:b=2, 2 spp"}, {""}, {{picture(2, ""), picture(2, "")}}, kKey));
  std::set<int> baselines;
  for (const auto node : svg.select_nodes("/svg/text[.='svgf' or .='a=1' or .='b=2' or .='2 spp']"))
    baselines.insert(node.node().attribute("y").as_int());
  EXPECT_EQ(baselines.size(), 4u);
  EXPECT_LT(*baselines.rbegin(), svg.select_node("/svg/image").node().attribute("y").as_int());
}

TEST(PictureGrid, HasRoomForAllOfItsPictures) {
  const auto svg = parse(drawPictureGrid(
      {"a", "b"}, {"c", "d"}, {{picture(2, ""), picture(2, "")}, {picture(1, ""), picture(1, "")}}, kKey));
  const pugi::xml_node root = svg.child("svg");
  std::set<std::pair<int, int>> corners;
  for (const auto node : svg.select_nodes("/svg/image")) {
    const auto at = [&](const char* name) { return node.node().attribute(name).as_int(); };
    corners.insert({at("x"), at("y")});
    EXPECT_LE(at("x") + at("width"), root.attribute("width").as_int());
    EXPECT_LE(at("y") + at("height"), root.attribute("height").as_int());
  }
  EXPECT_EQ(corners.size(), 4u);
}

// The seventh column starts a second band, below all rows of the first.
TEST(PictureGrid, ContinuesBelowAfterSixColumns) {
  const std::vector<std::string> columns{"a", "b", "c", "d", "e", "f", "g"};
  const std::vector<std::vector<GridPicture>> cells(2, std::vector<GridPicture>(7, picture(2, "")));
  const auto svg = parse(drawPictureGrid(columns, {"x", "y"}, cells, kKey));
  std::vector<std::pair<int, int>> corners;
  for (const auto node : svg.select_nodes("/svg/image"))
    corners.emplace_back(node.node().attribute("x").as_int(), node.node().attribute("y").as_int());
  ASSERT_EQ(corners.size(), 14u);
  EXPECT_EQ(corners[12].first, corners[0].first);
  EXPECT_GT(corners[12].second, corners[6].second);
  EXPECT_GT(corners[13].second, corners[12].second);
}

}  // namespace
}  // namespace saccade::eval
