// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/splitting.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

constexpr std::size_t kMostParts = 1000;

/// weight * h, as a person would write it.
Expr times_step(const Expr& weight, Place place) {
  const Expr h = name("h", place);
  return is_number(weight, 1) ? h : binary(Op::multiply, weight, h, place);
}

/// A number as it can be written: a decimal, or a quotient of whole numbers.
Expr literal(const Rational& value, Place place) {
  Rational rest = value.denominator();
  for (const int prime : {2, 5})
    while ((rest / Rational(prime)).is_integer()) rest /= Rational(prime);
  if (rest == Rational(1)) return number(value, place);
  const Expr size =
      binary(Op::divide, number(value.abs().numerator(), place), number(value.denominator(), place), place);
  return value.sign() < 0 ? negate(size, place) : size;
}

}  // namespace

void read_splitting_row(Splitting& splitting, const std::string& word, TokenReader& in, Place place) {
  if (in.at_end()) throw in.error("expected a number after '" + word + "', found the end of the line");
  Expr weight = in.expression();
  in.expect_end("the row");
  splitting.parts.push_back({word == "kick", std::move(weight), place});
}

void lower_splitting(Program& program, const Source& source) {
  const Splitting& splitting = *program.splitting;
  if (splitting.parts.empty()) throw source.error(splitting.place, "the splitting has no rows");
  if (splitting.parts.size() > kMostParts)
    throw source.error(splitting.place,
                       "the splitting has more than " + std::to_string(kMostParts) + " rows");
  // The part of the step that the drifts have covered: a number as long as the weights are, otherwise a sum.
  Rational number_part;
  Expr other_part;
  for (const auto& [kick, weight, place] : splitting.parts) {
    if (!kick) {
      program.step.push_back(
          {Statement::Kind::assign,
           "x",
           binary(Op::add, name("x", place),
                  binary(Op::multiply, times_step(weight, place), name("v", place), place), place),
           {},
           {},
           place});
      if (const auto value = literal_value(weight))
        number_part += *value;
      else
        other_part = other_part ? binary(Op::add, other_part, weight, place) : weight;
      continue;
    }
    Expr covered = other_part;
    if (!number_part.is_zero() || !covered) {
      const Expr exact = literal(number_part, place);
      covered = covered ? binary(Op::add, covered, exact, place) : exact;
    }
    const Expr time = is_number(covered, 0)
                          ? name("t", place)
                          : binary(Op::add, name("t", place), times_step(covered, place), place);
    const Expr acceleration = force(name("x", place), name("v", place), time, place);
    program.step.push_back(
        {Statement::Kind::assign,
         "v",
         binary(Op::add, name("v", place),
                binary(Op::multiply, times_step(weight, place), acceleration, place), place),
         {},
         {},
         place});
  }
}

}  // namespace shortfall
