// SPDX-License-Identifier: GPL-3.0-or-later
// Frame files: what is read exactly, and what every bad one is told.
#include "analysis/motion/frame_list.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"

namespace shortfall {
namespace {

using Steps = std::vector<Rational>;
using Kind = FrameList::Kind;

Steps steps(const std::string& text) { return parse_frames(text, "f.csv").steps; }

std::string complaint(const std::string& text) {
  try {
    parse_frames(text, "f");
  } catch (const SyntaxError& e) {
    return e.what();
  }
  return "accepted";
}

TEST_CASE("one column of seconds is read exactly as it is written") {
  CHECK(steps("0.016\n0.02\n1/60\n1.5e-3\n") ==
        Steps{Rational(2, 125), Rational(1, 50), Rational(1, 60), Rational(3, 2000)});
  CHECK(steps("0.1") == Steps{Rational(1, 10)});
  CHECK(parse_frames("0.1\n", "f").kind == Kind::step);
  CHECK_FALSE(parse_frames("0.1\n", "f").unit_is_given);
}

TEST_CASE("a unit stands in the header or behind the number, and 16.6667 ms is 166667/10000000 s") {
  const Rational exact(166'667, 10'000'000);
  for (const char* text : {"dt [ms]\n16.6667\n", "frame time (ms)\n16.6667\n", "frametime_ms\n16.6667",
                           "deltaTimeMs\n16.6667", "16.6667ms", "16.6667 ms", "dt\n16.6667 ms\n",
                           "dt [s]\n16.6667 ms\n", "\"dt [us]\"\n16666.7\n", "dt [\xC2\xB5s]\n16666.7",
                           "dt_ns\n16666700", "MsBetweenPresents\n16.6667\n", "step length [ms]\n16.6667"})
    CHECK_MESSAGE(steps(text) == Steps{exact}, text);
  CHECK(parse_frames("dt [ms]\n1\n", "f").unit == "ms");
}

TEST_CASE("comments, blank lines, Windows and old line ends and a byte order mark do not matter") {
  const Steps two{Rational(1, 10), Rational(1, 5)};
  CHECK(steps("# a comment\n\n  0.1  # the first\n\t\n0.2\n#\n") == two);
  CHECK(steps("\xEF\xBB\xBF"
              "0.1\r\n0.2\r\n") == two);
  CHECK(steps("0.1\r0.2\r") == two);
  CHECK(steps("\xEF\xBB\xBF# x\r\n\r\ndt\r\n0.1\r\n0.2") == two);
}

TEST_CASE("a table is read by its header, whatever separates the columns") {
  const Steps two{Rational(1, 10), Rational(1, 5)};
  CHECK(steps("frame,dt,gpu\n1,0.1,9\n2,0.2,x\n") == two);
  CHECK(steps("frame;dt\n1;0.1\n2;0.2\n") == two);
  CHECK(steps("frame\tdt\n1\t0.1\n2\t0.2\n") == two);
  CHECK(steps("name,dt\n\"a, b\",0.1\n\"c # d\",\"0.2\"\n") == two);
  CHECK(steps("dt,\n0.1,\n0.2,\n") == two);
  CHECK(steps("FPS\n10\n5\n") == two);
  CHECK(steps("dt\n10Hz\n5 fps\n") == two);
  // A step is preferred to a time stamp, a time stamp to a rate.
  CHECK(steps("time,dt\n7,0.1\n7,0.2\n") == two);
  CHECK(steps("fps,time\n7,0\n7,0.1\n7,0.3\n") == two);
  CHECK(parse_frames("frame, Frame Time [ms]\n1, 5\n", "f").column == "Frame Time [ms]");
}

TEST_CASE("time stamps give the steps between them; the first is the launch") {
  const FrameList list =
      parse_frames("timestamp [ms]\n1700000000000.25\n1700000000016.5\n1700000000050\n", "f");
  CHECK(list.kind == Kind::stamp);
  CHECK(list.steps == Steps{Rational(65, 4000), Rational(134, 4000)});
  CHECK(list.duration() == Rational(199, 4000));
  CHECK_FALSE(list.equal());
  CHECK(parse_frames("t\n0\n1\n2\n", "f").equal());
  CHECK(steps("time\n-1\n-0.5\n") == Steps{Rational(1, 2)});
}

TEST_CASE("a bad file is told what is wrong, with line and column") {
  struct Case {
    std::string text, message;
  };
  const std::string number = " is not a number; a number looks like 3, -1/50, 0.02 or 1.5e-3";
  const std::vector<Case> cases{
      {"", "f:1:1: there is no step in it: the file is empty"},
      {"# only\n\n", "f:2:1: there is no step in it: the file is empty"},
      {"dt\n", "f:1:1: there is no step in it: below the header 'dt' is no row"},
      {"time\n0\n", "f:2:1: one time stamp is no step: below the header 'time' there must be at least two"},
      {"0.1\n0\n", "f:2:1: the step '0' is 0; a frame takes longer than 0 s"},
      {"0.1\n -0.1\n", "f:2:2: the step '-0.1' is negative; a frame takes longer than 0 s"},
      {"fps\n0\n", "f:2:1: the rate '0' is 0; a frame takes longer than 0 s"},
      {"0.1\nnan\n", "f:2:1: 'nan' is not a number"},
      {"NaN\n", "f:1:1: 'NaN' is not a number"},
      {"0.1\n-inf\n", "f:2:1: '-inf' is not a number"},
      {"0.1\nfast\n", "f:2:1: 'fast' is not a number"},
      {"0.1\n1.2.3\n", "f:2:1: \"1.2.3\"" + number},
      {"0.1\n1/0\n", "f:2:1: \"1/0\" is a division by zero"},
      {"0.1\n0.1 0.2\n", "f:2:1: \"0.1 0.2\" is not a number: there is a space in it"},
      {"0.1\n16kg\n", "f:2:3: unknown unit 'kg'; the units are s, ms, us, ns, Hz and fps"},
      {"0,1\n0,2\n",
       "f:1:3: there are 2 columns and no header that says which one is the step; write a line such as "
       "'frame,dt [ms]' or 'frame,time [s]' above them"},
      {"dt\n0,1\n", "f:2:1: \"0,1\"" + number},
      {"frame\n1\n",
       "f:1:1: the header 'frame' names neither steps (dt, frame time), nor time stamps (time, timestamp), "
       "nor rates (fps), with a unit s, ms, us or ns if any"},
      {"dt [min]\n1\n",
       "f:1:1: the header 'dt [min]' names neither steps (dt, frame time), nor time stamps (time, "
       "timestamp), "
       "nor rates (fps), with a unit s, ms, us or ns if any"},
      {"frame,dt,frame time\n1,2,3\n",
       "f:1:10: the columns 'dt' and 'frame time' say the same thing; leave one of them out"},
      {"frame,dt\n1,0.1\n2\n", "f:3:2: the row has 1 of the 2 cells up to the column 'dt'"},
      {"frame,dt,x\n1,,3\n", "f:2:3: the step is missing"},
      {"time\n0\n0.1\n0.1\n",
       "f:4:1: the time stamp '0.1' does not advance: the one before it, '0.1' in line 3, is the same"},
      {"n;time\n1;2\n2;1\n",
       "f:3:3: the time stamp '1' does not advance: the one before it, '2' in line 2, is later"},
      {"time\n0\n5Hz\n", "f:3:1: a time stamp is no rate"},
      {std::string("0.1\n\0\1", 6),
       "f:2:1: this is no text: it has a control character in it (a binary file?)"},
      {"\x7F"
       "ELF",
       "f:1:1: this is no text: it has a control character in it (a binary file?)"},
      {"0.1\n\xB5\n", "f:2:1: this is no UTF-8 text (a binary file?)"},
      {std::string("\xFF\xFE"
                   "0\0",
                   4),
       "f:1:1: the file is in UTF-16; save it as UTF-8 or plain ASCII"},
      {"0.1\n" + std::string(20'000, '1'), "f:2:1: the line is longer than 10,000 bytes"},
      {"0." + std::string(101, '1'), "f:1:1: the number has more than 100 digits, which is our limit"},
      {"1e-200", "f:1:1: the number has more than 100 digits, which is our limit"},
      {"1e999999999", "f:1:1: \"1e999999999\" has more than 10,000 digits, which is our limit"},
  };
  for (const Case& c : cases) CHECK(complaint(c.text) == c.message);
}

TEST_CASE("a file that cannot be read is not a bad one") {
  CHECK_THROWS_AS(read_frames("/no/such/file.csv"), UnreadableFile);
  CHECK_THROWS_AS(read_frames("/"), UnreadableFile);
}

TEST_CASE("random steps, written in random ways, come back exactly") {
  CHECK(rc::check([] {
    struct Unit {
      const char* name;
      int places;
    };
    const Unit unit = *rc::gen::element(Unit{"s", 0}, Unit{"ms", 3}, Unit{"us", 6}, Unit{"ns", 9});
    const bool stamps = *rc::gen::arbitrary<bool>(), table = *rc::gen::arbitrary<bool>();
    const std::string end = *rc::gen::element<std::string>("\n", "\r\n", "\r");
    const std::string separator = *rc::gen::element<std::string>(",", ";", "\t", " , ");
    const auto lengths =
        *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 10'000'000)));
    // Lengths in 10^-8 s, written as decimals of the unit with every digit.
    const Rational scale = Rational(10).pow(unit.places - 8);
    std::string text = std::string(stamps ? "time [" : "dt [") + unit.name + "]" + end;
    if (table) text = "n" + separator + text;
    Rational t;
    Steps wanted;
    const auto line = [&](const Rational& value) {
      if (*rc::gen::inRange(0, 5) == 0) text += "# nothing" + end;
      if (table) text += "0" + separator;
      text += value.decimal(8) + end;
    };
    if (stamps) line(0);
    for (int length : lengths) {
      wanted.push_back(Rational(length) / Rational(100'000'000));
      t += Rational(length) * scale;
      line(stamps ? t : Rational(length) * scale);
    }
    RC_ASSERT(parse_frames(text, "f").steps == wanted);
  }));
}

TEST_CASE("whatever bytes a file has, it is read or refused") {
  CHECK(rc::check([] {
    std::string text = "frame,dt [ms]\r\n1,16.7 # x\n2,\"17\"\n";
    for (int k = *rc::gen::inRange(1, 6); k > 0; --k) {
      const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(text.size())));
      text[at] = *rc::gen::weightedOneOf<char>(
          {{3, rc::gen::element(',', ';', '\n', '\r', '"', '#', '-', '.', '0', 'e', '/', ' ')},
           {1, rc::gen::arbitrary<char>()}});
    }
    try {
      for (const Rational& h : parse_frames(text, "f").steps) RC_ASSERT(h.sign() > 0);
    } catch (const SyntaxError& e) {
      RC_ASSERT(e.line() >= 1);
      RC_ASSERT(e.column() >= 1);
    }
  }));
}

}  // namespace
}  // namespace shortfall
