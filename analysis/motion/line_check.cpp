// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/line_check.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula_text.hpp"

namespace shortfall {

using Op = Expression::Op;

LineCheck::LineCheck(const StepMap& map, const std::vector<Quantity>& quantities, int degree, int points)
    : map_(map), quantities_(quantities), degree_(degree), states_(stepped(map, points)) {}

LinearForm LineCheck::quantity(int q, int n) const {
  return reported(quantities_[q].definition, states_.at(n), n, map_.force.states);
}

bool LineCheck::agree(const Expr& left, const Expr& right, const std::string& index, int from, int to) const {
  for (int n = from; n <= to; ++n) {
    const Indices indices{{index, n}};
    const Value a = evaluated(left, indices);
    const Value b = evaluated(right, indices);
    // A formula that came out as the number 0 is the zero vector.
    const auto zero = [](const Value& v) {
      return std::holds_alternative<Fraction>(v) && std::get<Fraction>(v).is_zero();
    };
    const LinearForm x = zero(a) ? LinearForm() : std::get<LinearForm>(a);
    const LinearForm y = zero(b) ? LinearForm() : std::get<LinearForm>(b);
    if (!(x == y)) return false;
  }
  return true;
}

LinearForm LineCheck::exact(int n, bool position) const {
  const Motion motion = position ? exact_position(degree_) : exact_velocity(degree_);
  LinearForm value;
  for (std::size_t c = 0; c < motion.size(); ++c)
    value.at(c < 2 ? static_cast<int>(c) : map_.force.force_column(static_cast<int>(c) - 2)) =
        motion[c].at(n);
  return value;
}

LineCheck::Value LineCheck::of_name(const std::string& name, const Indices& indices) const {
  const auto count = [&](const std::string& letter) { return indices.at(letter); };
  if (indices.contains(name)) return Fraction(count(name));
  if (name == "t") return Fraction(count("n")) * Fraction::letter(kStepLetter);
  if (name == "x(t)" || name == "v(t)") return exact(count("n"), name == "x(t)");
  if (name == "x_out" || name == "v_out")
    return reported(name == "x_out" ? map_.position : map_.velocity, states_.at(count("n")), count("n"),
                    map_.force.states);
  for (int c = 0; c < 2 + degree_ + 1; ++c)
    if (name == column_name(c, degree_))
      return LinearForm::column(c < 2 ? c : map_.force.force_column(c - 2));
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    const std::string& stem = quantities_[q].name;
    if (name == stem + "_n") return quantity(static_cast<int>(q), count("n"));
    if (name == stem + "_k") return quantity(static_cast<int>(q), count("k"));
    if (name == stem + "_{k+1}") return quantity(static_cast<int>(q), count("k") + 1);
  }
  for (std::size_t s = 0; s < map_.states.size(); ++s)
    if (name == map_.states[s] + "_k") return states_.at(count("k"))[s];
  const auto letter = std::ranges::find(map_.letters, name);
  if (letter == map_.letters.end())
    throw Error("a derivation mentions '" + name + "', which it does not know");
  return Fraction::letter(static_cast<Letter>(letter - map_.letters.begin()));
}

LineCheck::Value LineCheck::evaluated(const Expr& e, const Indices& indices) const {
  const auto scalar = [&](const Expr& o) { return std::get<Fraction>(evaluated(o, indices)); };
  switch (e->op) {
    case Op::number:
      return Fraction(e->value);
    case Op::name:
      return of_name(e->name, indices);
    case Op::negate:
      return std::visit([](const auto& v) -> Value { return -v; }, evaluated(e->operands[0], indices));
    case Op::add:
    case Op::subtract: {
      const Value a = evaluated(e->operands[0], indices);
      const Value b = evaluated(e->operands[1], indices);
      const bool plus = e->op == Op::add;
      if (std::holds_alternative<Fraction>(a)) {
        const Fraction x = std::get<Fraction>(a);
        if (std::holds_alternative<LinearForm>(b))
          return plus ? std::get<LinearForm>(b) : -std::get<LinearForm>(b);
        return plus ? x + std::get<Fraction>(b) : x - std::get<Fraction>(b);
      }
      const LinearForm right = std::holds_alternative<LinearForm>(b) ? std::get<LinearForm>(b) : LinearForm();
      return plus ? std::get<LinearForm>(a) + right : std::get<LinearForm>(a) - right;
    }
    case Op::multiply: {
      const Value a = evaluated(e->operands[0], indices);
      const Value b = evaluated(e->operands[1], indices);
      if (std::holds_alternative<LinearForm>(a)) return std::get<Fraction>(b) * std::get<LinearForm>(a);
      if (std::holds_alternative<LinearForm>(b)) return std::get<Fraction>(a) * std::get<LinearForm>(b);
      return std::get<Fraction>(a) * std::get<Fraction>(b);
    }
    case Op::divide: {
      const Value a = evaluated(e->operands[0], indices);
      const Fraction b = scalar(e->operands[1]);
      if (std::holds_alternative<LinearForm>(a)) return std::get<LinearForm>(a) / b;
      return std::get<Fraction>(a) / b;
    }
    case Op::power: {
      std::int64_t exponent = 0;
      scalar(e->operands[1]).constant().fits_int64(exponent);
      return scalar(e->operands[0]).pow(static_cast<int>(exponent));
    }
    case Op::sum: {
      std::int64_t from = 0;
      std::int64_t to = 0;
      scalar(e->operands[0]).constant().fits_int64(from);
      scalar(e->operands[1]).constant().fits_int64(to);
      Indices inside = indices;
      LinearForm vectors;
      Fraction scalars;
      bool is_vector = false;
      for (std::int64_t k = from; k <= to; ++k) {
        inside[e->name] = static_cast<int>(k);
        const Value term = evaluated(e->operands[2], inside);
        if (std::holds_alternative<LinearForm>(term)) {
          vectors += std::get<LinearForm>(term);
          is_vector = true;
        } else {
          scalars += std::get<Fraction>(term);
        }
      }
      if (is_vector) return vectors;
      return scalars;
    }
    case Op::call: {
      const Fraction a = scalar(e->operands[0]);
      return map_.force.extras->function(*function_named(e->name), a,
                                         e->operands.size() > 1 ? scalar(e->operands[1]) : a);
    }
    case Op::force:
      break;
  }
  throw Error("a derivation cannot evaluate a force");
}

}  // namespace shortfall
