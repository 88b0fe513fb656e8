// SPDX-License-Identifier: GPL-3.0-or-later
// Logs as people have them.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/log.hpp"

namespace shortfall {
namespace {

std::string refusal(const std::string& text, const LogOptions& options = {}) {
  try {
    parse_log(text, "log", options);
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

TEST_CASE("columns are known by their names, whatever stands between them") {
  const Log log = parse_log(
      "frame,time,x,y,z,vx,vy,vz\n0,0,1,2,3,4,5,6\n1,0.5,1,2,3,4,5,6\n2,1,1,2,3,4,5,6\n3,1.5,1,2,3,4,5,6\n",
      "log");
  CHECK(log.axes == std::vector<int>{0, 1, 2});
  CHECK(log.velocities);
  REQUIRE(log.dt);
  CHECK(*log.dt == Rational(1, 2));
  CHECK(log.rows[3].x[2] == 3);
  CHECK(log.rows[3].v[0] == 4);
  const Log other = parse_log("t [ms];pos_y [cm];Velocity.Y\n0;1.5;2\n20;1.5;2\n40;1.5;2\n60;1.5;2\n", "log");
  CHECK(other.axes == std::vector<int>{1});
  CHECK(other.velocities);
  CHECK(other.unit == "cm");
  CHECK(*other.dt == Rational(1, 50));
}

TEST_CASE("a velocity without an axis is that of the only position") {
  for (const std::string axis : {"x", "y", "z"}) {
    const Log log = parse_log("t," + axis + ",v\n0,1,2\n0.1,2,3\n0.2,3,4\n0.3,4,5\n", "log");
    CAPTURE(axis);
    REQUIRE(log.velocities);
    REQUIRE(log.axes.size() == 1);
    CHECK(log.rows[1].v[static_cast<std::size_t>(log.axes[0])] == 3);
  }
}

TEST_CASE("columns are what an option says") {
  LogOptions options;
  options.columns = {{"y", "hoch"}, {"time", "zeit"}};
  const Log log = parse_log("zeit\thoch\n0\t1\n0.1\t2\n0.2\t3\n0.3\t4\n", "log", options);
  CHECK(log.rows[2].x[1] == 3);
  CHECK(refusal("a,b\n1,2\n", {{{"y", "c"}}, {}}).find("there is no column 'c'") != std::string::npos);
}

TEST_CASE("without a header the number of columns says what they are") {
  const Log log = parse_log("0 0.5\n0.02 0.6\n0.04 0.7\n0.06 0.75\n", "log");
  CHECK(log.axes == std::vector<int>{1});
  CHECK(*log.dt == Rational(1, 50));
  CHECK(parse_log("1\n2\n3\n5\n", "log").rows[3].x[1] == 5);
}

TEST_CASE("JSON lines, with lists inside") {
  const Log log = parse_log(
      "{\"t\": 0, \"position\": [0, 1.5, 0]}\n{\"t\": 0.02, \"position\": [0, 1.6, 0]}\n"
      "{\"t\": 0.04, \"position\": [0, 1.7, 0]}\n{\"t\": 0.06, \"position\": [0, 1.75, 0]}\n",
      "log");
  CHECK(log.axes == std::vector<int>{0, 1, 2});
  CHECK(log.rows[1].x[1] == 1.6);
}

TEST_CASE("how numbers were rounded is seen") {
  CHECK(parse_log("y\n0.0521045662\n0.100285135\n0.144541711\n0.2\n", "log").position_rounding.kind ==
        LogRounding::Kind::binary32);
  CHECK(
      parse_log("y\n0.052104566200000001\n0.10028513499999999\n0.14\n0.2\n", "log").position_rounding.kind ==
      LogRounding::Kind::binary64);
  const LogRounding fixed = parse_log("y\n0.0521\n0.1003\n10.1445\n0.2000\n", "log").position_rounding;
  CHECK(fixed.kind == LogRounding::Kind::decimals);
  CHECK(fixed.half(7) == doctest::Approx(0.00005));
  const LogRounding printed =
      parse_log("y\n1.23456\n12.3456\n123.457\n0.123456\n1234.57\n", "log").position_rounding;
  CHECK(printed.kind == LogRounding::Kind::significant);
  CHECK(printed.half(123.457) == doctest::Approx(0.0005));
}

TEST_CASE("what makes no sense is refused, with row and column") {
  CHECK(refusal("") == "log:1:1: the file is empty");
  CHECK(refusal("y\n1\n").find("there is one row") != std::string::npos);
  CHECK(refusal("y\n1\nnan\n2\n3\n").starts_with("log:3:1: 'nan' in column 'y'"));
  CHECK(refusal("time,y\n0,1\n1,2\n0.5,3\n2,1\n").starts_with("log:4:1: the time goes back here"));
  CHECK(refusal("x,y\n0,1\n0\n0,1\n1,2\n").starts_with("log:3:2: the row has no value in column 'y'"));
  CHECK(refusal("a,b\n0,1\n").find("no column is a position among 'a', 'b'") != std::string::npos);
}

TEST_CASE("bodies that take turns are told apart, by a name or by their stamps") {
  const std::string named = "body,y\nball,1\nbox,5\nball,2\nbox,5\nball,3\nbox,5\nball,5\nbox,5\n";
  CHECK(parse_log(named, "log").rows[2].x[1] == 3);
  CHECK(parse_log(named, "log", {{}, "box"}).rows[2].x[1] == 5);
  CHECK(parse_log(named, "log").bodies.size() == 2);
  CHECK(refusal(named, {{}, "bix"}).find("no body 'bix'") != std::string::npos);
  const std::string stamped = "time,y\n0,1\n0,5\n1,2\n1,6\n2,3\n2,7\n3,4\n3,9\n";
  CHECK(parse_log(stamped, "log").rows[3].x[1] == 4);
  CHECK(parse_log(stamped, "log", {{}, "2"}).rows[3].x[1] == 9);
}

TEST_CASE("frames that are not equally long are seen, and milliseconds are not taken for that") {
  CHECK_FALSE(parse_log("time,y\n0,1\n0.01,2\n0.03,3\n0.035,4\n0.05,1\n", "log").equal_steps);
  const Log coarse = parse_log("time,y\n0,1\n0.017,2\n0.033,3\n0.050,4\n0.067,1\n0.083,2\n0.100,3\n", "log");
  CHECK(coarse.equal_steps);
  CHECK(*coarse.dt == Rational(1, 60));
}

TEST_CASE("frames that are left out are counted, and frame numbers grow") {
  const Log log = parse_log("frame,time,y\n0,0,1\n2,0.04,2\n4,0.08,3\n6,0.12,4\n8,0.16,5\n", "log");
  CHECK(log.equal_steps);
  REQUIRE(log.dt);
  CHECK(*log.dt == Rational(1, 50));
  CHECK(log.rows[2].frame == 4);
  const auto with_second_frame = [](const std::string& frame) {
    return "frame,time,y\n0,0,1\n" + frame + ",0.1,2\n2,0.2,3\n3,0.3,4\n";
  };
  CHECK(refusal(with_second_frame("1")).empty());
  CHECK(refusal(with_second_frame("0")) ==
        "log:3:1: the frame number does not grow here: the row before has 0");
  CHECK(refusal(with_second_frame("2")).starts_with("log:4:1: the frame number does not grow here"));
  CHECK(refusal(with_second_frame("1e300")) == "log:3:1: a frame number has 15 digits or fewer");
}

TEST_CASE("a step may be tiny or long, and is never nothing") {
  for (const std::string unit : {"e-18", "e-12", "e9", "e17"}) {
    CAPTURE(unit);
    const Log log =
        parse_log("time,y\n0,1\n1" + unit + ",2\n2" + unit + ",3\n3" + unit + ",4\n4" + unit + ",5\n", "log");
    REQUIRE(log.dt);
    CHECK(std::fabs(log.dt->to_double() / std::stod("1" + unit) - 1) < 1e-9);
  }
}

TEST_CASE("of a long file only the beginning is kept") {
  std::string text = "y\n";
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i % 977) + "\n";
  const Log log = parse_log(text, "log");
  CHECK(log.rows.size() == kMostRows);
  CHECK(log.more);
}

}  // namespace
}  // namespace shortfall
