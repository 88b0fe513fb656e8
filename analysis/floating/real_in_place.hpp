// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <utility>

namespace shortfall {

/// A number of MPFR, rounded to nearest, whose results can be written into memory that is there already.
///
/// A result has the larger precision of its operands, as a Real's; unlike a Real it asks nobody for a
/// default.
class RealInPlace {
 public:
  RealInPlace() {  // 0, of the least precision: it takes that of its first result
    mpfr_init2(value_, MPFR_PREC_MIN);
    mpfr_set_zero(value_, 1);
  }
  explicit RealInPlace(mpfr_srcptr value) {
    mpfr_init2(value_, mpfr_get_prec(value));
    mpfr_set(value_, value, MPFR_RNDN);
  }
  RealInPlace(const RealInPlace& other) : RealInPlace(other.value_) {}
  RealInPlace(RealInPlace&& other) noexcept {
    value_[0] = other.value_[0];
    other.value_[0]._mpfr_d = nullptr;
  }
  RealInPlace& operator=(const RealInPlace& other) {
    if (this == &other) return *this;
    if (!value_[0]._mpfr_d)
      mpfr_init2(value_, precision(other));
    else if (precision(*this) != precision(other))
      mpfr_set_prec(value_, precision(other));
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  RealInPlace& operator=(RealInPlace&& other) noexcept {
    std::swap(value_[0], other.value_[0]);
    return *this;
  }
  ~RealInPlace() {
    if (value_[0]._mpfr_d) mpfr_clear(value_);
  }

  mpfr_srcptr get() const { return value_; }

  friend void set_sum(RealInPlace& out, const RealInPlace& a, const RealInPlace& b) {
    set<mpfr_add>(out, a, b);
  }
  friend void set_difference(RealInPlace& out, const RealInPlace& a, const RealInPlace& b) {
    set<mpfr_sub>(out, a, b);
  }
  friend void set_product(RealInPlace& out, const RealInPlace& a, const RealInPlace& b) {
    set<mpfr_mul>(out, a, b);
  }
  friend void set_quotient(RealInPlace& out, const RealInPlace& a, const RealInPlace& b) {
    set<mpfr_div>(out, a, b);
  }
  friend void set_negative(RealInPlace& out, const RealInPlace& a) {
    if (&out != &a) out = a;
    out.value_[0]._mpfr_sign =
        -out.value_[0]._mpfr_sign;  // what mpfr_neg does, without looking for roundings
  }

  RealInPlace operator-() const {
    RealInPlace result(*this);
    set_negative(result, result);
    return result;
  }
  friend RealInPlace operator+(const RealInPlace& a, const RealInPlace& b) { return made(mpfr_add, a, b); }
  friend RealInPlace operator-(const RealInPlace& a, const RealInPlace& b) { return made(mpfr_sub, a, b); }
  friend RealInPlace operator*(const RealInPlace& a, const RealInPlace& b) { return made(mpfr_mul, a, b); }
  friend RealInPlace operator/(const RealInPlace& a, const RealInPlace& b) { return made(mpfr_div, a, b); }
  friend bool operator==(const RealInPlace& a, const RealInPlace& b) {
    return mpfr_equal_p(a.value_, b.value_);
  }
  friend bool operator<(const RealInPlace& a, const RealInPlace& b) {
    return mpfr_less_p(a.value_, b.value_);
  }

  friend RealInPlace sqrt(const RealInPlace& a) { return made(mpfr_sqrt, a); }
  friend RealInPlace exp(const RealInPlace& a) { return made(mpfr_exp, a); }
  friend RealInPlace log(const RealInPlace& a) { return made(mpfr_log, a); }
  friend RealInPlace pow(const RealInPlace& a, const RealInPlace& b) { return made(mpfr_pow, a, b); }

 private:
  static mpfr_prec_t precision(const RealInPlace& a) { return mpfr_get_prec(a.value_); }

  template <auto Operation>
  static void set(RealInPlace& out, const RealInPlace& a, const RealInPlace& b) {
    const mpfr_prec_t here = precision(out);
    if (here == precision(a) && here == precision(b)) [[likely]]
      Operation(out.value_, a.value_, b.value_, MPFR_RNDN);
    else if (&out == &a || &out == &b)  // its digits are still needed
      out = made(Operation, a, b);
    else {
      mpfr_set_prec(out.value_, std::max(precision(a), precision(b)));
      Operation(out.value_, a.value_, b.value_, MPFR_RNDN);
    }
  }
  template <class Operation, class... More>
  static RealInPlace made(Operation operation, const RealInPlace& a, const More&... more) {
    RealInPlace result;
    mpfr_set_prec(result.value_, std::max({precision(a), precision(more)...}));
    operation(result.value_, a.value_, more.value_..., MPFR_RNDN);
    return result;
  }

  mpfr_t value_;
};

}  // namespace shortfall
