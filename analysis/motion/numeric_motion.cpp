// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/numeric_motion.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/ball_formula.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/motion/numeric_flow.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/motion/step_matrix.hpp"
#include "analysis/problems/letters.hpp"

namespace shortfall {

namespace {

constexpr int kMostBits = 1 << 16;
constexpr std::size_t kLongestExact = 300;  // digits: beyond, balls are faster, and nobody reads them
constexpr int kHighestNumericDegree = 30;   // of a force polynomial: the matrix grows with it

template <class T>
using Rows = std::vector<std::vector<T>>;

std::vector<int> binary_digits(Rational n) {  // lowest first
  std::vector<int> digits;
  while (!n.is_zero()) {
    const Rational half = (n / 2).floor();
    digits.push_back(n == half * 2 ? 0 : 1);
    n = half;
  }
  return digits;
}

/// The powers of the step's matrix, exactly or in balls.
class NumericStep {
 public:
  NumericStep(const Program& program, const NumericQuestion& q)
      : matrix_(step_matrix(program, q)),
        rational_(matrix_.rational()),
        a_(matrix_.step),
        start_(matrix_.start),
        report_{matrix_.position, matrix_.velocity} {}

  int size() const { return static_cast<int>(a_.size()); }
  const std::vector<std::string>& assumed() const { return matrix_.map.assumed; }

  /// Exactly; empty when that gets long, or entries are irrational.
  std::optional<std::vector<Rational>> exact(const std::vector<int>& digits) const {
    if (!rational_) return {};
    Rows<Rational> power = rationals(a_);
    std::vector<Rational> z = rationals(start_);
    for (std::size_t i = 0; i < digits.size(); ++i) {
      if (digits[i]) z = times(power, z);
      if (i + 1 < digits.size()) power = times(power, power);
      for (const auto& row : power)
        if (std::ranges::any_of(row, [](const Rational& r) { return r.digits() > kLongestExact; })) return {};
      if (std::ranges::any_of(z, [](const Rational& r) { return r.digits() > kLongestExact; })) return {};
    }
    return std::vector{dot(rationals(report_[0]), z), dot(rationals(report_[1]), z)};
  }

  std::vector<Ball> balls(const std::vector<int>& digits, int bits) const {
    const std::vector<Ball> letters = letter_balls(matrix_.map.extras, bits);
    Rows<Ball> power;
    for (const auto& row : a_) power.push_back(converted(row, letters, bits));
    std::vector<Ball> z = converted(start_, letters, bits);
    for (std::size_t i = 0; i < digits.size(); ++i) {
      if (digits[i]) z = times(power, z);
      if (i + 1 < digits.size()) power = times(power, power);
    }
    return {dot(converted(report_[0], letters, bits), z), dot(converted(report_[1], letters, bits), z)};
  }

  /// Where the force depends on time alone powers stay short: exactly, in the field of the step's roots.
  std::array<Fraction, 2> in_field(const std::vector<int>& digits) const {
    Rows<Fraction> power = a_;
    std::vector<Fraction> z = start_;
    for (std::size_t i = 0; i < digits.size(); ++i) {
      if (digits[i]) z = times(power, z);
      if (i + 1 < digits.size()) power = times(power, power);
    }
    return {dot(report_[0], z), dot(report_[1], z)};
  }

  const std::vector<NumberField::Generator>& generators() const { return matrix_.map.generators; }

  /// The value of what does not move at all: a sequence that satisfies a recurrence of the matrix's order and
  /// has so many equal values (and one more) is constant.
  std::array<std::optional<Rational>, 2> constants() const {
    std::array<std::optional<Rational>, 2> result;
    if (!rational_) return result;
    const Rows<Rational> a = rationals(a_), report = rationals(report_);
    std::vector<Rational> z = rationals(start_);
    for (int i : {0, 1}) result[i] = dot(report[i], z);
    for (int n = 0; n <= size(); ++n) {
      z = times(a, z);
      for (int i : {0, 1})
        if (result[i] && !(dot(report[i], z) == *result[i])) result[i].reset();
      if (!result[0] && !result[1]) break;
    }
    return result;
  }

 private:
  static std::vector<Rational> rationals(const std::vector<Fraction>& row) {
    std::vector<Rational> result;
    for (const Fraction& f : row) result.push_back(f.constant());
    return result;
  }

  static Rows<Rational> rationals(const Rows<Fraction>& rows) {
    Rows<Rational> result;
    for (const auto& row : rows) result.push_back(rationals(row));
    return result;
  }

  static std::vector<Ball> converted(const std::vector<Fraction>& row, const std::vector<Ball>& letters,
                                     int bits) {
    std::vector<Ball> result;
    for (const Fraction& f : row) result.push_back(ball_value(f, letters, bits));
    return result;
  }

  static void accumulate(Rational& sum, const Rational& a, const Rational& b) { sum += a * b; }
  static void accumulate(Fraction& sum, const Fraction& a, const Fraction& b) { sum += a * b; }
  static void accumulate(Ball& sum, const Ball& a, const Ball& b) { sum.add_product(a, b); }

  template <class T>
  static T dot(const std::vector<T>& a, const std::vector<T>& b) {
    T sum;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!a[i].is_zero() && !b[i].is_zero()) accumulate(sum, a[i], b[i]);
    return sum;
  }

  template <class T>
  static std::vector<T> times(const Rows<T>& a, const std::vector<T>& z) {
    std::vector<T> result;
    for (const auto& row : a) result.push_back(dot(row, z));
    return result;
  }

  template <class T>
  static Rows<T> times(const Rows<T>& a, const Rows<T>& b) {
    Rows<T> result(a.size(), std::vector<T>(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < a.size(); ++k) {
        if (a[i][k].is_zero()) continue;
        for (std::size_t j = 0; j < a.size(); ++j)
          if (!b[k][j].is_zero()) accumulate(result[i][j], a[i][k], b[k][j]);
      }
    return result;
  }

  StepMatrix matrix_;
  bool rational_;
  Rows<Fraction> a_;
  std::vector<Fraction> start_;
  Rows<Fraction> report_;
};

void check(const NumericQuestion& q) {
  if (!q.steps.is_integer() || q.steps.sign() < 0 || q.steps > Rational(10).pow(100))
    throw BadInput("a number of steps is whole and from 0 to 10^100");
  const auto need = [](bool there, const std::string& letter) {
    if (!there)
      throw BadInput("numbers after n steps need a number for " + letter +
                     ", as in spring:k=4, drag:c=1/2 or constant:a=3");
  };
  need(!q.force.spring || q.force.k || q.force.own_k, "k");
  need(!q.force.damper || q.force.c || q.force.own_c, "c");
  for (int d = 0; d <= q.force.degree; ++d)
    need(q.force.push.contains(d), q.force.degree == 0 ? "a" : "f" + std::to_string(d));
  if (q.force.degree > kHighestNumericDegree)
    throw Unable("numbers after n steps are given for forces up to poly:30");
}

/// Whether the number is decided at this precision; if so, how it is shown.
bool settle(CertainNumber& number, int digits) {
  if (number.exact && number.exact->digits() > kLongestExact) number.exact.reset();
  number.decimal = number.exact ? number.exact->significant(digits) : number.ball.significant(digits);
  return number.decimal.has_value();
}

/// -981/100 - 3 x + log(7/10) v
Expr acceleration(const Force& f, const std::vector<std::string>& letters) {
  Expr total = number(0);
  const auto add = [&](const Fraction& weight, const Expr& what) {
    if (weight.is_zero()) return;
    Expr term;
    if (weight.is_constant()) {
      const Expr size = number(weight.constant().abs());
      term = is_number(what, 1) ? size : is_number(size, 1) ? what : size * what;
      if (weight.constant().sign() < 0) term = negate(term);
    } else {
      term = formula(weight, what, Wording{letters, "n", false});
    }
    total = is_number(total, 0) ? term : joined(total, term);
  };
  for (int d = 0; d <= f.degree; ++d) add(f.push.at(d), power(name("t"), d));
  if (f.spring) add(-f.stiffness(), name("x"));
  if (f.damper) add(-f.damping(), name("v"));
  return total;
}

int size_in_bits(const Rational& r) { return static_cast<int>(r.digits() * 10 / 3) + 1; }

}  // namespace

NumericMotion numeric_motion(const Program& program, const NumericQuestion& asked) {
  NumericQuestion q = asked;
  const NumberField field;
  const Values values = parameter_values(program, asked.parameters);
  ExtraLetters extras(letter_names(lower(program, values)));
  q.force = with_own_equation(asked.force, program, values, extras);
  check(q);
  const NumericStep step(program, q);
  const std::vector<int> digits = binary_digits(q.steps);
  NumericMotion m;
  m.time = q.steps * q.h;
  m.acceleration = acceleration(q.force, extras.names());
  m.states = step.size();
  m.assumed = step.assumed();
  const NumericFlow flow(q, m.time, extras.all());

  if (const auto both = step.exact(digits)) {
    m.position.exact = (*both)[0];
    m.velocity.exact = (*both)[1];
  } else {
    const auto still = step.constants();
    m.position.exact = still[0];
    m.velocity.exact = still[1];
  }
  const auto truth = flow.exact();
  m.exact_position.exact = truth[0];
  m.exact_velocity.exact = truth[1];
  for (const auto& [shortfall, exact, computed] :
       {std::tuple{&m.position_shortfall, &m.exact_position, &m.position},
        {&m.velocity_shortfall, &m.exact_velocity, &m.velocity}})
    if (exact->exact && computed->exact) shortfall->exact = *exact->exact - *computed->exact;
  // No ball shows that a number with roots is 0, or another rational one.
  if (!q.force.linear() && !m.position.exact && !step.generators().empty()) {
    const NumberField roots(step.generators());
    const auto ends = step.in_field(digits);
    const std::array<CertainNumber*, 2> computed{&m.position, &m.velocity},
        truths{&m.exact_position, &m.exact_velocity}, missing{&m.position_shortfall, &m.velocity_shortfall};
    for (std::size_t i = 0; i < 2; ++i) {
      if (ends[i].is_constant()) computed[i]->exact = ends[i].constant();
      if (!truths[i]->exact) continue;
      const Fraction difference = Fraction(*truths[i]->exact) - ends[i];
      if (difference.is_constant()) missing[i]->exact = difference.constant();
    }
  }

  // A power loses about as many bits as n has, a long time as many as t has.
  for (m.bits = 4 * q.digits + 64 + 3 * static_cast<int>(digits.size()) + size_in_bits(m.time);;
       m.bits *= 2) {
    const auto computed = step.balls(digits, m.bits);
    const auto [x, v] = flow.balls(m.bits);
    const auto sharp = [&](const CertainNumber& number, const Ball& ball) {
      return number.exact ? Ball(*number.exact, m.bits) : ball;
    };
    m.position.ball = sharp(m.position, computed[0]);
    m.velocity.ball = sharp(m.velocity, computed[1]);
    m.exact_position.ball = sharp(m.exact_position, x);
    m.exact_velocity.ball = sharp(m.exact_velocity, v);
    m.position_shortfall.ball = sharp(m.position_shortfall, m.exact_position.ball - m.position.ball);
    m.velocity_shortfall.ball = sharp(m.velocity_shortfall, m.exact_velocity.ball - m.velocity.ball);
    bool settled = true;
    for (CertainNumber* number : {&m.position, &m.velocity, &m.exact_position, &m.exact_velocity,
                                  &m.position_shortfall, &m.velocity_shortfall})
      settled = settle(*number, q.digits) && settled;
    if (settled || m.bits > kMostBits) return m;
  }
}

}  // namespace shortfall
