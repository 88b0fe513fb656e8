// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/lettered_step.hpp"

#include <algorithm>

#include "analysis/correction/kit_letters.hpp"
#include "analysis/motion/formula_text.hpp"

namespace shortfall {

namespace {

/// Whether a row is this column and nothing else.
bool is_column(const LinearForm& row, int column) {
  for (int c = 0; c < row.columns(); ++c)
    if (!(row[c] == Fraction(c == column ? 1 : 0))) return false;
  return row.columns() > column;
}

bool is_plain(const OpenStep& step) {
  return step.states() == 2 && step.map.force.degree <= 0 && is_column(step.map.position, 0) &&
         is_column(step.map.velocity, 1) && is_column(step.map.start[0], 0) &&
         is_column(step.map.start[1], 1);
}

/// Hands out letters that are neither numbers nor used by what is solved.
class Letters {
 public:
  explicit Letters(LetteredStep& result) : result_(result) {}

  Fraction operator()(const Fraction& value, const std::string& name, const std::string& note) {
    if (value.is_constant()) return value;
    for (std::size_t i = 0; i < result_.meanings.size(); ++i)
      if (result_.meanings[i].value == value) return Fraction::letter(letters_[i]);
    while (is_number(next_)) ++next_;
    if (next_ >= kTrueStiffness)
      return value;  // cannot be: eight letters, six entries, at most two of them numbers
    result_.meanings.push_back({unused_name(name, result_.names), value, note});
    result_.names[next_] = result_.meanings.back().name;
    letters_.push_back(next_);
    return Fraction::letter(next_++);
  }

 private:
  static bool is_number(Letter letter) {
    return NumberField::current() && std::ranges::any_of(NumberField::current()->generators(),
                                                         [&](const auto& g) { return g.letter == letter; });
  }
  LetteredStep& result_;
  std::vector<Letter> letters_;
  Letter next_ = kStiffness;
};

}  // namespace

std::optional<LetteredStep> lettered(const OpenStep& step, const std::vector<std::string>& names) {
  if (!is_plain(step)) return std::nullopt;
  const auto generators = NumberField::current() ? NumberField::current()->generators().size() : 0;
  if (generators > 2) return std::nullopt;
  LetteredStep result{step, names, {}};
  Letters letter(result);
  for (int i : {0, 1})
    for (int j : {0, 1})
      result.step.matrix[i][j] =
          letter(step.matrix[i][j], "m" + std::to_string(i + 1) + std::to_string(j + 1),
                 "entry of the matrix of the step");
  const Matrix& m = result.step.matrix;
  result.step.pair = {m[0][0] * m[1][1] - m[0][1] * m[1][0], -m[0][0] - m[1][1], Fraction(1)};
  if (step.map.force.degree == 0) {
    const Fraction x = letter(step.position(0), "xr", "where the integrator rests under the acceleration 1");
    const Fraction v = letter(step.velocity(0), "vr", "the velocity that it reports there");
    result.step.form.position[2] = Sequence(x);
    result.step.form.velocity[2] = Sequence(v);
    result.step.form.states[0][2] = Sequence(x);
    result.step.form.states[1][2] = Sequence(v);
  }
  return result;
}

}  // namespace shortfall
