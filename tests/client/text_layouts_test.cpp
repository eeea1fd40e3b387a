// Text files as other programs write them. Each holds the same three events, and is read as what it says.
#include <fstream>

#include "client/formats/common/column_names.h"
#include "format_test.h"

namespace saccade::client {
namespace {

// 29, 35 and 99 microseconds.
const Events kEvents{{29'000, 5, 7, 0}, {35'000, 0, 2, 1}, {99'000, 300, 1, 0}};

class TextLayouts : public FormatTest {
 protected:
  std::unique_ptr<Reader> open(const std::string& name, const std::string& text,
                               const ColumnOptions& options = {}) const {
    std::ofstream(at(name), std::ios::binary) << text;
    return openReader(at(name), {}, &options);
  }
  Events read(const std::string& name, const std::string& text, const ColumnOptions& options = {}) const {
    return readBack(*open(name, text, options));
  }
  std::string faultOf(const std::string& name, const std::string& text,
                      const ColumnOptions& options = {}) const {
    try {
      readBack(*open(name, text, options));
    } catch (const std::exception& fault) {
      return fault.what();
    }
    return "none";
  }
  void expectFault(const std::string& text, const std::string& words,
                   const ColumnOptions& options = {}) const {
    EXPECT_NE(faultOf("a.csv", text, options).find(words), std::string::npos)
        << text << faultOf("a.csv", text, options);
  }
};

TEST_F(TextLayouts, AHeadingNamesTheColumnsInAnyOrder) {
  for (const char* text : {
           "t,x,y,p\n29,5,7,0\n35,0,2,1\n99,300,1,0\n",     // ours
           "t_us,x,y,p\n29,5,7,0\n35,0,2,1\n99,300,1,0\n",  // ours, formerly
           "x,y,p,t\n5,7,0,29\n0,2,1,35\n300,1,0,99\n",
           "timestamp,polarity,x,y\n29,0,5,7\n35,1,0,2\n99,0,300,1\n",
           "\"X\", \"Y\", \"Polarity\", \"Time\"\r\n5, 7, 0, 29\r\n0, 2, 1, 35\r\n300, 1, 0, 99\r\n",
           "\xef\xbb\xbfts;xs;ys;ps\n29;5;7;0\n35;0;2;1\n99;300;1;0\n",
           "x y pol t[us]\n5 7 -1 29\n0 2 1 35\n300 1 -1 99\n",
           "t_s,x,y,p\n0.000029,5,7,0\n0.000035,0,2,1\n0.000099,300,1,0\n",
           "t (ms),x,y,p\n0.029,5,7,0\n0.035,0,2,1\n0.099,300,1,0\n",
           "time_ns,x,y,on\n29000,5,7,False\n35499,0,2,True\n98500,300,1,False\n",  // to the nearest
                                                                                    // microsecond
           "t,x,y,p,label\n29,5,7,0,a\n35,0,2,1,b\n99,300,1,0,c\n",
           ",t,x,y,p\n0,29,5,7,0\n1,35,0,2,1\n2,99,300,1,0\n",  // of pandas
           "# t x y p\n29 5 7 0\n35 0 2 1\n99 300 1 0\n",       // of NumPy
       })
    EXPECT_EQ(read("a.csv", text), kEvents) << text;
  EXPECT_EQ(open("a.csv", "t,x,y,p,label\n1,2,3,1,a\n")->leftOut(), "column label");
}

TEST_F(TextLayouts, WithoutAHeadingTheNumbersTellTheColumns) {
  for (const char* text : {
           "0.000029 5 7 0\n0.000035 0 2 1\n0.000099 300 1 0\n",  // the Event Camera Dataset
           "#!events.txt\n# Format is time (float s), x, y, polarity (0=off, 1=on)\n"
           "0.000029000000000000 5 7 0\n3.5e-05 0 2 1\n0.0000986 300 1 0\n",  // v2e
           "29,5,7,0\n35,0,2,1\n99,300,1,0\n",
           "5,7,0,29\n0,2,1,35\n300,1,0,99\n",                             // Metavision
           "%geometry:1280,720\n5,7,0,29\n0,2,1,35\n300,1,0,99\n",         // the same, later
           "346 260\n0.000029 5 7 0\n0.000035 0 2 1\n0.000099 300 1 0\n",  // rpg_e2vid
           "29\t5\t7\t-1\n\n# a comment\n35\t0\t2\t1\n99\t300\t1\t-1\n",
       })
    EXPECT_EQ(read("a.txt", text), kEvents) << text;
}

TEST_F(TextLayouts, TheSizeMayStandAboveTheEvents) {
  EXPECT_EQ(open("a.csv", "%geometry:1280,720\n5,7,0,29\n")->size().width, 1280u);
  EXPECT_EQ(open("a.csv", "%geometry:1280,720\n5,7,0,29\n")->size().height, 720u);
  EXPECT_EQ(open("a.txt", "# by a simulator\n346 260\n0.5 1 2 1\n")->size().height, 260u);
  EXPECT_EQ(open("a.csv", "t,x,y,p\n")->size().width, 0u);
  expectFault("%geometry:1280\n5,7,0,29\n", "geometry");
  expectFault("%geometry:1280,70000\n5,7,0,29\n", "has height 70000");
}

TEST_F(TextLayouts, WhatTheFileDoesNotTellIsSaid) {
  EXPECT_EQ(open("a.txt", "0.5 1 2 1\n")->assumed(),
            "t as seconds (it has a decimal point), columns t x y p");
  EXPECT_EQ(open("a.csv", "x,y,p,t\n1,2,1,5\n")->assumed(),
            "t as microseconds (it has whole numbers), columns x y p t");
  EXPECT_EQ(open("a.csv", "t_us,x,y,p\n1,2,3,1\n")->assumed(), "");
  EXPECT_EQ(open("a.txt", "4 3\n1.0 2 1 1\n")->assumed(), "");
}

TEST_F(TextLayouts, WhatMayBeReadInTwoWaysNeedsAnOption) {
  const std::string two = "0,0,0,1\n10,0,0,1\n";
  expectFault(two, "may be t,x,y,p or x,y,p,t: give --columns t,x,y,p or --columns x,y,p,t");
  EXPECT_EQ(read("a.csv", two, {{"t", "x", "y", "p"}, {}}), (Events{{0, 0, 0, 1}, {10'000, 0, 0, 1}}));
  EXPECT_EQ(read("a.csv", two, {{"x", "y", "p", "t_ms"}, {}}),
            (Events{{1'000'000, 0, 0, 0}, {1'000'000, 10, 0, 0}}));

  const std::string whole = "t,x,y,p\n1.0,2,3,1\n2.0,2,3,1\n";
  expectFault(whole, "may count seconds or microseconds: give --unit s or --unit us");
  EXPECT_EQ(read("a.csv", whole, {{}, TimeUnit::kUs}), (Events{{1000, 2, 3, 1}, {2000, 2, 3, 1}}));
  EXPECT_EQ(read("a.csv", whole, {{}, TimeUnit::kS}),
            (Events{{1'000'000'000, 2, 3, 1}, {2'000'000'000, 2, 3, 1}}));

  const std::string epoch = "t,x,y,p\n1700000000123456789,2,3,1\n";
  expectFault(epoch, "may count microseconds or nanoseconds: give --unit us or --unit ns");
  EXPECT_EQ(read("a.csv", epoch, {{}, TimeUnit::kNs}), (Events{{1'700'000'000'123'457'000, 2, 3, 1}}));
  expectFault("t,timestamp,x,y,p\n1,1,2,3,1\n", "'t' and 'timestamp' may both be t; --columns");
  EXPECT_EQ(read("a.csv", "t,timestamp,x,y,p\n1,8,2,3,1\n", {{"timestamp", "x", "y", "p"}, {}}),
            (Events{{8000, 2, 3, 1}}));
}

TEST_F(TextLayouts, OptionsNameColumnsThatHaveOtherNames) {
  const std::string other = "when,col,row,sign\n1,2,3,1\n";
  expectFault(other, "does not name t, x, y and p; --columns names the columns");
  EXPECT_EQ(read("a.csv", other, {{"when", "col", "row", "sign"}, {}}), (Events{{1000, 2, 3, 1}}));
  EXPECT_EQ(read("a.csv", other, {{"t", "x", "y", "p"}, {}}), (Events{{1000, 2, 3, 1}}));
  EXPECT_EQ(read("a.csv", "7,1,2,3,1\n", {{"-", "t_us", "x", "y", "p"}, {}}), (Events{{1000, 2, 3, 1}}));
  expectFault("7,1,2,3,1\n", "line 1 has 5 columns; --columns names them");
  expectFault(other, "--columns: 't,x,y' does not name the 4 columns", {{"t", "x", "y"}, {}});
  expectFault(other, "--columns: 't,x,y,y' does not name", {{"t", "x", "y", "y"}, {}});
}

TEST_F(TextLayouts, WhatIsNoneOfEventsIsRefused) {
  expectFault("1,2,3,0\n2,2,3,-1\n", "are not t,x,y,p nor x,y,p,t; give --columns");
  expectFault("t,x,y,p\n1,2,3,0\n2,2,3,-1\n", "line 3 is not of the form 't x y p'");
  expectFault("t,x,y,p\n1,2,3,0\n2.5,2,3,1\n3,2,3,1\n", "none");  // one fraction makes all of them seconds
  expectFault("1.5,2.5,3,0\n", "are not t,x,y,p nor x,y,p,t; give --columns");
}

TEST_F(TextLayouts, OtherFormatsTellTheirColumnsThemselves) {
  std::ofstream(at("a.raw")) << "% evt 3.0\n% end\n";
  for (const ColumnOptions& options :
       {ColumnOptions{{"t", "x", "y", "p"}, {}}, ColumnOptions{{}, TimeUnit::kUs}})
    EXPECT_THROW(openReader(at("a.raw"), {}, &options), std::invalid_argument);
  EXPECT_NO_THROW(openReader(at("a.raw"), {}));
}

}  // namespace
}  // namespace saccade::client
