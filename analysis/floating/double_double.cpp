// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/double_double.hpp"

#include "analysis/algebra/real.hpp"

namespace shortfall {

namespace {

constexpr int kDigits = 50;

Real wide(const DoubleDouble& a) {
  return real(Rational::from_double(a.high()), kDigits) + real(Rational::from_double(a.low()), kDigits);
}

DoubleDouble narrow(const Real& r) {
  const double high = r.convert_to<double>();
  if (!std::isfinite(high)) return DoubleDouble(high);
  return {high, Real(r - high).convert_to<double>()};
}

bool finite(const DoubleDouble& a) { return std::isfinite(a.high()); }

}  // namespace

DoubleDouble double_double(const Rational& value) {
  const double high = value.to_double();
  if (!std::isfinite(high)) return DoubleDouble(high);
  return {high, (value - Rational::from_double(high)).to_double()};
}

DoubleDouble sin(const DoubleDouble& a) {
  if (!finite(a)) return DoubleDouble(std::sin(a.high()));
  const Precision precision(kDigits);
  return narrow(Real(boost::multiprecision::sin(wide(a))));
}

DoubleDouble cos(const DoubleDouble& a) {
  if (!finite(a)) return DoubleDouble(std::cos(a.high()));
  const Precision precision(kDigits);
  return narrow(Real(boost::multiprecision::cos(wide(a))));
}

DoubleDouble exp(const DoubleDouble& a) {
  if (!finite(a)) return DoubleDouble(std::exp(a.high()));
  const Precision precision(kDigits);
  return narrow(Real(boost::multiprecision::exp(wide(a))));
}

DoubleDouble log(const DoubleDouble& a) {
  if (!finite(a) || !(a.high() > 0)) return DoubleDouble(std::log(a.high()));
  const Precision precision(kDigits);
  return narrow(Real(boost::multiprecision::log(wide(a))));
}

DoubleDouble pow(const DoubleDouble& a, const DoubleDouble& b) {
  if (!finite(a) || !finite(b) || !(a.high() > 0)) return DoubleDouble(std::pow(a.high(), b.high()));
  const Precision precision(kDigits);
  return narrow(Real(boost::multiprecision::pow(wide(a), wide(b))));
}

}  // namespace shortfall
