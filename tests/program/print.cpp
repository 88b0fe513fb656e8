// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/print.hpp"

#include <doctest/doctest.h>

#include "analysis/program/check.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

/// A formula as a user may type it, whatever its type.
Expr formula(const std::string& text) {
  Program program;
  for (const char* parameter : {"beta", "rho", "alpha_f", "r", "damping"})
    program.parameters.push_back({parameter, kPure, number(1), {}});
  Names names = formula_names(program, 0);
  names.declare("v_prev", {Sort::vector, kVelocity});
  names.declare("k1", {Sort::vector, kAcceleration});
  for (const Dimension d : {kLength, kVelocity, kAcceleration, kTime, kTime * kTime, kPure})
    for (const Sort sort : {Sort::vector, Sort::scalar}) {
      try {
        return parse_formula(text, "formula", names, {sort, d});
      } catch (const SyntaxError&) {
      }
    }
  FAIL("no formula of a usual dimension: " << text);
  return nullptr;
}

struct Sample {
  const char* language;
  const char* unicode;
  const char* latex;
};

}  // namespace

TEST_CASE("formulas are printed for the terminal and for LaTeX as a book has them") {
  for (const Sample& s : std::vector<Sample>{
           {"x0 + v0*t", "x₀ + v₀ t", "x_{0} + v_{0} \\, t"},
           {"x0 + v0*t + a*t^2/2", "x₀ + v₀ t + a t²/2", "x_{0} + v_{0} \\, t + \\frac{a \\, t^{2}}{2}"},
           {"-a*h*t/2", "−a h t/2", "\\frac{-a \\, h \\, t}{2}"},
           {"a*t*(t - h)/2", "a t (t − h)/2", "\\frac{a \\, t \\, \\left(t - h\\right)}{2}"},
           {"(1/2 - beta)*k1", "(1/2 − β) k₁", "\\left(\\frac{1}{2} - \\beta\\right) \\, k_{1}"},
           {"v0/(1 - rho)^2", "v₀/(1 − ρ)²", "\\frac{v_{0}}{\\left(1 - \\rho\\right)^{2}}"},
           {"r^n*v0", "rⁿ v₀", "r^{n} \\, v_{0}"},
           {"r^(n + 1)*v0", "r^(n + 1) v₀", "r^{n + 1} \\, v_{0}"},
           {"(r/2)^n*v0", "(r/2)ⁿ v₀", "\\left(\\frac{r}{2}\\right)^{n} \\, v_{0}"},
           {"alpha_f*damping*v_prev", "α_f damping v_prev",
            "\\alpha_{f} \\, \\mathrm{damping} \\, v_{\\mathrm{prev}}"},
           {"h*2*v0", "h·2 v₀", "h \\cdot 2 \\, v_{0}"},
           {"a*n^-2*h", "a n⁻² h", "a \\, n^{-2} \\, h"},
           {"v0 - (-v0)", "v₀ − (−v₀)", "v_{0} - \\left(-v_{0}\\right)"},
           {"x0 - (x0 - h*v0)", "x₀ − (x₀ − h v₀)", "x_{0} - \\left(x_{0} - h \\, v_{0}\\right)"},
           {"h/(2/h)", "h/(2/h)", "\\frac{h}{\\frac{2}{h}}"},
       }) {
    CAPTURE(s.language);
    const Expr e = formula(s.language);
    CHECK(print(e) == s.language);
    CHECK(print(e, Style::unicode) == s.unicode);
    CHECK(print(e, Style::latex) == s.latex);
  }
}

TEST_CASE("formulas that are built, not read, are tidy") {
  const Expr a = name("a");
  const Expr t = name("t");
  CHECK(print(number(Rational(1, 2)) * a * power(t, 2)) == "1/2*a*t^2");
  CHECK(print(number(Rational(1, 2)) * a * power(t, 2), Style::unicode) == "½ a t²");
  CHECK(print(number(Rational(1, 2)) * a * power(t, 2), Style::latex) == "\\frac{1}{2} \\, a \\, t^{2}");
  CHECK(print(number(Rational(-7, 12)) * a, Style::unicode) == "−7/12 a");
  CHECK(print(power(number(Rational(1, 2)), 3), Style::unicode) == "(½)³");
  CHECK(print(power(number(Rational(1, 2)), 3), Style::latex) == "\\left(\\frac{1}{2}\\right)^{3}");
  CHECK(print(negate(a * t)) == "-a*t");
  CHECK(print(a + negate(t)) == "a - t");
  CHECK(print(a - negate(t)) == "a + t");
  CHECK(print(a * negate(t)) == "-a*t");
  CHECK(print(number(0) * a + t * number(1)) == "t");
  CHECK(print(sum("k", number(0), name("n") - number(1), name("k")), Style::unicode) == "Σₖ₌₀ⁿ⁻¹ k");
  CHECK(print(sum("k", number(0), name("n") - number(1), name("k")), Style::latex) ==
        "\\sum_{k=0}^{n - 1} k");
  CHECK(print(sum("k", number(0), name("n") - number(1), name("k"))) == "sum(k, 0, n - 1, k)");
}

TEST_CASE("a printed program looks like one that a person wrote") {
  const std::string text = R"(# Kick, then drift.
#
# Half of it implicit.
integrator mixed
  alias  kick and drift
  source Nobody (1900), Nowhere
  param  theta = 1/2
  param  c : 1/T = 0.25
  state  a0 : L/T^2

start
  a0 = a(x, v, t)

step
  solve k : L/T^2 = a(x, v + h*k, t + theta*h) &
        w : L/T = v + h*k
  substeps 2 {
    v = v - (-h*k)
    x = x + h*(v + (w - v))
  }
  a0 = -(c*h)*a0

finish
  v = v + h/2*a0

expect
  exact 0
  shortfall -a*h*t/2
)";
  CHECK(print(parse(text, "mixed.integrator")) == text);
}
