// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/implicit_parameters.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/correction/flow_series.hpp"
#include "analysis/correction/kit_letters.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/stability/stability_function.hpp"

namespace shortfall {

namespace {

const Expr kStep = name("h");

Expr root_of(const Expr& e) { return call("sqrt", {e}); }

/// R(u), its coefficients rational, as a formula; the roots u belong to the whole frame, so a substep sees
/// u/N.
Expr function_formula(const StabilityFunction& r, int substeps) {
  const Expr u = substeps == 1 ? name("u") : name("u") / number(substeps);
  const auto polynomial = [&](const Univariate<Algebraic>& p) {
    Expr total = number(0);
    for (int j = 0; j <= p.degree(); ++j) {
      if (p[j].is_zero()) continue;
      Expr term = number(p[j].rational().abs());
      if (j > 0) term = term * power(u, j);
      total = p[j].sign() < 0 ? total - term : total + term;
    }
    return total;
  };
  const Expr above = polynomial(r.numerator);
  const Expr whole = r.denominator.degree() == 0 ? above : above / polynomial(r.denominator);
  return substeps == 1 ? whole : power(whole, substeps);
}

/// k~ and c~ for R(u) = 1 + u + b u^2: both roots of R(u) = e^(lambda h) by square roots, and their symmetric
/// functions in T and D only, so they are real whatever the eigenvalues are.
std::vector<Definition> by_square_roots(const StabilityFunction& r, const std::vector<Letter>& unknowns,
                                        bool undamped, const std::vector<std::string>& names) {
  if (r.denominator.degree() != 0 || r.numerator.degree() != 2 || !(r.numerator[0] == Algebraic(1)) ||
      !(r.numerator[1] == Algebraic(1)))
    return {};
  const Rational b = r.numerator[2].rational();
  const Rational one = Rational(1) - b * 4;
  const Wording w{names, "n", true};
  // 1 - 4 b + 4 b e^(lambda h) = s^2, u = (s - 1)/(2 b).
  if (unknowns.size() == 1) {
    if (unknowns[0] != kDamping) return {};
    const Fraction square = Fraction(one) + Fraction(b * 4) * Fraction::letter(kFlowDecay);
    return {{names[kDamping], (number(1) - root_of(formula(square, w))) / (number(b * 2) * kStep),
             "the damping it is given"}};
  }
  Fraction trace = Fraction::letter(kFlowTrace), decay = Fraction::letter(kFlowDecay);
  if (undamped) {
    trace = Fraction(2) * Fraction::letter(kFlowCosine);
    decay = 1;
  }
  const Fraction product = Fraction(one * one) + Fraction(b * 4 * one) * trace + Fraction(b * b * 16) * decay;
  const Expr m = name("m");
  const Expr sum = root_of(joined(formula(Fraction(one * 2) + Fraction(b * 4) * trace, w), number(2) * m));
  const Expr s = name("q");
  return {{"m", root_of(formula(product, w)), "the product of both square roots"},
          {"q", sum, "their sum"},
          {names[kStiffness], (number(1) - s + m) / (number(b * b * 4) * power(kStep, 2)),
           "the stiffness it is given"},
          {names[kDamping], (number(2) - s) / (number(b * 2) * kStep), "the damping it is given"}};
}

/// The answer of the step as a function of y = h^2 k or d = h c alone, from an equation that is linear in
/// what the flow gives: T = 2 cos(w h), or D.
std::optional<Fraction> answer(const ImplicitParameters& p, Letter given) {
  const Polynomial equation = small_step_part(p.equations[0]);
  // Only where it depends on h^2 k or h c alone, whatever h is.
  if (equation.terms().size() != p.equations[0].terms().size()) return std::nullopt;
  if (equation.degree(given) != 1) return std::nullopt;
  Fraction g = -Fraction(equation.coefficient(given, 0), equation.coefficient(given, 1));
  for (Letter letter = 0; letter < kLetters; ++letter)
    if (letter != p.unknowns[0] && g.contains(letter)) return std::nullopt;
  return g;
}

std::optional<BranchRange> range_of(const ImplicitParameters& p) {
  if (p.unknowns.size() != 1) return std::nullopt;
  const Letter unknown = p.unknowns[0];
  const bool spring = unknown == kStiffness;
  const auto g = answer(p, spring ? kFlowTrace : kFlowDecay);
  if (!g) return std::nullopt;
  const Polynomial slope = g->numerator().derivative(unknown) * g->denominator() -
                           g->numerator() * g->denominator().derivative(unknown);
  const std::vector<RealRoot> turns =
      positive_roots({univariate(slope, unknown), univariate(g->denominator(), unknown)});
  // Where it reaches the least that the flow can give: T = -2; D = 0 is never reached.
  const Fraction above = *g + (spring ? Fraction(2) : Fraction(0));
  const std::vector<RealRoot> least = positive_roots({univariate(above.numerator(), unknown)});
  BranchRange range;
  if (turns.empty()) {
    // Strictly falling without end, towards a limit: is the least value of the flow above it?
    const int high = g->numerator().degree(unknown), low = g->denominator().degree(unknown);
    const Rational limit = high < low ? Rational()
                                      : g->numerator().coefficient(unknown, high).constant() /
                                            g->denominator().coefficient(unknown, low).constant();
    range.all = !least.empty() || (high <= low && limit == (spring ? Rational(-2) : Rational(0)));
    if (!range.all) return std::nullopt;
    return range;
  }
  if (!least.empty() && least[0].compare(turns[0]) <= 0) {
    range.all = true;
    return range;
  }
  range.end = turns[0];
  const auto least_at = [&](const Rational& at) { return g->evaluate({{unknown, at}}) / (spring ? 2 : 1); };
  if (range.end->is_rational()) {
    range.least = least_at(range.end->rational()).str();
    return range;
  }
  // The slope is 0 there: a small width costs its square.
  const RealRoot narrow = range.end->refined(Rational(10).pow(-40));
  range.least = least_at((narrow.low() + narrow.high()) / 2).significant(20);
  return range;
}

}  // namespace

ImplicitParameters implicit_parameters(const Matching& matching, const BranchPoint& point, const Fraction& k,
                                       const Fraction& c, const Program& program, const Values& given,
                                       int substeps, const std::vector<std::string>& names) {
  ImplicitParameters p;
  p.unknowns = matching.unknowns;
  p.equations = matching.equations;
  p.jacobian = branch_jacobian(matching, point);
  p.leading = leading_differences(matching, point, k, c);
  try {
    // With an equation of its own the integrator is no R(h A) of the force alone.
    const auto r = program.solves ? std::optional<StabilityFunction>() : stability_function(program, given);
    if (r && r->algebraic.empty()) {
      p.stability_function = function_formula(*r, substeps);
      if (substeps == 1) p.radicals = by_square_roots(*r, p.unknowns, c.is_zero(), names);
    }
  } catch (const Unable&) {
    // Nothing to add then: the equations stand for themselves.
  }
  p.range = range_of(p);
  return p;
}

}  // namespace shortfall
