// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/ball.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

#include "analysis/algebra/arb.hpp"
#include "analysis/algebra/decimal.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/algebra/flint_integer.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/pi.hpp"

namespace shortfall {

struct BallAccess {
  static arb_struct* of(Ball& b) { return std::launder(reinterpret_cast<arb_struct*>(b.storage_)); }
  static const arb_struct* of(const Ball& b) {
    return std::launder(reinterpret_cast<const arb_struct*>(b.storage_));
  }
};

namespace {

static_assert(alignof(arb_struct) <= 8);

arb_struct* raw(Ball& b) { return BallAccess::of(b); }
const arb_struct* raw(const Ball& b) { return BallAccess::of(b); }

/// A rational number of FLINT for as long as it lives.
struct FlintRational {
  explicit FlintRational(const Rational& value) {
    fmpq_init(number);
    const mpq_class exact = gmp(value);
    fmpq_set_mpq(number, exact.get_mpq_t());
  }
  FlintRational(const FlintRational&) = delete;
  FlintRational& operator=(const FlintRational&) = delete;
  ~FlintRational() { fmpq_clear(number); }
  fmpq_t number;
};

template <class Function>
Ball applied(Function function, const Ball& x) {
  Ball result(0, x.bits());
  function(raw(result), raw(x), x.bits());
  return result;
}

/// floor(log10 |x|), or one beside it; the ball must not contain 0.
mpz_class decimal_exponent(const Ball& x) {
  constexpr int kBits = 128;
  Ball size(0, kBits);
  arb_abs(raw(size), raw(x));
  Ball logarithm(0, kBits);
  arb_log(raw(logarithm), raw(size), kBits);
  Ball ten(0, kBits);
  arb_log_ui(raw(ten), 10, kBits);
  logarithm /= ten;
  FlintInteger floor;
  arf_floor(arb_midref(raw(logarithm)), arb_midref(raw(logarithm)));
  arf_get_fmpz(floor.value, arb_midref(raw(logarithm)), ARF_RND_FLOOR);
  return floor.gmp();
}

}  // namespace

Ball::Ball(const Rational& value, int bits) : bits_(bits) {
  static_assert(kSize == sizeof(arb_struct));
  if (bits < 2 || bits > 100'000'000) throw Error("a ball has from 2 to 100,000,000 bits");
  new (storage_) arb_struct;
  arb_init(raw(*this));
  std::int64_t whole = 0;
  if (value.fits_int64(whole))
    arb_set_si(raw(*this), whole);
  else
    arb_set_fmpq(raw(*this), FlintRational(value).number, bits);
}

Ball::Ball(const Ball& other) : bits_(other.bits_) {
  new (storage_) arb_struct;
  arb_init(raw(*this));
  arb_set(raw(*this), raw(other));
}

Ball::Ball(Ball&& other) noexcept : bits_(other.bits_) {
  new (storage_) arb_struct;
  arb_init(raw(*this));
  arb_swap(raw(*this), raw(other));
}

Ball& Ball::operator=(const Ball& other) {  // NOLINT(bugprone-unhandled-self-assignment): arb_set handles it
  arb_set(raw(*this), raw(other));
  bits_ = other.bits_;
  return *this;
}

Ball& Ball::operator=(Ball&& other) noexcept {
  arb_swap(raw(*this), raw(other));
  std::swap(bits_, other.bits_);
  return *this;
}

Ball::~Ball() { arb_clear(raw(*this)); }

bool Ball::is_exact() const { return arb_is_exact(raw(*this)) != 0; }
bool Ball::is_zero() const { return arb_is_zero(raw(*this)) != 0; }
bool Ball::contains_zero() const { return arb_contains_zero(raw(*this)) != 0; }
bool Ball::is_finite() const { return arb_is_finite(raw(*this)) != 0; }

std::optional<int> Ball::sign() const {
  if (is_zero()) return 0;
  if (arb_is_positive(raw(*this))) return 1;
  if (arb_is_negative(raw(*this))) return -1;
  return std::nullopt;
}

bool Ball::contains(const Rational& value) const {
  return arb_contains_fmpq(raw(*this), FlintRational(value).number) != 0;
}

bool Ball::overlaps(const Ball& other) const { return arb_overlaps(raw(*this), raw(other)) != 0; }

Ball Ball::operator-() const {
  Ball result = *this;
  arb_neg(raw(result), raw(result));
  return result;
}

Ball& Ball::operator+=(const Ball& other) {
  bits_ = std::max(bits_, other.bits_);
  arb_add(raw(*this), raw(*this), raw(other), bits_);
  return *this;
}

Ball& Ball::operator-=(const Ball& other) {
  bits_ = std::max(bits_, other.bits_);
  arb_sub(raw(*this), raw(*this), raw(other), bits_);
  return *this;
}

Ball& Ball::operator*=(const Ball& other) {
  bits_ = std::max(bits_, other.bits_);
  arb_mul(raw(*this), raw(*this), raw(other), bits_);
  return *this;
}

Ball& Ball::operator/=(const Ball& other) {
  bits_ = std::max(bits_, other.bits_);
  arb_div(raw(*this), raw(*this), raw(other), bits_);
  return *this;
}

void Ball::add_product(const Ball& a, const Ball& b) {
  bits_ = std::max({bits_, a.bits_, b.bits_});
  arb_addmul(raw(*this), raw(a), raw(b), bits_);
}

Ball sqrt(const Ball& x) { return applied(arb_sqrt, x); }
Ball exp(const Ball& x) { return applied(arb_exp, x); }
Ball log(const Ball& x) { return applied(arb_log, x); }
Ball sin(const Ball& x) { return applied(arb_sin, x); }
Ball cos(const Ball& x) { return applied(arb_cos, x); }
Ball sinh(const Ball& x) { return applied(arb_sinh, x); }
Ball cosh(const Ball& x) { return applied(arb_cosh, x); }

Ball abs(const Ball& x) {
  Ball result(0, x.bits());
  arb_abs(raw(result), raw(x));
  return result;
}

Ball pow(const Ball& x, int exponent) {
  Ball result(0, x.bits());
  if (exponent >= 0) {
    arb_pow_ui(raw(result), raw(x), static_cast<unsigned long>(exponent), x.bits());
    return result;
  }
  return Ball(1, x.bits()) / pow(x, -exponent);
}

Ball hull(const Ball& a, const Ball& b) {
  Ball result(0, std::max(a.bits(), b.bits()));
  arb_union(raw(result), raw(a), raw(b), result.bits());
  return result;
}

std::optional<std::string> Ball::significant(int digits) const {
  check_digits(digits, 1);
  if (is_zero()) return "0";
  if (!is_finite() || contains_zero()) return std::nullopt;
  mpz_class exponent = decimal_exponent(*this);
  const mpz_class limit = power_of_ten(static_cast<unsigned long>(digits));
  const int bits = std::max(bits_, 2 * digits * 4 + 64) + 64;
  // One round usually; a second when the logarithm was next to a whole number, or all nines round up.
  for (int round = 0; round < 3; ++round) {
    Ball scaled(0, bits);
    const mpz_class shift = digits - 1 - exponent;
    FlintInteger power;
    fmpz_set_mpz(power.value, shift.get_mpz_t());
    Ball ten(10, bits);
    arb_pow_fmpz(raw(scaled), raw(ten), power.value, bits);
    arb_mul(raw(scaled), raw(scaled), raw(*this), bits);
    arb_abs(raw(scaled), raw(scaled));
    // Nearest whole number: the floor of scaled + 1/2, when that is the same all over the ball.
    scaled += Ball(Rational(1, 2), bits);
    arb_floor(raw(scaled), raw(scaled), bits);
    FlintInteger nearest;
    if (!arb_get_unique_fmpz(nearest.value, raw(scaled))) {
      // An exact number half way between two decimals: a division by a power of ten cannot tell.
      constexpr long kShort = 5000;
      if (is_exact() && exponent.fits_slong_p() && std::abs(exponent.get_si()) < kShort)
        return midpoint().significant(digits);
      return std::nullopt;
    }
    mpz_class whole = nearest.gmp();
    if (whole >= limit || whole * 10 < limit) {
      exponent += whole >= limit ? 1 : -1;
      continue;
    }
    if (!exponent.fits_slong_p())
      throw Unable("a number with a decimal exponent of more than 18 digits is not shown");
    if (arb_is_negative(raw(*this))) whole = -whole;
    return significant_text(whole, exponent.get_si());
  }
  return std::nullopt;
}

std::string Ball::radius() const {
  if (is_exact()) return "0";
  if (!is_finite()) return "infinity";
  Ball r(0, 64);
  arb_get_rad_arb(raw(r), raw(*this));
  const mpz_class exponent = decimal_exponent(r) - 1;
  FlintInteger power;
  const mpz_class shift = -exponent;
  fmpz_set_mpz(power.value, shift.get_mpz_t());
  Ball scaled(10, 128);
  arb_pow_fmpz(raw(scaled), raw(scaled), power.value, 128);
  scaled *= r;
  // Upwards to a whole number of two or three digits.
  FlintInteger up;
  arf_struct* middle = arb_midref(raw(scaled));
  arb_get_ubound_arf(middle, raw(scaled), 64);
  arf_get_fmpz(up.value, middle, ARF_RND_CEIL);
  mpz_class whole = up.gmp();
  mpz_class place = exponent + 1;
  while (whole >= 100) {
    mpz_cdiv_q_ui(whole.get_mpz_t(), whole.get_mpz_t(), 10);
    ++place;
  }
  const std::string two = whole.get_str();
  if (two.size() < 2) --place;
  std::string text = two.substr(0, 1) + (two.size() > 1 && two[1] != '0' ? "." + two.substr(1) : "");
  if (place == 0) return text;
  const std::string size = mpz_class(::abs(place)).get_str();
  return text + (place < 0 ? "e-" : "e+") + (size.size() < 2 ? "0" + size : size);
}

Ball ball(const RealRoot& root, int bits) {
  if (root.is_rational()) return Ball(root.rational(), bits);
  const RealRoot narrow = root.refined(Rational(1, 2).pow(bits));
  return hull(Ball(narrow.low(), bits), Ball(narrow.high(), bits));
}

double Ball::to_double() const { return arf_get_d(arb_midref(raw(*this)), ARF_RND_NEAR); }

Rational Ball::midpoint() const {
  const arf_struct* middle = arb_midref(raw(*this));
  if (!is_finite() || arf_cmpabs_2exp_si(middle, 1 << 20) > 0 ||
      (!arf_is_zero(middle) && arf_cmpabs_2exp_si(middle, -(1 << 20)) < 0))
    throw Unable("the midpoint of a ball has an exponent beyond 2^20");
  fmpq_t exact;
  fmpq_init(exact);
  arf_get_fmpq(exact, middle);
  mpq_class result;
  fmpq_get_mpq(result.get_mpq_t(), exact);
  fmpq_clear(exact);
  return rational(std::move(result));
}

Ball pi(int bits) {
  Ball result(0, bits);
  arb_const_pi(raw(result), bits);
  return result;
}

}  // namespace shortfall
