// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/kit_numbers.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit_letters.hpp"
#include "analysis/motion/ball_formula.hpp"

namespace shortfall {

namespace {

using Balls = std::map<std::string, Ball>;

constexpr int kMostBits = 1 << 13;
constexpr int kContinuation = 8;  // steps from 0 to h in which a root is followed

Ball middle(const Ball& b, int bits) { return Ball(b.midpoint(), bits); }

class KitValues {
 public:
  KitValues(const LinearKit& kit, const Force& force, const Values& parameters, int bits)
      : kit_(kit), force_(force), parameters_(parameters), bits_(bits) {}

  /// Values of all names that the kit's formulas use.
  Balls at(const Rational& h) const {
    Balls values = letters(h);
    if (kit_.implicit && kit_.implicit->radicals.empty()) {
      check_reach(values);
      std::vector<Ball> root;
      for (const Letter unknown : kit_.implicit->unknowns)
        root.emplace_back(unknown == kStiffness ? *force_.k : force_.c.value_or(0), bits_);
      for (int j = 1; j <= kContinuation; ++j) root = followed(letters(h * Rational(j, kContinuation)), root);
      const std::vector<Ball> proved = enclosed(values, root);
      for (std::size_t i = 0; i < proved.size(); ++i) values[unknown(i)] = proved[i];
    }
    for (const Definition& d : kit_.step_definitions) values[d.name] = ball_value(d.value, values, bits_);
    return values;
  }

 private:
  /// Where the branch of a single parameter has an end, whether the flow lies before it.
  void check_reach(const Balls& values) const {
    const auto& range = kit_.implicit->range;
    if (!range || !range->least) return;
    const bool spring = kit_.implicit->unknowns[0] == kStiffness;
    const Ball& needed = values.at(kit_.letters[spring ? kFlowCosine : kFlowDecay]);
    if ((needed - Ball(Rational::parse(*range->least), bits_)).sign() != -1) return;
    const std::string what = spring ? "cos(w h)" : "exp(-c h)";
    throw Unable("at this step length " + what + " is " + needed.significant(6).value_or("too small") +
                 ", and the least that the step can give is " +
                 Rational::parse(*range->least).significant(6) + ": the kit does not reach so far");
  }

  const std::string& unknown(std::size_t i) const { return kit_.letters[kit_.implicit->unknowns[i]]; }

  Balls letters(const Rational& h) const {
    Balls values;
    values.emplace("h", Ball(h, bits_));
    for (const auto& [name, value] : parameters_) values.emplace(name, Ball(value, bits_));
    for (const ExtraLetters::Extra& e : kit_.extras)
      values[e.name] = e.root ? ball(*e.root, bits_) : ball_value(letter_expression(e.name), values, bits_);
    for (const Definition& d : kit_.definitions) values[d.name] = ball_value(d.value, values, bits_);
    return values;
  }

  /// A polynomial with values for the letters that occur in it.
  Ball evaluated(const Polynomial& p, const Balls& values) const {
    Ball sum(0, bits_);
    for (const auto& term : p.terms()) {
      Ball product(term.coefficient, bits_);
      for (Letter letter = 0; letter < kLetters; ++letter)
        if (const int exponent = term.monomial.exponent(letter); exponent > 0)
          product *= pow(values.at(kit_.letters[letter]), exponent);
      sum += product;
    }
    return sum;
  }

  /// J^-1 F, J taken over the box, F at the point.
  std::vector<Ball> newton(const Balls& point, const Balls& box) const {
    const ImplicitParameters& p = *kit_.implicit;
    std::vector<Ball> f, j;
    for (const Polynomial& equation : p.equations) {
      f.push_back(evaluated(equation, point));
      for (const Letter unknown : p.unknowns) j.push_back(evaluated(equation.derivative(unknown), box));
    }
    if (f.size() == 1) return {f[0] / j[0]};
    const Ball det = j[0] * j[3] - j[1] * j[2];
    return {(f[0] * j[3] - f[1] * j[1]) / det, (f[1] * j[0] - f[0] * j[2]) / det};
  }

  std::vector<Ball> followed(Balls values, std::vector<Ball> root) const {
    for (int round = 0; round < 40; ++round) {
      for (std::size_t i = 0; i < root.size(); ++i) values[unknown(i)] = root[i];
      const std::vector<Ball> step = newton(values, values);
      bool moved = false;
      for (std::size_t i = 0; i < root.size(); ++i) {
        if (!step[i].is_finite())
          throw Unable("Newton's method found no root of the kit's equations for this step length");
        moved = moved || step[i].sign().has_value();
        root[i] = middle(root[i] - step[i], bits_);
      }
      if (!moved) break;
    }
    return root;
  }

  /// The root near a point, in a box that the interval Newton operator takes into its inside.
  std::vector<Ball> enclosed(const Balls& values, const std::vector<Ball>& point) const {
    const Ball radius(Rational(1, 2).pow(bits_ / 2), bits_);
    Balls at = values, box = values;
    for (std::size_t i = 0; i < point.size(); ++i) {
      at[unknown(i)] = point[i];
      box[unknown(i)] = hull(point[i] - radius, point[i] + radius);
    }
    const std::vector<Ball> step = newton(at, box);
    std::vector<Ball> result;
    for (std::size_t i = 0; i < point.size(); ++i) {
      if (!step[i].is_finite() || (radius - abs(step[i])).sign() != 1)
        throw Unable("no root of the kit's equations could be proved for this step length");
      result.push_back(point[i] - step[i]);
    }
    return result;
  }

  const LinearKit& kit_;
  const Force& force_;
  const Values& parameters_;
  int bits_;
};

/// The vectors of which a correction is a combination.
std::vector<std::string> vectors(int degree) {
  std::vector<std::string> names{"x0", "v0", "x_n", "v_n", "a"};
  for (int j = 0; j <= degree; ++j) names.push_back("f" + std::string(j, '\''));
  return names;
}

}  // namespace

KitNumbers kit_numbers(const LinearKit& kit, const Force& force, const Values& parameters, const Rational& h,
                       int digits) {
  if (!kit.exists) throw Unable("there is no kit to be put in numbers: " + kit.obstruction);
  if (!force.numeric()) throw BadInput("numbers need a number for k and c, as in damped-spring:k=4,c=1/2");
  const std::vector<std::string> names = vectors(force.degree);
  for (int bits = 8 * digits + 64;; bits *= 2) {
    KitNumbers result;
    result.solved = kit.implicit && kit.implicit->radicals.empty();
    Balls values = KitValues(kit, force, parameters, bits).at(h);
    bool settled = true;
    const auto add = [&](NumericCorrection& c, const Ball& ball, const std::string& name) {
      if (ball.is_zero() && !name.empty()) return;
      CertainNumber number{ball, {}, ball.significant(digits)};
      settled = settled && number.decimal.has_value();
      c.terms.emplace_back(std::move(number), name);
    };
    for (const LinearCorrection& correction : kit.corrections) {
      NumericCorrection c{correction.target, {}};
      for (const std::string& name : names) values[name] = Ball(0, bits);
      bool linear = false;
      for (const std::string& name : names) {
        if (!mentions(correction.value, name)) continue;
        linear = true;
        values[name] = Ball(1, bits);
        add(c, ball_value(correction.value, values, bits), name);
        values[name] = Ball(0, bits);
      }
      if (!linear) add(c, ball_value(correction.value, values, bits), "");
      result.corrections.push_back(std::move(c));
    }
    if (settled || bits > kMostBits) return result;
  }
}

}  // namespace shortfall
