// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/line_check.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula_text.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

/// Whether all that varies in the body of a sum over k is k itself, or what is counted by it.
bool only_k_enters(const Expr& e) {
  if (e->op == Op::sum) return false;
  if (e->op == Op::name)
    return e->name != "n" && e->name != "t" && e->name.find("(t)") == std::string::npos &&
           e->name.find("_n") == std::string::npos && e->name.find("_out") == std::string::npos;
  return std::ranges::all_of(e->operands, only_k_enters);
}

}  // namespace

LineCheck::LineCheck(const StepMap& map, const std::vector<Quantity>& quantities, int degree, int points,
                     Progress progress)
    : map_(map),
      quantities_(quantities),
      degree_(degree),
      progress_(std::move(progress)),
      states_(stepped(map, points, progress_)) {}

LinearForm LineCheck::quantity(int q, int n) const {
  return reported(quantities_[q].definition, states_.at(n), n, map_.force.states);
}

bool LineCheck::agree(const Expr& left, const Expr& right, const std::string& index, int from, int to) const {
  Memory memory;  // for these two expressions only: it knows them by their addresses
  for (int n = from; n <= to; ++n) {
    if (progress_) progress_("proving a line", n - from, to - from + 1);
    const Indices indices{{index, n}};
    const Value a = evaluated(left, indices, memory);
    const Value b = evaluated(right, indices, memory);
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

bool LineCheck::is_letter(const std::string& name) const {
  for (int c = 0; c < 2 + degree_ + 1; ++c)
    if (name == column_name(c, degree_)) return true;
  return std::ranges::find(map_.letters, name) != map_.letters.end();
}

/// Whether an index enters, by name or through t, x(t), x_k, x_n, ...
bool LineCheck::varies(const Expr& e, Memory& memory) const {
  const auto known = memory.varies.find(e.get());
  if (known != memory.varies.end()) return known->second;
  bool result = e->op == Op::sum;
  if (e->op == Op::name)
    result = e->name == "n" || e->name == "k" || e->name == "t" || !is_letter(e->name) ||
             e->name.find("_n") != std::string::npos || e->name.find("_k") != std::string::npos;
  for (const Expr& operand : e->operands) result = varies(operand, memory) || result;
  memory.varies[e.get()] = result;
  return result;
}

LineCheck::Value LineCheck::evaluated(const Expr& e, const Indices& indices, Memory& memory) const {
  if (e->operands.empty() || varies(e, memory)) return worked_out(e, indices, memory);
  const auto known = memory.values.find(e.get());
  if (known != memory.values.end()) return known->second;
  return memory.values[e.get()] = worked_out(e, indices, memory);
}

LineCheck::Value LineCheck::summed(const Expr& e, const Indices& indices, Memory& memory) const {
  const auto whole = [&](const Expr& o) {
    std::int64_t value = 0;
    std::get<Fraction>(evaluated(o, indices, memory)).constant().fits_int64(value);
    return value;
  };
  const std::int64_t from = whole(e->operands[0]);
  const std::int64_t to = whole(e->operands[1]);
  const Expr& body = e->operands[2];
  Memory::PartialSum fresh{from, Fraction()};
  Memory::PartialSum* sum = &fresh;
  if (e->name == "k" && only_k_enters(body))
    sum = &memory.sums.try_emplace({e.get(), from}, fresh).first->second;
  if (sum->next > to + 1) *sum = {from, Fraction()};  // it stands further already
  Indices inside = indices;
  for (; sum->next <= to; ++sum->next) {
    inside[e->name] = static_cast<int>(sum->next);
    const Value term = evaluated(body, inside, memory);
    if (const auto* vector = std::get_if<LinearForm>(&term)) {
      if (!std::holds_alternative<LinearForm>(sum->value)) sum->value = LinearForm();
      std::get<LinearForm>(sum->value) += *vector;
    } else {
      std::get<Fraction>(sum->value) += std::get<Fraction>(term);
    }
  }
  return sum->value;
}

LineCheck::Value LineCheck::worked_out(const Expr& e, const Indices& indices, Memory& memory) const {
  const auto scalar = [&](const Expr& o) { return std::get<Fraction>(evaluated(o, indices, memory)); };
  switch (e->op) {
    case Op::number:
      return Fraction(e->value);
    case Op::name:
      return of_name(e->name, indices);
    case Op::negate:
      return std::visit([](const auto& v) -> Value { return -v; },
                        evaluated(e->operands[0], indices, memory));
    case Op::add:
    case Op::subtract: {
      const Value a = evaluated(e->operands[0], indices, memory);
      const Value b = evaluated(e->operands[1], indices, memory);
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
      const Value a = evaluated(e->operands[0], indices, memory);
      const Value b = evaluated(e->operands[1], indices, memory);
      if (std::holds_alternative<LinearForm>(a)) return std::get<Fraction>(b) * std::get<LinearForm>(a);
      if (std::holds_alternative<LinearForm>(b)) return std::get<Fraction>(a) * std::get<LinearForm>(b);
      return std::get<Fraction>(a) * std::get<Fraction>(b);
    }
    case Op::divide: {
      const Value a = evaluated(e->operands[0], indices, memory);
      const Fraction b = scalar(e->operands[1]);
      if (std::holds_alternative<LinearForm>(a)) return std::get<LinearForm>(a) / b;
      return std::get<Fraction>(a) / b;
    }
    case Op::power: {
      std::int64_t exponent = 0;
      scalar(e->operands[1]).constant().fits_int64(exponent);
      return scalar(e->operands[0]).pow(static_cast<int>(exponent));
    }
    case Op::sum:
      return summed(e, indices, memory);
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
