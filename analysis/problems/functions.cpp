// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/problems/functions.hpp"

#include <cstdlib>

namespace shortfall {

namespace {

constexpr std::int64_t kHighestExponent = 1'000'000;

std::string shown(const Surd& value) {
  const std::string text = value.str();
  return text.size() <= 40 ? text : "about " + value.significant(10);
}

Unable irrational(Function f, const std::string& arguments) {
  return Unable(std::string(name_of(f)) + "(" + arguments + ") has no value in exact numbers of this kind");
}

}  // namespace

Rational value_of(Function f, const Rational& a, const Rational& b) {
  const Surd value = value_of(f, Surd(a), Surd(b));
  if (!value.is_rational()) throw irrational(f, shown(a));
  return value.rational_part();
}

Surd value_of(Function f, const Surd& a, const Surd& b) {
  switch (f) {
    case Function::max:
      return a < b ? b : a;
    case Function::min:
      return b < a ? b : a;
    case Function::sqrt:
      if (a.sign() < 0) throw Undefined("the square root of a negative number, " + shown(a));
      if (a.is_rational()) return Surd::sqrt(a.rational_part());
      break;
    case Function::exp:
      if (a.is_zero()) return 1;
      break;
    case Function::log:
      if (a == Surd(1)) return 0;
      break;
    case Function::pow: {
      if (a == Surd(1) || b.is_zero()) return 1;
      std::int64_t exponent = 0;
      const bool whole = b.is_rational() && b.rational_part().fits_int64(exponent);
      if (!whole || std::abs(exponent) > kHighestExponent || !a.is_rational()) break;
      if (a.is_zero() && exponent < 0) throw Undefined("zero has no negative power");
      return a.rational_part().pow(static_cast<int>(exponent));
    }
    default:
      break;
  }
  throw irrational(f, f == Function::pow ? shown(a) + ", " + shown(b) : shown(a));
}

}  // namespace shortfall
