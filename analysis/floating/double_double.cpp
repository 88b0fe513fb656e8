// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/double_double.hpp"

#include <mpfr.h>

namespace shortfall {

namespace {

/// A number of MPFR, enough for the sum of two binary64 that are not far apart; its precision is its own, so
/// that threads do not meet.
class Wide {
 public:
  Wide() { mpfr_init2(value_, 200); }
  explicit Wide(const DoubleDouble& a) : Wide() {
    mpfr_set_d(value_, a.high(), MPFR_RNDN);
    mpfr_add_d(value_, value_, a.low(), MPFR_RNDN);
  }
  Wide(const Wide&) = delete;
  Wide& operator=(const Wide&) = delete;
  ~Wide() { mpfr_clear(value_); }
  mpfr_ptr get() { return value_; }

  DoubleDouble narrow() {
    const double high = mpfr_get_d(value_, MPFR_RNDN);
    if (!std::isfinite(high)) return DoubleDouble(high);
    mpfr_sub_d(value_, value_, high, MPFR_RNDN);
    return {high, mpfr_get_d(value_, MPFR_RNDN)};
  }

 private:
  mpfr_t value_;
};

using MpfrFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

DoubleDouble computed(MpfrFunction f, const DoubleDouble& a) {
  Wide wide(a);
  f(wide.get(), wide.get(), MPFR_RNDN);
  return wide.narrow();
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
  return computed(mpfr_sin, a);
}

DoubleDouble cos(const DoubleDouble& a) {
  if (!finite(a)) return DoubleDouble(std::cos(a.high()));
  return computed(mpfr_cos, a);
}

DoubleDouble exp(const DoubleDouble& a) {
  if (!finite(a)) return DoubleDouble(std::exp(a.high()));
  return computed(mpfr_exp, a);
}

DoubleDouble log(const DoubleDouble& a) {
  if (!finite(a) || !(a.high() > 0)) return DoubleDouble(std::log(a.high()));
  return computed(mpfr_log, a);
}

DoubleDouble pow(const DoubleDouble& a, const DoubleDouble& b) {
  if (!finite(a) || !finite(b) || !(a.high() > 0)) return DoubleDouble(std::pow(a.high(), b.high()));
  Wide base(a), exponent(b);
  mpfr_pow(base.get(), base.get(), exponent.get(), MPFR_RNDN);
  return base.narrow();
}

}  // namespace shortfall
