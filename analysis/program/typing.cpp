// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/typing.hpp"

#include <algorithm>

#include "analysis/program/function.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

constexpr int kHighestPower = 10'000;  // also of digits
constexpr int kLargestExponent = 1000;

class Typing {
 public:
  Typing(const Names& names, const Source& source) : names_(names), source_(source) {}

  Judgement of(const Expr& e) const {
    Judgement j = unbounded(e);
    if (j.value && j.value->digits() > static_cast<std::size_t>(kHighestPower)) throw too_long(e);
    if (j.growth > kHighestPower)
      throw source_.error(e->place, "the powers here multiply up to more than 10,000, which is our limit");
    return j;
  }

 private:
  Judgement unbounded(const Expr& e) const {
    switch (e->op) {
      case Op::number:
        return {{Sort::scalar, kPure, e->value.is_zero()}, e->value, 0};
      case Op::name:
        return of_name(e);
      case Op::negate:
        return negated(of(e->operands[0]));
      case Op::add:
      case Op::subtract:
        return of_sum(e);
      case Op::multiply:
        return of_product(e);
      case Op::divide:
        return of_quotient(e);
      case Op::power:
        return of_power(e);
      case Op::force:
        return of_force(e);
      case Op::call:
        return of_call(e);
      case Op::sum:
        break;
    }
    throw source_.error(e->place, "a sum cannot stand here");
  }

  SyntaxError too_long(const Expr& e) const {
    return source_.error(e->place, "the number has more than 10,000 digits, which is our limit");
  }

  Judgement of_name(const Expr& e) const {
    const auto found = names_.known.find(e->name);
    const bool known = found != names_.known.end();
    if (known && found->second.assigned)
      return {found->second.type, found->second.value, found->second.growth};
    if (known || names_.later.contains(e->name))
      throw source_.error(e->place, "'" + e->name + "' is used before it is assigned" +
                                        (known ? "" : "; what is kept from step to step is a state"));
    if (const auto hint = names_.hints.find(e->name); hint != names_.hints.end())
      throw source_.error(e->place, hint->second);
    if (e->name == "a" && names_.force)
      throw source_.error(
          e->place, "a is the force: write a(x, v, t), the acceleration at a position, velocity and time");
    std::vector<std::string> candidates;
    for (const auto& [name, entry] : names_.known)
      if (entry.assigned) candidates.push_back(name);
    if (names_.force) candidates.push_back("a(x, v, t)");
    const std::string suggestion = did_you_mean(e->name, candidates);
    throw source_.error(
        e->place, "unknown name '" + e->name + "'" + (suggestion.empty() ? names_.allowed : suggestion));
  }

  static Judgement negated(Judgement j) {
    if (j.value) j.value = -*j.value;
    return j;
  }

  Judgement of_sum(const Expr& e) const {
    const Judgement left = of(e->operands[0]);
    const Judgement right = of(e->operands[1]);
    Judgement j{left.type, {}, std::max(left.growth, right.growth)};
    if (left.value && right.value)
      j.value = e->op == Op::add ? *left.value + *right.value : *left.value - *right.value;
    if (left.type.zero) {
      j.type = right.type;
    } else if (!right.type.zero) {
      if (!left.type.same_as(right.type))
        throw source_.error(
            e->place, e->op == Op::add ? "cannot add " + left.type.str() + " and " + right.type.str()
                                       : "cannot subtract " + right.type.str() + " from " + left.type.str());
      j.type.zero = j.value && j.value->is_zero() && is_literal(e);
    }
    return j;
  }

  Judgement of_product(const Expr& e) const {
    const Judgement left = of(e->operands[0]);
    const Judgement right = of(e->operands[1]);
    const bool vector = left.type.sort == Sort::vector || right.type.sort == Sort::vector;
    if (vector && left.type.sort == right.type.sort)
      throw source_.error(e->place, "cannot multiply two vectors, " + left.type.dimension.bracketed() +
                                        " and " + right.type.dimension.bracketed());
    Judgement j{{vector ? Sort::vector : Sort::scalar, left.type.dimension * right.type.dimension,
                 left.type.zero || right.type.zero},
                {},
                left.growth + right.growth};
    if (left.value && right.value) j.value = *left.value * *right.value;
    return j;
  }

  Judgement of_quotient(const Expr& e) const {
    const Judgement left = of(e->operands[0]);
    const Judgement right = of(e->operands[1]);
    if (right.type.zero || (right.value && right.value->is_zero()))
      throw source_.error(e->place, "division by zero");
    if (right.type.sort == Sort::vector)
      throw source_.error(e->place, "cannot divide by a vector, here " + right.type.dimension.bracketed());
    Judgement j{{left.type.sort, left.type.dimension / right.type.dimension, left.type.zero},
                {},
                left.growth + right.growth};
    if (left.value && right.value) j.value = *left.value / *right.value;
    return j;
  }

  Judgement of_power(const Expr& e) const {
    const Judgement base = of(e->operands[0]);
    if (base.type.sort == Sort::vector)
      throw source_.error(e->place, "a vector, here " + base.type.dimension.bracketed() + ", has no powers");
    const Expr& exponent = e->operands[1];
    const bool minus = exponent->op == Op::negate;
    const Expr& digits = minus ? exponent->operands[0] : exponent;
    std::int64_t size = 0;
    if (digits->op == Op::number && digits->value.fits_int64(size) && size <= kLargestExponent)
      return raised(e, base, static_cast<int>(minus ? -size : size));
    if (names_.symbolic_powers) {
      const Judgement symbolic = of(exponent);
      if (base.type.dimension == kPure && symbolic.type.same_as({Sort::scalar, kPure}))
        return {base.type, {}, base.growth + symbolic.growth};
    }
    throw source_.error(beginning(exponent), "an exponent is a whole number from -1000 to 1000");
  }

  Judgement raised(const Expr& e, const Judgement& base, int exponent) const {
    const int size = std::abs(exponent);
    const bool zero = base.type.zero || (base.value && base.value->is_zero());
    if (exponent < 0 && zero) throw source_.error(e->place, "division by zero: a negative power of 0");
    Judgement j{{Sort::scalar, base.type.dimension.pow(exponent), false}, {}, base.growth * size};
    if (!base.value) return j;
    if (base.value->digits() * static_cast<std::size_t>(size) > 2 * static_cast<std::size_t>(kHighestPower))
      throw too_long(e);
    j.value = base.value->pow(exponent);
    j.type.zero = base.type.zero && exponent > 0;
    return j;
  }

  Judgement of_force(const Expr& e) const {
    if (!names_.force) throw source_.error(e->place, "the force cannot be called here");
    static const Type wanted[] = {{Sort::vector, kLength}, {Sort::vector, kVelocity}, {Sort::scalar, kTime}};
    static const char* const what[] = {"first value of a(x, v, t) is a position",
                                       "second value of a(x, v, t) is a velocity",
                                       "third value of a(x, v, t) is a time"};
    int growth = 0;
    for (int i = 0; i < 3; ++i) {
      const Judgement given = of(e->operands[i]);
      growth = std::max(growth, given.growth);
      if (!given.type.zero && !given.type.same_as(wanted[i]))
        throw source_.error(beginning(e->operands[i]), std::string("the ") + what[i] + ", " +
                                                           wanted[i].str() + "; found " + given.type.str());
    }
    return {{Sort::vector, kAcceleration}, {}, growth};
  }

  Judgement of_call(const Expr& e) const {
    const Function f = *function_named(e->name);
    if (!is_one_of(names_.functions, f))
      throw source_.error(e->place, names_.functions == Functions::none
                                        ? "the function '" + e->name + "' cannot be called here"
                                        : "there is no function '" + e->name + "' here; there are " +
                                              function_list(Functions::of_programs));
    std::vector<Judgement> given;
    int growth = 1;
    for (const Expr& operand : e->operands) {
      given.push_back(of(operand));
      growth = std::max(growth, given.back().growth);
      if (given.back().type.sort == Sort::vector)
        throw source_.error(beginning(operand), e->name + " takes scalars; found " + given.back().type.str());
    }
    Judgement j{{Sort::scalar, kPure}, {}, growth};
    switch (f) {
      case Function::sqrt:
        j.type.dimension = halved(e, given[0]);
        if (given[0].value && given[0].value->sign() < 0)
          throw source_.error(e->place, "the square root of a negative number");
        break;
      case Function::max:
      case Function::min:
        j.type.dimension = common(e, given).dimension;
        break;
      case Function::pow:
        require_pure(e, 0, given[0]);
        if (!given[1].type.same_as({Sort::scalar, kTime})) require_pure(e, 1, given[1]);
        break;
      case Function::log:
        require_pure(e, 0, given[0]);
        if (names_.log_is_rate) j.type.dimension = Dimension{0, -1};
        break;
      default:
        require_pure(e, 0, given[0]);
    }
    return j;
  }

  Dimension halved(const Expr& e, const Judgement& given) const {
    const Dimension d = given.type.dimension;
    if (d.length % 2 != 0 || d.time % 2 != 0)
      throw source_.error(beginning(e->operands[0]),
                          "the square root of a " + given.type.str() + " has no dimension of whole powers");
    return {d.length / 2, d.time / 2};
  }

  Type common(const Expr& e, const std::vector<Judgement>& given) const {
    if (given[0].type.zero) return given[1].type;
    if (!given[1].type.zero && !given[0].type.same_as(given[1].type))
      throw source_.error(
          beginning(e->operands[1]),
          e->name + " compares like with like, not " + given[0].type.str() + " with " + given[1].type.str());
    return given[0].type;
  }

  void require_pure(const Expr& e, std::size_t operand, const Judgement& given) const {
    if (given.type.zero || given.type.dimension == kPure) return;
    throw source_.error(
        beginning(e->operands[operand]),
        e->name == "pow" && operand == 1
            ? "the exponent of pow is a number or a time (in seconds); found " + given.type.str()
            : e->name + " takes a number without dimension; found " + given.type.str());
  }

  /// Whether it is made of numbers only, so that no parameter can change its value.
  static bool is_literal(const Expr& e) {
    return e->op != Op::name && e->op != Op::force && std::ranges::all_of(e->operands, is_literal);
  }

  const Names& names_;
  const Source& source_;
};

}  // namespace

Judgement judged(const Expr& e, const Names& names, const Source& source) {
  return Typing(names, source).of(e);
}

Type type_of(const Expr& e, const Names& names, const Source& source) {
  return judged(e, names, source).type;
}

}  // namespace shortfall
