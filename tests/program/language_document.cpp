// SPDX-License-Identifier: GPL-3.0-or-later
// docs/language.md, sentence by sentence: each one that can be tried is quoted, looked up in the document,
// and tried. Its examples are read from it and run.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/claims.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/series/order_claims.hpp"
#include "analysis/stability/stability_claims.hpp"
#include "tests/program/written_program.hpp"

using namespace shortfall;
using testing::after, testing::read, testing::with_step;

namespace {

const std::string& document() {
  static const std::string text = [] {
    std::ifstream in(std::string(SHORTFALL_SOURCE_DIR) + "/docs/language.md");
    return std::string(std::istreambuf_iterator<char>(in), {});
  }();
  return text;
}

/// The document with line breaks as blanks, so that sentences can be looked up.
bool says(const std::string& sentence) {
  static const std::string flat = [] {
    std::string text = document();
    std::ranges::replace(text, '\n', ' ');
    return text;
  }();
  return flat.find(sentence) != std::string::npos;
}

/// The indented blocks, without their indentation.
std::vector<std::string> examples() {
  std::vector<std::string> found;
  bool inside = false;
  for (std::size_t begin = 0; begin < document().size();) {
    const std::size_t end = std::min(document().find('\n', begin), document().size());
    const std::string line = document().substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with("    ")) {
      if (!inside) found.emplace_back();
      inside = true;
      found.back() += line.substr(4) + "\n";
    } else if (line.empty() && inside) {
      found.back() += "\n";
    } else {
      inside = false;
    }
  }
  return found;
}

/// The example that begins so.
std::string example(const std::string& start) {
  for (const std::string& e : examples())
    if (e.starts_with(start)) return e;
  FAIL("no example begins with: " << start);
  return {};
}

/// Whether a file is refused.
bool wrong(const std::string& head, const std::string& blocks = "step\n  x = x + h*v") {
  try {
    read(head, blocks);
    return false;
  } catch (const SyntaxError&) {
    return true;
  }
}
bool wrong_step(const std::string& step, const std::string& head = "") {
  return wrong(head, "step\n" + step);
}

/// In binary64, from a speed, without a force.
double coasting(const Program& program, double v, double h) {
  const Tape tape = lower(program);
  Numbers<double> problem{[](double, double, double) { return 0.0; }};
  Run<Numbers<double>> run(tape, problem, h);
  run.begin(0, v, 0);
  run.step();
  return run.read_out().second;
}

const Rational kH(1, 10);
const std::string kDrift = "  x = x + h*v\n";

bool all_hold(const std::vector<ClaimVerdict>& verdicts) {
  return std::ranges::all_of(verdicts, &ClaimVerdict::holds);
}

}  // namespace

TEST_CASE("the complete examples are integrators, print as themselves, and their claims hold") {
  int complete = 0;
  for (const std::string& text : examples()) {
    if (text.find("\nintegrator ") == std::string::npos) continue;
    CAPTURE(text);
    ++complete;
    const Program p = parse(text, "example.integrator");
    CHECK(same(parse(print(p), "again.integrator"), p));
    CHECK(all_hold(claims(p)));
    CHECK(all_hold(stability_claims(p)));
    CHECK(all_hold(order_claims(p)));
  }
  CHECK(complete == 2);
  const Program engine = parse(example("# Damps after the force"), "engine.integrator");
  CHECK(coasting(engine, 3, 0.5) == 3 * (1 - 0.1 * 0.5));
  CHECK(coasting(engine, 30, 0.5) == doctest::Approx(4));  // two metres a step
  const Program verlet = parse(example("# Carries the acceleration"), "verlet.integrator");
  CHECK(verlet.states.size() == 1);
  CHECK(claims(verlet).size() == 2);
}

TEST_CASE("the fragments do what is said of them") {
  const Program roots = with_step("  x = x + theta*r*h*v", example("root theta"));
  CHECK(roots.roots[0].value->significant(6) == "1.35121");  // Yoshida's 1/(2 - 2^(1/3))
  CHECK(roots.roots[1].value->significant(6) == "2.41421");
  CHECK(after<Rational>(with_step(example("v = v + j") + kDrift, "  impulse j : L/T"), 1, kH, {}, 5).second ==
        Rational(2) + 5 + kH * -2);
  const Program midpoint = read("", example("tableau"));
  const Program written = with_step(
      "  k = a(x, v, t)\n  y = x + h/2*v\n  w = v + h/2*k\n  x = x + h*w\n  v = v + h*a(y, w, t + h/2)");
  CHECK(after<Rational>(midpoint, 3, kH) == after<Rational>(written, 3, kH));
  const Program leapfrog = read("", example("splitting"));
  CHECK(after<Rational>(leapfrog, 3, kH) ==
        after<Rational>(with_step("  v = v + 1/2*h*a(x, v, t)\n" + kDrift + "  v = v + 1/2*h*a(x, v, t + h)"),
                        3, kH));
}

TEST_CASE("lines and names") {
  CHECK(
      says("One statement a line. `#` starts a comment; the comment lines above `integrator` describe the "
           "method"));
  CHECK(wrong_step("  x = x + h*v v = v"));
  CHECK(parse("# Says so.\nintegrator one # not this\nstep\n x = x + h*v # nor this\n", "f").description ==
        "Says so.");
  CHECK(says("Indentation is for people. Inside parentheses, and after a final `&`, a line may continue."));
  CHECK(same(with_step("x = (x +\n   h*v)"), with_step("      x = (x + h*v)")));
  CHECK_FALSE(
      wrong_step("  solve k : L/T^2 = a(x, v, t) + m/h &\n    m : L/T = h*k/2\n  v = v + h*k\n" + kDrift));
  CHECK(wrong_step("  x = x +\n h*v"));
  CHECK(says("lower-case letters, digits, hyphens; starts with a letter"));
  const auto name = [](const std::string& n) {
    try {
      parse("integrator " + n + "\nstep\n x = x + h*v\n", "f");
      return true;
    } catch (const SyntaxError&) {
      return false;
    }
  };
  CHECK(name("a-1"));
  CHECK_FALSE(name("1-a"));
  CHECK_FALSE(name("Euler"));
  CHECK_FALSE(name("a_b"));
  CHECK(says("The default may use parameters above it."));
  CHECK(after<Rational>(with_step(" x = x + q*h*v", "param p = 3\nparam q = p/2"), 1, 1).first == 4);
  CHECK(wrong_step(" x = x + q*h*v", "param q = p/2\nparam p = 3"));
}

TEST_CASE("values, dimensions, numbers and operators") {
  CHECK(says("two vectors may not be multiplied"));
  CHECK(wrong_step("  x = x*v"));
  CHECK(wrong_step("  x = x/v"));
  CHECK(wrong_step("  x = x + v"));
  CHECK(says("A bare number has dimension 1 (the number 0 fits every one)."));
  CHECK_FALSE(wrong_step("  x = x + 0"));
  CHECK(wrong_step("  x = x + 1"));
  CHECK(says("a decimal is exact (0.1 is one tenth)"));
  CHECK(after<Rational>(with_step("  x = 0.1*x"), 1, 1).first == Rational(1, 10));
  CHECK(after<Rational>(with_step("  x = 1e-3*x"), 1, 1).first == Rational(1, 1000));
  CHECK(says("`-h^2` is -(h^2)"));
  CHECK(after<Rational>(with_step("  x = -h^2*a(x, v, t)"), 1, Rational(1, 2)).first == Rational(1, 2));
  CHECK(says("Multiplication is always written: `2*h`, never `2h`."));
  CHECK(wrong_step("  x = x + 2h*v"));
  CHECK(says(
      "Operators, loosest first: `+ -`, then `* /`, then unary `-`, then `^` with an integer exponent."));
  CHECK(after<Rational>(with_step("  x = x - 2*x/4*3 - -2^3*x"), 1, 1).first == Rational(15, 2));
  CHECK(wrong_step("  x = 2^(1/2)*x"));
}

TEST_CASE("functions: where they have a rational value, and where the run is refused") {
  CHECK(says(
      "In exact rational numbers only what stays rational has a value (`sqrt(4)`, `exp(0)`, `pow(1, h)`)"));
  CHECK(after<Rational>(with_step("  x = sqrt(4)*exp(0)*pow(1, h)*x"), 1, kH).first == 2);
  CHECK(says("otherwise the run is refused and the function named"));
  for (const std::string f : {"sqrt(2)", "exp(1)", "pow(2, h)"}) {
    CAPTURE(f);
    CHECK_THROWS_WITH_AS(after<Rational>(with_step("  x = " + f + "*x"), 1, kH),
                         doctest::Contains(f.substr(0, f.find('(')).c_str()), Unable);
  }
  CHECK(says("An exponent that is a time counts seconds: `pow(1 - c, h)`"));
  CHECK(coasting(with_step("  v = v*pow(1 - c, h)\n" + kDrift, "param c = 0.3"), 1, 0.1) ==
        std::pow(1 - 0.3, 0.1));
  CHECK(says("halves them: L^2 to L"));
  CHECK_FALSE(wrong_step("  x = x + sqrt(d)*v/s", "param d : T^2 = 1\nparam s : 1 = 1"));
  CHECK(wrong_step("  x = x + sqrt(h)*v"));
  CHECK(says("`max(r, s)`, `min(r, s)` | alike"));
  CHECK(wrong_step("  x = x + max(h, 1)*v"));
  CHECK(after<Rational>(with_step("  x = max(1/3, 1/2)*min(3, 4)*x"), 1, 1).first == Rational(3, 2));
}

TEST_CASE("algebraic numbers") {
  CHECK(says("at most 12, with rational numbers as coefficients"));
  CHECK_FALSE(wrong("root r of r^12 = 2 near 1"));
  CHECK(wrong("root r of r^13 = 2 near 1"));
  CHECK(wrong("root r of r^2 = sqrt(2) near 1"));
  CHECK(says("When the equation has several real solutions `near` chooses the nearest."));
  CHECK(wrong("root r of r^2 = 2"));
  CHECK(wrong("root r of r^2 = -2"));
  CHECK(read("root r of r^2 = 2 near -9", "step\n x = x + h*v").roots[0].value->significant(3) == "-1.41");
}

TEST_CASE("statements: locals, implicit stages, substeps and time") {
  CHECK(says("a new name is a local one, gone after the step"));
  CHECK(wrong_step("  x = x + h*w\n  w = v"));
  CHECK_FALSE(wrong_step("  w = v\n  x = x + h*w"));
  CHECK(says("K is the vector that satisfies K = EXPRESSION, in which K may occur"));
  // k = t - x - h v ... of the implicit Euler rule, solved by hand: v1 = (v - h x + h t1)/(1 + h/2 + h^2).
  const Program implicit =
      with_step("  solve k : L/T^2 = a(x + h*(v + h*k), v + h*k, t + h)\n  v = v + h*k\n  x = x + h*v");
  CHECK(after<Rational>(implicit, 1, kH).second ==
        (Rational(2) - kH + kH * kH) / (Rational(1) + kH / 2 + kH * kH));
  CHECK(says(
      "the statements N times with h/N; inside, t is the time at the beginning of the substep; after it, the "
      "beginning of the step again"));
  const std::string kick = "    v = v + h*a(x, v, t)\n    x = x + h*v\n";
  CHECK(after<Rational>(with_step("  substeps 4 {\n" + kick + "  }"), 3, kH) ==
        after<Rational>(with_step(kick), 12, kH / 4));
  // a = t where x and v are 0: the time after the substeps is the step's own beginning.
  CHECK(after<Rational>(with_step("  substeps 2 {\n    y = x\n  }\n  x = h^2*a(0*x, 0*v, t)"), 2, 3).first ==
        27);
  CHECK(says("N is a whole number or a parameter"));
  CHECK_FALSE(wrong_step("  substeps N {\n" + kick + "  }", "param N = 2"));
  CHECK_THROWS(after<Rational>(with_step("  substeps N {\n" + kick + "  }", "param N = 2"), 1, 1,
                               {{"N", Rational(1, 2)}}));
  CHECK(says("`t` is the time at its beginning; when the block ends, t has advanced by h"));
  CHECK(after<Rational>(with_step("  x = h^2*a(0*x, 0*v, t)"), 3, 2).first == 16);
  CHECK(says("x, v and states may be assigned; h, t, a, parameters, roots and the impulse may not."));
  for (const char* statement :
       {"  h = 2*h", "  t = t + h", "  a = a(x, v, t)", "  p = 2", "  r = 2", "  j = v"}) {
    CAPTURE(statement);
    CHECK(wrong_step(statement, "param p = 1\nroot r of r^3 = 2\nimpulse j : L/T"));
  }
  CHECK(says("how x and v are read out after a step (they are not changed for the next step)"));
  CHECK(after<Rational>(read("", "step\n" + kick + "finish\n  x = 3*x\n  v = 0"), 2, kH) ==
        std::pair<Rational, Rational>(after<Rational>(with_step(kick), 2, kH).first * 3, 0));
  CHECK(says("run once, before the first step: gives every `state` its first value; may change x and v"));
  CHECK(wrong("state f : L", "step\n  x = x + f"));
  CHECK(after<Rational>(read("state f : L", "start\n  f = 2*x\n  x = 5*x\nstep\n  x = x + f"), 2, kH).first ==
        9);
}

TEST_CASE("limits and when: at the place where they stand, with numbers") {
  CHECK(says("when v is faster than S, it is scaled down to it"));
  CHECK(coasting(with_step("  limit speed 2\n" + kDrift), -8, 1) == -2);
  CHECK(coasting(with_step("  limit speed 2\n" + kDrift), 1.5, 1) == 1.5);
  CHECK(says("when h*v is longer than L, v is scaled down"));
  CHECK(coasting(with_step("  limit move 2\n" + kDrift), 8, 0.5) == 4);
  CHECK(says("the statements only when v is faster than S"));
  const Program p = with_step("  when speed > 3 {\n    v = v/2\n  }\n" + kDrift);
  CHECK(coasting(p, 4, 1) == 2);
  CHECK(coasting(p, 3, 1) == 3);
  CHECK(says(
      "Names that are made within `when` are local to it; what is needed after it is assigned before it."));
  CHECK(wrong_step("  when speed > 3 {\n    w = v\n  }\n  x = x + h*w"));
  CHECK_FALSE(wrong_step("  w = 0*v\n  when speed > 3 {\n    w = v\n  }\n  x = x + h*w"));
  CHECK(says("`limit` and `when` stand in the step block"));
  CHECK(wrong("", "step\n" + kDrift + "finish\n  limit speed 2"));
  CHECK(wrong("", "start\n  limit move 2\nstep\n" + kDrift));
  CHECK(says("Statements within braces stand on lines of their own."));
  CHECK(wrong_step("  substeps 2 { x = x + h*v }"));
  CHECK(says("S is a speed, L a length; a bare number is one in m/s or m."));
  CHECK_FALSE(wrong_step("  limit speed S\n" + kDrift, "param S : L/T = 2"));
  CHECK(wrong_step("  limit speed S\n" + kDrift, "param S : L = 2"));
}

TEST_CASE("impulses and held forces") {
  CHECK(says("in the first step; zero in every step after it"));
  CHECK(says("A run that gives none has zero throughout"));
  const std::string step = "  v = v + j + h*a(x, v, t)\n" + kDrift;
  const Program p = with_step(step, "impulse j : L/T");
  const Program none = with_step("  v = v + h*a(x, v, t)\n" + kDrift);
  CHECK(after<Rational>(p, 3, kH) == after<Rational>(none, 3, kH));
  CHECK(says("With `--substeps` it acts in the first substep."));
  CHECK(after<Rational>(substepped(p, 4), 2, kH, {}, 5) == after<Rational>(p, 8, kH / 4, {}, 5));
  CHECK(says("every `a(...)` in the step block has this value, whatever stands in its parentheses"));
  const std::string twice = "  v = v + h/2*a(x, v, t)\n" + kDrift + "  v = v + h/2*a(x, v, t + h)";
  const std::string once = "  f = a(x, v, t)\n  v = v + h/2*f\n" + kDrift + "  v = v + h/2*f";
  CHECK(after<Rational>(with_step(twice, "hold a"), 3, kH) == after<Rational>(with_step(once), 3, kH));
  CHECK(says("It matters for steps with substeps, also for those that a user asks for (`--substeps N`)."));
  CHECK(after<Rational>(substepped(with_step(twice, "hold a"), 2), 1, kH) !=
        after<Rational>(substepped(with_step(once), 2), 1, kH));
}

TEST_CASE("assumptions, other equations, tableaus and splittings") {
  CHECK(says("(or `<`)"));
  CHECK_FALSE(wrong("param c : 1/T = 1\nassume c*h < 1"));
  CHECK(wrong("param c : 1/T = 1\nassume c*h = 1"));
  CHECK(says("Without it the closed form is refused, and the message says what to assume."));
  const std::string damped = "integrator damped\n  param c : 1/T = 0.1\n";
  const std::string body =
      "step\n  v = (v + h*a(x, v, t))*max(0, 1 - c*h)\n" + kDrift + "expect\n  exact 0\n";
  CHECK_THROWS_WITH_AS(claims(parse(damped + body, "f")), doctest::Contains("assume"), Unable);
  CHECK_NOTHROW(claims(parse(damped + "  assume 1 - c*h > 0\n" + body, "f")));
  CHECK(says("Here the function `log` may be used as well."));
  CHECK_FALSE(wrong("param c = 0.1\nsolves a(x, v, t) + log(1 - c)*v"));
  CHECK(wrong_step("  x = x + log(2)*h*v"));
  CHECK(says(
      "Entries may use parameters, roots and `sqrt`: `(1-g)/2`, `1/4-sqrt(3)/6`, without blanks inside."));
  CHECK_FALSE(wrong("param g = 1/3", "tableau\n  (1-g)/2 | 1/4-sqrt(3)/6\n  b | 1"));
  CHECK(says("a row may stop early (the rest is 0)"));
  CHECK(after<Rational>(read("", "tableau\n  0 |\n  1/2 | 1/2\n  1 | 0 1\n  b | 0 0 1"), 2, kH) ==
        after<Rational>(read("", "tableau\n  0 | 0 0 0\n  1/2 | 1/2 0 0\n  1 | 0 1 0\n  b | 0 0 1"), 2, kH));
  CHECK(says("Time advances with the drifts"));
  CHECK(after<Rational>(read("", "splitting\n  drift 1/2\n  kick 1\n  drift 1/2"), 2, kH) ==
        after<Rational>(with_step("  x = x + h/2*v\n  v = v + h*a(x, v, t + h/2)\n  x = x + h/2*v"), 2, kH));
}

TEST_CASE("claims: every word of the document is one, and any other is an error") {
  CHECK(says("Any other word is an error."));
  for (const char* claim : {"shortfall -1/2*a*h*t", "shortfall-velocity 0", "trace 2 - h^2*w^2",
                            "determinant 1", "limit 2", "order 1", "order 1 if a(x, t)", "symplectic"}) {
    CAPTURE(claim);
    const Program p =
        read("", "step\n  v = v + h*a(x, v, t)\n  x = x + h*v\nexpect\n  " + std::string(claim));
    const auto polynomial = claims(p), oscillator = stability_claims(p), smooth = order_claims(p);
    CHECK(polynomial.size() + oscillator.size() + smooth.size() == 1);
    CHECK(all_hold(polynomial));
    CHECK(all_hold(oscillator));
    CHECK(all_hold(smooth));
    CHECK(says("`" + std::string(claim).substr(0, std::string(claim).find(' '))));
  }
  CHECK(
      all_hold(order_claims(read("", "splitting\n  kick 1/2\n  drift 1\n  kick 1/2\nexpect\n  symmetric"))));
  CHECK(all_hold(claims(read("", "splitting\n  kick 1/2\n  drift 1\n  kick 1/2\nexpect\n  exact 0"))));
  CHECK(wrong("", "step\n  x = x + h*v\nexpect\n  conserves 1"));
  CHECK(wrong("", "step\n  x = x + h*v\nexpect\n  embedded-order 1"));
}
