// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/variable_steps.hpp"

#include <algorithm>
#include <stdexcept>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/agreement.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/problems/linear_force.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"

namespace shortfall {

namespace {

// Letters of the induction. A constant force leaves those of springs free.
constexpr Letter kStepNow = kStepLetter;
constexpr Letter kElapsed = kTimeLetter;  ///< t_n, the sum of the steps
constexpr Letter kSquares = kStiffness;   ///< S_n, the sum of their squares
constexpr Letter kFirstStep = kDamping;   ///< h_1

const Fraction kHalf = Rational(1, 2);

Fraction letter(Letter l) { return Fraction::letter(l); }

/// A step run in letters under a constant acceleration, within an open NumberField for its roots.
struct LetterRun {
  LetterRun(const Tape& tape, const Fraction& h, std::shared_ptr<ExtraLetters> extras)
      : states(static_cast<int>(tape.states.size())),
        force{states, 0, {}, {}, std::move(extras)},
        run(tape, force, h) {
    run.begin(LinearForm::column(0), LinearForm::column(1), 0);
  }

  /// One step. Roots are numbers, but what a function makes of h changes with every step.
  void step() {
    run.step();
    for (const ExtraLetters::Extra& e : force.extras->all())
      if (!e.root)
        throw Unable("the step contains " + e.name +
                     ": steps of different lengths are not followed in letters then");
  }

  LinearForm acceleration(const Fraction& coefficient) const {
    return LinearForm::column(force.force_column(0), coefficient);
  }
  /// A combination of x0, v0 and a.
  LinearForm form(const Fraction& x, const Fraction& v, const Fraction& a) const {
    return LinearForm::column(0, x) + LinearForm::column(1, v) + acceleration(a);
  }

  int states;
  LinearForce force;
  Run<LinearForce> run;
};

/// The carried vectors that are a multiple of a from the start on and stay it, whatever the lengths of steps.
class Settled {
 public:
  Settled(LetterRun& r) : multiple_(static_cast<std::size_t>(r.states)) {
    for (int i = 2; i < r.states; ++i) {
      const LinearForm& first = r.run.state(i);
      const Fraction c = first[r.force.force_column(0)];
      if (first == r.acceleration(c) && !c.contains(kFirstStep)) multiple_[static_cast<std::size_t>(i)] = c;
    }
    while (dropped_one(r)) {
    }
  }

  /// The state of step n: x and v as given, the settled ones, and a column of their own for all others.
  void put(LetterRun& r, const LinearForm& x, const LinearForm& v) const {
    r.run.set_state(0, x);
    r.run.set_state(1, v);
    for (int i = 2; i < r.states; ++i)
      r.run.set_state(
          i, is(i) ? r.acceleration(*multiple_[static_cast<std::size_t>(i)]) : LinearForm::column(i));
    r.run.set_step(letter(kStepNow));
    r.run.set_time(letter(kElapsed));
  }

  bool is(int i) const { return multiple_[static_cast<std::size_t>(i)].has_value(); }
  bool holds(const LetterRun& r) const {
    for (int i = 2; i < r.states; ++i)
      if (is(i) && !(r.run.state(i) == r.acceleration(*multiple_[static_cast<std::size_t>(i)]))) return false;
    return true;
  }

 private:
  bool dropped_one(LetterRun& r) {
    put(r, LinearForm::column(0), LinearForm::column(1));
    r.step();
    for (int i = 2; i < r.states; ++i) {
      auto& c = multiple_[static_cast<std::size_t>(i)];
      if (!c || r.run.state(i) == r.acceleration(*c)) continue;
      c.reset();
      return true;
    }
    return false;
  }

  std::vector<std::optional<Fraction>> multiple_;
};

/// Reads the numbers of one row of a step map, or says in what it differs from the form that the law needs.
class Row {
 public:
  Row(const Tape& tape, const LinearForm& row, std::string what, Letter h)
      : tape_(tape), row_(row), what_(std::move(what)), h_(h) {}

  /// The number c of c h^power in a column.
  Fraction number(int column, int power) {
    Fraction c = row_[column] / letter(h_).pow(power);
    if (!is_number(c) && reason_.empty())
      reason_ = what_ + " changes by (" + text(row_[column]) + ")*" + (column == 1 ? "v" : "a") +
                ", which is no multiple of h" + (power > 1 ? "^" + std::to_string(power) : "");
    return c;
  }

  /// Nothing else may stand in this column; `own` is that of x for a position, of v for a velocity.
  void nothing(int column, int own) {
    if (!reason_.empty() || row_[column] == Fraction(column == own ? 1 : 0)) return;
    if (column == own)
      reason_ = what_ + " is multiplied by " + text(row_[column]) + ", not by 1";
    else if (column < 2)
      reason_ = what_ + " depends on the " + (column == 0 ? "position" : "velocity");
    else
      reason_ = what_ + " depends on " + tape_.states[static_cast<std::size_t>(column)] +
                ", which an earlier step has left behind, of a length of its own";
  }

  const std::string& reason() const { return reason_; }

 private:
  static bool is_number(const Fraction& f) {
    return !f.contains(kStepNow) && !f.contains(kElapsed) && !f.contains(kFirstStep);
  }
  std::string text(const Fraction& f) const {
    std::vector<std::string> names = letter_names(tape_);
    names[kFirstStep] = "h";
    return f.str(names);
  }

  const Tape& tape_;
  const LinearForm& row_;
  std::string what_;
  Letter h_;
  std::string reason_;
};

std::string first_of(std::initializer_list<std::string> reasons) {
  for (const std::string& reason : reasons)
    if (!reason.empty()) return reason;
  return {};
}

LinearForm position(const LetterRun& r, const VariableStepLaw& law, const Fraction& t,
                    const Fraction& squares) {
  const Fraction first = letter(kFirstStep);
  const Fraction both = kHalf * law.drift * law.kick;
  return r.form(1, law.drift * t,
                law.start_position * first * first + law.drift * law.start_velocity * first * t +
                    both * t * t + (law.alpha - both) * squares);
}

LinearForm velocity(const LetterRun& r, const VariableStepLaw& law, const Fraction& t) {
  return r.form(0, 1, law.start_velocity * letter(kFirstStep) + law.kick * t);
}

/// Induction on n, with the step itself: the start gives n = 0, one step leads from n to n + 1.
bool proved(const Tape& tape, const VariableStepLaw& law, const Settled& settled,
            std::shared_ptr<ExtraLetters> extras) {
  LetterRun r(tape, letter(kFirstStep), std::move(extras));
  if (!(r.run.state(0) == position(r, law, 0, 0)) || !(r.run.state(1) == velocity(r, law, 0)) ||
      !settled.holds(r))
    return false;
  const Fraction t = letter(kElapsed), squares = letter(kSquares), h = letter(kStepNow);
  settled.put(r, position(r, law, t, squares), velocity(r, law, t));
  const auto [x, v] = r.run.read_out();
  if (!(x == position(r, law, t, squares) + r.acceleration(law.read_position * h * h)) ||
      !(v == velocity(r, law, t) + r.acceleration(law.read_velocity * h)))
    return false;
  r.step();
  return r.run.state(0) == position(r, law, t + h, squares + h * h) &&
         r.run.state(1) == velocity(r, law, t + h) && settled.holds(r);
}

VariableSteps of_tape(const Tape& tape) {
  VariableStepLaw law;
  const NumberField field;
  const auto extras = std::make_shared<ExtraLetters>(letter_names(tape));
  LetterRun r(tape, letter(kFirstStep), extras);
  const int a = r.force.force_column(0);
  const LinearForm start_x = r.run.state(0), start_v = r.run.state(1);
  const Settled settled(r);

  settled.put(r, LinearForm::column(0), LinearForm::column(1));
  const auto [read_x, read_v] = r.run.read_out();
  r.step();
  const LinearForm step_x = r.run.state(0), step_v = r.run.state(1);

  Row sx(tape, start_x, "at the start the position", kFirstStep);
  Row sv(tape, start_v, "at the start the velocity", kFirstStep);
  Row x(tape, step_x, "the position", kStepNow);
  Row v(tape, step_v, "the velocity", kStepNow);
  Row rx(tape, read_x, "the position that is reported", kStepNow);
  Row rv(tape, read_v, "the velocity that is reported", kStepNow);
  for (int i = 2; i < r.states; ++i)
    for (Row* row : {&x, &rx}) row->nothing(i, 0);
  for (int i = 2; i < r.states; ++i)
    for (Row* row : {&v, &rv}) row->nothing(i, 1);
  for (Row* row : {&sx, &x, &rx}) row->nothing(0, 0);
  for (Row* row : {&sv, &v, &rv}) row->nothing(0, 1);
  for (Row* row : {&sv, &v, &rv}) row->nothing(1, 1);
  for (Row* row : {&sx, &rx}) row->nothing(1, 0);
  law.drift = x.number(1, 1);
  law.alpha = x.number(a, 2);
  law.kick = v.number(a, 1);
  law.start_position = sx.number(a, 2);
  law.start_velocity = sv.number(a, 1);
  law.read_position = rx.number(a, 2);
  law.read_velocity = rv.number(a, 1);
  if (std::string why =
          first_of({x.reason(), v.reason(), sx.reason(), sv.reason(), rx.reason(), rv.reason()});
      !why.empty())
    return {std::nullopt, std::move(why)};
  law.letters = extras->names();
  for (const ExtraLetters::Extra& e : extras->all())
    for (const Fraction& number : {law.drift, law.alpha, law.kick, law.start_position, law.start_velocity,
                                   law.read_position, law.read_velocity})
      if (number.contains(e.letter))
        return {std::nullopt, "the law contains " + e.name + ", an irrational number"};
  if (!proved(tape, law, settled, extras))
    throw std::logic_error("the law of variable steps of " + tape.name + " fails its own induction");
  return {std::move(law), {}};
}

}  // namespace

bool VariableStepLaw::exact() const { return only_squares() && alpha == kHalf; }

bool VariableStepLaw::only_squares() const {
  return drift.is_one() && kick.is_one() && start_position.is_zero() && start_velocity.is_zero() &&
         read_position.is_zero();
}

VariableSteps variable_steps(const Program& program, const Values& given) {
  try {
    return of_tape(lower(program, given));
  } catch (const Unable& e) {
    return {std::nullopt, e.what()};
  } catch (const Undefined& e) {
    return {std::nullopt, e.what()};
  }
}

std::vector<Expr> unrolled_shortfalls(const Program& program, int frames, const Values& given) {
  const Tape tape = lower(program, given);
  std::vector<std::string> names = letter_names(tape);
  const int parameters = static_cast<int>(names.size());
  frames = std::min(frames, kLetters - parameters);
  names.resize(static_cast<std::size_t>(parameters + std::max(frames, 0)));
  const auto length = [&](int k) { return parameters + k - 1; };  // the letter h_k
  for (int k = 1; k <= frames; ++k) names[static_cast<std::size_t>(length(k))] = "h_" + std::to_string(k);
  std::vector<Expr> result;
  if (frames < 1) return result;
  const NumberField field;
  const auto extras = std::make_shared<ExtraLetters>(names);
  LetterRun r(tape, letter(length(1)), extras);
  Fraction t;
  for (int k = 1; k <= frames; ++k) {
    r.run.set_step(letter(length(k)));
    r.step();
    t += letter(length(k));
    const LinearForm missing = r.form(1, t, kHalf * t * t) - r.run.read_out().first;
    Expr sum = number(0);
    const std::vector<std::pair<int, std::string>> columns{
        {0, "x0"}, {1, "v0"}, {r.force.force_column(0), "a"}};
    for (const auto& [column, word] : columns)
      if (!missing[column].is_zero())
        sum = joined(sum, formula(missing[column], name(word), {extras->names(), "n", false}));
    result.push_back(sum);
  }
  return result;
}

Expr shortfall_formula(const VariableStepLaw& law) {
  Expr sum = number(0);
  const auto add = [&](const Fraction& coefficient, const Expr& what) {
    if (!coefficient.is_zero())
      sum = joined(sum, chained(formula(coefficient, name("a"), {law.letters}), what));
  };
  const Fraction both = kHalf * law.drift * law.kick;
  const Expr t = name("t"), first = name("h_1"), last = name("h_n");
  if (!law.drift.is_one())
    sum = joined(sum, chained(formula(Fraction(1) - law.drift, name("v0"), {law.letters}), t));
  add(kHalf - both, power(t, 2));
  add(both - law.alpha, shortfall::sum("k", number(1), name("n"), power(name("h_k"), 2)));
  add(-law.drift * law.start_velocity, first * t);
  add(-law.start_position, power(first, 2));
  add(-law.read_position, power(last, 2));
  return sum;
}

Expr position_change(const VariableStepLaw& law) {
  const Expr drift = formula(law.drift, name("h"), {law.letters});
  return joined(chained(drift, name("v")),
                chained(formula(law.alpha, name("a"), {law.letters}), power(name("h"), 2)));
}

Expr velocity_change(const VariableStepLaw& law) {
  return chained(formula(law.kick, name("a"), {law.letters}), name("h"));
}

Expr square_term(const VariableStepLaw& law) {
  return chained(formula(kHalf - law.alpha, name("a"), {law.letters}), power(name("h"), 2));
}

ListExactness list_exactness(const Program& program, const Values& given) {
  constexpr int kFrames = 3;
  ListExactness result{program.name, {}, {}, {}};
  if (program.approximate()) {
    result.reason = about_printed_decimals(program);
    return result;
  }
  try {
    const VariableSteps steps = variable_steps(program, parameter_values(program, given));
    if (steps.law) {
      result.exact = steps.law->exact();
      if (!*result.exact) result.shortfall = print(shortfall_formula(*steps.law));
      return result;
    }
    result.reason = steps.reason;
    const std::vector<Expr> missing = unrolled_shortfalls(program, kFrames, parameter_values(program, given));
    for (const Expr& e : missing)
      if (!is_number(e, 0)) {
        result.exact = false;
        result.shortfall = print(e);
        return result;
      }
  } catch (const Unable& e) {
    result.reason = e.what();
  } catch (const Undefined& e) {
    result.reason = e.what();
  }
  return result;
}

Program with_square_term(const Program& program, const VariableSteps& steps) {
  if (!steps.law || !steps.law->only_squares())
    throw Undefined("no term in the length h of a step alone makes every step of " + program.name + " exact" +
                    (steps.reason.empty() ? "" : ": " + steps.reason));
  if (steps.law->exact())
    throw Undefined("every step of " + program.name + " is exact: there is no term to add");
  Program corrected = program;
  corrected.name += "-with-square-term";
  const Expr squares = formula(kHalf - steps.law->alpha, power(name("h"), 2), {steps.law->letters});
  Statement term;
  term.name = "x";
  term.value = name("x") + squares * force(name("x"), name("v"), name("t"));
  corrected.step.push_back(std::move(term));
  corrected.tableau.reset();  // the step is more than it now
  corrected.claims.clear();
  corrected.aliases.clear();  // those are the names of the other
  corrected.description =
      program.name + " with a term that makes every step exact under a constant force, whatever its length.";
  return corrected;
}

}  // namespace shortfall
