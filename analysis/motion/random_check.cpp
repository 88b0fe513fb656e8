// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/random_check.hpp"

#include <random>
#include <tuple>

#include "analysis/algebra/real.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr int kDigits = 80;    // of the arithmetic
constexpr int kAgreeing = 50;  // demanded of the result, after all cancellation

template <class T>
T powered(const T& base, int exponent) {
  T result = base;
  for (int k = 1; k < exponent; ++k) result = result * base;
  return result;
}

/// Values of all letters, in numbers of type T.
template <class T>
struct LetterValues {
  std::function<T(const Rational&)> round;
  std::vector<T> values;

  T of(const Polynomial& p) const {
    T sum = round(0);
    for (const Polynomial::Term& term : p.terms()) {
      T product = round(term.coefficient);
      for (Letter letter = 0; letter < static_cast<Letter>(values.size()); ++letter)
        if (const int exponent = term.monomial.exponent(letter); exponent > 0)
          product = product * powered(values[static_cast<std::size_t>(letter)], exponent);
      sum = sum + product;
    }
    return sum;
  }
  T of(const Fraction& f) const {
    if (f.is_polynomial()) return of(f.numerator());
    const T below = of(f.denominator());
    if (below == round(0))
      throw Undefined("the denominator of a fraction vanishes at the values of its letters");
    return of(f.numerator()) / below;
  }
};

bool agree(const Rational& a, const Rational& b) { return a == b; }
bool agree(const Real& a, const Real& b) {
  using boost::multiprecision::abs;
  const Real scale = 1 + abs(a) + abs(b);
  return abs(a - b) <= scale * boost::multiprecision::pow(Real(10), -kAgreeing);
}

template <class T>
class Checking {
 public:
  Checking(const Program& program, const Values& given, const RandomForce& force, const StepMap& map,
           const ClosedForm& form, std::function<T(const Rational&)> round)
      : program_(program), given_(given), force_(force), map_(map), form_(form), round_(std::move(round)) {}

  RandomCheck check(int trials, int steps, int digits) {
    RandomCheck check{trials, steps, digits, true};
    check.trials = 0;
    // Numbers may hit a pole of the step; the formula says so itself, and other numbers are drawn.
    for (int trial = 0; trial < 3 * trials && check.trials < trials; ++trial) {
      try {
        check.agrees = agrees(steps, trial == 0) && check.agrees;
        ++check.trials;
      } catch (const Undefined&) {
      }
    }
    check.agrees = check.agrees && check.trials > 0;
    return check;
  }

 private:
  Rational drawn(int from, int to, int below) {
    return Rational(std::uniform_int_distribution<int>(from, to)(random_),
                    std::uniform_int_distribution<int>(1, below)(random_));
  }

  /// The values of parameters for one trial.
  Values parameters(bool defaults) {
    Values values = given_;
    const Tape tape = lower(program_, given_);
    for (const Tape::ParameterSlot& p : tape.parameters)
      if (!defaults && !p.fixed && !p.derived) values[p.name] = drawn(1, 9, 9) / Rational(10);
    return values;
  }

  bool agrees(int steps, bool defaults) {
    const Values chosen = parameters(defaults);
    const Tape tape = lower(program_, chosen);
    const Values values = parameter_values(program_, chosen);
    std::vector<T> column;
    for (int i = 0; i < form_.degree + 3; ++i) column.push_back(round_(drawn(-40, 40, 9)));
    const T h = round_(Rational(1, std::uniform_int_distribution<int>(2, 60)(random_)));
    const T k = round_(force_.spring ? force_.k.value_or(drawn(1, 40, 9)) : Rational(0));
    const T c = round_(force_.damper ? force_.c.value_or(drawn(1, 40, 9)) : Rational(0));
    LetterValues<T> letters{round_, {round_(0), h, round_(0), k, c}};
    for (const Tape::ParameterSlot& p : tape.parameters) letters.values.push_back(round_(values.at(p.name)));
    Numbers<T> problem{[&](const T& x, const T& v, const T& t) {
                         T f = round_(0);
                         for (int i = form_.degree; i >= 0; --i)
                           f = f * t + column[static_cast<std::size_t>(2 + i)];
                         return T(f - k * x - c * v);
                       },
                       round_};
    for (const ExtraLetters::Extra& e : map_.extras)
      letters.values.push_back(e.root ? problem.root(*e.root, e.name)
                                      : value_of(e.function, letters.of(e.a), letters.of(e.b)));
    Run<Numbers<T>> run(tape, problem, h);
    run.begin(column[0], column[1], round_(0));
    std::vector<T> polynomial;
    for (const Fraction& f : form_.oscillation.polynomial) polynomial.push_back(letters.of(f));
    // The oscillation in numbers: its first values, then its recurrence.
    const auto first = [&](const Oscillation::Values& values) {
      std::vector<T> sum(static_cast<std::size_t>(form_.oscillation.order()), round_(0));
      if (sum.empty()) return sum;
      for (std::size_t col = 0; col < column.size(); ++col)
        for (std::size_t j = 0; j < sum.size(); ++j)
          sum[j] = sum[j] + letters.of(values[col][j]) * column[col];
      return sum;
    };
    std::vector<T> rx = first(form_.oscillation.position);
    std::vector<T> rv = first(form_.oscillation.velocity);
    const auto advance = [&](std::vector<T>& window) {
      if (window.empty()) return;
      T next = round_(0);
      for (std::size_t j = 0; j < window.size(); ++j) next = next - polynomial[j] * window[j];
      window.erase(window.begin());
      window.push_back(next);
    };
    bool all = true;
    for (int n = 0; n <= steps; ++n, advance(rx), advance(rv)) {
      if (n > 0) run.step();
      if (n < form_.valid_from) continue;
      const auto [x, v] = run.read_out();
      letters.values[kCount] = round_(n);
      for (const auto& [stepped, motion, rest] :
           {std::tuple{x, &form_.position, &rx}, {v, &form_.velocity, &rv}}) {
        T closed = rest->empty() ? round_(0) : rest->front();
        for (std::size_t col = 0; col < motion->size(); ++col)
          for (const Sequence::Term& term : (*motion)[col].terms())
            closed = closed + letters.of(term.coefficient) *
                                  (n == 0 ? round_(1) : powered(letters.of(term.base), n)) * column[col];
        all = all && agree(closed, stepped);
      }
    }
    return all;
  }

  const Program& program_;
  const Values& given_;
  const RandomForce& force_;
  const StepMap& map_;
  const ClosedForm& form_;
  std::function<T(const Rational&)> round_;
  std::mt19937 random_{20240808};
};

}  // namespace

RandomCheck random_check(const Program& program, const Values& given, const RandomForce& force,
                         const StepMap& map, const ClosedForm& form, int trials, int steps) {
  const Program calm = undisturbed(program);  // closed forms take it that no limit acts
  if (map.extras.empty())
    return Checking<Rational>(calm, given, force, map, form, [](const Rational& r) { return r; })
        .check(trials, steps, 0);
  const Precision precision(kDigits);
  return Checking<Real>(calm, given, force, map, form, [](const Rational& r) { return real(r, kDigits); })
      .check(trials, steps, kAgreeing);
}

}  // namespace shortfall
