// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/rational.hpp"

#include <limits>
#include <ostream>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {

struct Rational::Big {
  mpq_class value;
};

void Rational::Discard::operator()(Big* big) const noexcept { delete big; }

/// Writes the two representations; both arguments in lowest terms, denominators positive.
struct RationalAccess {
  static bool is_small(const Rational& r) { return !r.big_; }
  static std::int64_t numerator(const Rational& r) { return r.numerator_; }
  static std::int64_t denominator(const Rational& r) { return r.denominator_; }
  static mpq_class& big(Rational& r) { return r.big_->value; }
  static const mpq_class& big(const Rational& r) { return r.big_->value; }

  static void assign(Rational& r, Int128 numerator, Int128 denominator) {
    if (fits_64(numerator) && fits_64(denominator)) [[likely]] {
      r.numerator_ = static_cast<std::int64_t>(numerator);
      r.denominator_ = static_cast<std::int64_t>(denominator);
      r.big_.reset();
      return;
    }
    mpq_class value;
    value.get_num() = gmp_integer(numerator);
    value.get_den() = gmp_integer(denominator);
    keep_big(r, std::move(value));
  }

  static void keep_big(Rational& r, mpq_class&& value) {
    r.numerator_ = 0;
    r.denominator_ = 1;
    if (r.big_)
      r.big_->value.swap(value);
    else
      r.big_.reset(new Rational::Big{std::move(value)});
  }

  static bool integer_64(const mpz_class& z, std::int64_t& value) {
    const std::size_t bits = mpz_sizeinbase(z.get_mpz_t(), 2);
    if (bits > 64) return false;
    std::uint64_t word = 0;
    mpz_export(&word, nullptr, -1, sizeof word, 0, 0, z.get_mpz_t());
    const bool negative = mpz_sgn(z.get_mpz_t()) < 0;
    constexpr std::uint64_t kLargest = std::numeric_limits<std::int64_t>::max();
    if (word > kLargest + (negative ? 1 : 0)) return false;
    value = static_cast<std::int64_t>(negative ? 0 - word : word);
    return true;
  }

  static void assign(Rational& r, mpq_class&& value) {
    std::int64_t numerator, denominator;
    if (integer_64(value.get_num(), numerator) && integer_64(value.get_den(), denominator)) {
      r.numerator_ = numerator;
      r.denominator_ = denominator;
      r.big_.reset();
    } else {
      keep_big(r, std::move(value));
    }
  }

  /// a/b + c/d. |a|, |c| <= 2^63 and b, d < 2^63, so that no intermediate passes 127 bits.
  static void sum(Rational& r, Int128 a, std::int64_t b, Int128 c, std::int64_t d) {
    const auto common =
        static_cast<std::int64_t>(gcd(static_cast<std::uint64_t>(b), static_cast<std::uint64_t>(d)));
    if (common == 1) return assign(r, a * d + c * b, static_cast<Int128>(b) * d);
    // Only the common part can cancel again (Knuth, The Art of Computer Programming 2, 4.5.1).
    const std::int64_t b_rest = b / common;
    const Int128 t = a * (d / common) + c * b_rest;
    const auto remainder = fits_64(t)
                               ? static_cast<std::uint64_t>(magnitude(static_cast<std::int64_t>(t))) %
                                     static_cast<std::uint64_t>(common)
                               : static_cast<std::uint64_t>(magnitude(t) % static_cast<UInt128>(common));
    const auto cancels = static_cast<std::int64_t>(gcd(remainder, static_cast<std::uint64_t>(common)));
    if (cancels == 1) return assign(r, t, static_cast<Int128>(b_rest) * d);
    const Int128 numerator =
        fits_64(t) ? static_cast<Int128>(static_cast<std::int64_t>(t) / cancels) : t / cancels;
    assign(r, numerator, static_cast<Int128>(b_rest) * (d / cancels));
  }

  /// (a/b) (c/d) or its opposite; each at most 2^63, so that no product passes 126 bits.
  static void product(Rational& r, bool negative, std::uint64_t a, std::uint64_t b, std::uint64_t c,
                      std::uint64_t d) {
    if (a == 0 || c == 0) return assign(r, 0, 1);
    const auto reduce = [](std::uint64_t& above, std::uint64_t& below) {
      if (below == 1) return;
      const std::uint64_t common = gcd(above, below);
      if (common == 1) return;
      above /= common;
      below /= common;
    };
    reduce(a, d);
    reduce(c, b);
    const auto numerator = static_cast<Int128>(static_cast<UInt128>(a) * c);
    assign(r, negative ? -numerator : numerator, static_cast<Int128>(static_cast<UInt128>(b) * d));
  }
};

using Access = RationalAccess;

mpz_class gmp_integer(Int128 value) {
  const UInt128 size = magnitude(value);
  const std::uint64_t words[2] = {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)};
  mpz_class z;
  mpz_import(z.get_mpz_t(), 2, -1, sizeof words[0], 0, 0, words);
  if (value < 0) mpz_neg(z.get_mpz_t(), z.get_mpz_t());
  return z;
}

mpz_class gmp_numerator(const Rational& value) {
  if (Access::is_small(value)) return gmp_integer(Access::numerator(value));
  return Access::big(value).get_num();
}

mpz_class gmp_denominator(const Rational& value) {
  if (Access::is_small(value)) return gmp_integer(Access::denominator(value));
  return Access::big(value).get_den();
}

mpq_class gmp(const Rational& value) {
  if (!Access::is_small(value)) return Access::big(value);
  mpq_class result;
  result.get_num() = gmp_integer(Access::numerator(value));
  result.get_den() = gmp_integer(Access::denominator(value));
  return result;
}

Rational rational(mpq_class value) {
  Rational result;
  Access::assign(result, std::move(value));
  return result;
}

Rational rational(const mpz_class& value) { return rational(mpq_class(value)); }

Rational rational(mpz_class numerator, mpz_class denominator) {
  if (denominator == 0) throw Undefined("a rational number cannot have the denominator zero");
  mpq_class value;
  value.get_num().swap(numerator);
  value.get_den().swap(denominator);
  value.canonicalize();
  return rational(std::move(value));
}

Rational rational(Int128 numerator, Int128 denominator) {
  if (denominator == 0) throw Undefined("a rational number cannot have the denominator zero");
  const bool negative = (numerator < 0) != (denominator < 0);
  UInt128 above = magnitude(numerator);
  UInt128 below = magnitude(denominator);
  if (below != 1) {
    const UInt128 common = gcd(above, below);
    above /= common;
    below /= common;
  }
  constexpr auto kLargest = static_cast<UInt128>(std::numeric_limits<std::int64_t>::max());
  Rational result;
  if (above <= kLargest && below <= kLargest) {
    const auto size = static_cast<Int128>(above);
    Access::assign(result, negative ? -size : size, static_cast<Int128>(below));
    return result;
  }
  // Through GMP, since -2^127 has no opposite in 128 bits.
  return rational(gmp_integer(numerator), gmp_integer(denominator));
}

Rational::Rational(std::int64_t numerator, std::int64_t denominator)
    : Rational(rational(static_cast<Int128>(numerator), static_cast<Int128>(denominator))) {}

Rational& Rational::operator=(const Rational& other) {
  if (this == &other) return *this;
  numerator_ = other.numerator_;
  denominator_ = other.denominator_;
  big_ = duplicate(other.big_.get());
  return *this;
}

Rational::BigPointer Rational::clone(const Big& big) { return BigPointer(new Big(big)); }
int Rational::big_sign() const { return sgn(big_->value); }
bool Rational::big_equal(const Rational& other) const {
  return big_ && other.big_ && big_->value == other.big_->value;
}

Rational Rational::from_integer(std::int64_t value) {
  Rational result;
  result.numerator_ = value;
  return result;
}

Rational Rational::from_integer(std::uint64_t value) {
  Rational result;
  Access::assign(result, static_cast<Int128>(value), 1);
  return result;
}

Rational Rational::numerator() const {
  return big_ ? rational(big_->value.get_num()) : from_integer(numerator_);
}

Rational Rational::denominator() const {
  return big_ ? rational(big_->value.get_den()) : from_integer(denominator_);
}

bool Rational::is_integer() const { return big_ ? big_->value.get_den() == 1 : denominator_ == 1; }

bool Rational::fits_int64(std::int64_t& value) const {
  if (big_ || denominator_ != 1) return false;
  value = numerator_;
  return true;
}

Rational Rational::operator-() const {
  Rational result;
  if (big_)
    Access::assign(result, mpq_class(-big_->value));
  else
    Access::assign(result, -static_cast<Int128>(numerator_), denominator_);
  return result;
}

Rational& Rational::operator+=(const Rational& other) {
  if (!big_ && !other.big_) [[likely]] {
    std::int64_t total;
    if (denominator_ == 1 && other.denominator_ == 1 &&
        !__builtin_add_overflow(numerator_, other.numerator_, &total)) {
      numerator_ = total;
      return *this;
    }
    Access::sum(*this, numerator_, denominator_, other.numerator_, other.denominator_);
    return *this;
  }
  Access::assign(*this, mpq_class(gmp(*this) + gmp(other)));
  return *this;
}

Rational& Rational::operator-=(const Rational& other) {
  if (!big_ && !other.big_) [[likely]] {
    Access::sum(*this, numerator_, denominator_, -static_cast<Int128>(other.numerator_), other.denominator_);
    return *this;
  }
  Access::assign(*this, mpq_class(gmp(*this) - gmp(other)));
  return *this;
}

Rational& Rational::operator*=(const Rational& other) {
  if (!big_ && !other.big_) [[likely]] {
    std::int64_t total;
    if (denominator_ == 1 && other.denominator_ == 1 &&
        !__builtin_mul_overflow(numerator_, other.numerator_, &total)) {
      numerator_ = total;
      return *this;
    }
    Access::product(*this, (numerator_ < 0) != (other.numerator_ < 0), magnitude(numerator_),
                    magnitude(denominator_), magnitude(other.numerator_), magnitude(other.denominator_));
    return *this;
  }
  Access::assign(*this, mpq_class(gmp(*this) * gmp(other)));
  return *this;
}

Rational& Rational::operator/=(const Rational& other) {
  if (other.is_zero()) throw Undefined("division of " + (big_ ? "a number" : str()) + " by zero");
  if (!big_ && !other.big_) [[likely]] {
    Access::product(*this, (numerator_ < 0) != (other.numerator_ < 0), magnitude(numerator_),
                    magnitude(denominator_), magnitude(other.denominator_), magnitude(other.numerator_));
    return *this;
  }
  Access::assign(*this, mpq_class(gmp(*this) / gmp(other)));
  return *this;
}

std::strong_ordering Rational::operator<=>(const Rational& other) const {
  if (!big_ && !other.big_) {
    if (denominator_ == other.denominator_) return numerator_ <=> other.numerator_;
    const Int128 left = static_cast<Int128>(numerator_) * other.denominator_;
    const Int128 right = static_cast<Int128>(other.numerator_) * denominator_;
    return left < right   ? std::strong_ordering::less
           : left > right ? std::strong_ordering::greater
                          : std::strong_ordering::equal;
  }
  if (sign() != other.sign()) return sign() <=> other.sign();
  return cmp(gmp(*this), gmp(other)) <=> 0;
}

Rational Rational::floor() const {
  if (is_integer()) return *this;
  if (!big_) return from_integer(numerator_ / denominator_ - (numerator_ < 0 ? 1 : 0));
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), big_->value.get_num_mpz_t(), big_->value.get_den_mpz_t());
  return rational(result);
}

Rational Rational::pow(int exponent) const {
  if (exponent < 0 && is_zero()) throw Undefined("zero has no negative power");
  if (exponent == 0 || is_one()) return 1;
  if (exponent == 1 || is_zero()) return *this;
  mpz_class above = gmp_numerator(*this);
  mpz_class below = gmp_denominator(*this);
  const auto power = static_cast<unsigned long>(exponent < 0 ? -static_cast<long>(exponent) : exponent);
  const std::size_t bits =
      std::max(mpz_sizeinbase(above.get_mpz_t(), 2), mpz_sizeinbase(below.get_mpz_t(), 2));
  constexpr std::size_t kMostBits = std::size_t{1} << 30;
  if (bits > 1 && bits - 1 > kMostBits / power)
    throw Unable("the power " + std::to_string(exponent) + " of a number of " + std::to_string(bits) +
                 " bits would have more than 2^30 bits, which is our limit");
  mpz_pow_ui(above.get_mpz_t(), above.get_mpz_t(), power);
  mpz_pow_ui(below.get_mpz_t(), below.get_mpz_t(), power);
  if (exponent < 0) above.swap(below);
  // Powers of coprime numbers stay coprime; only the sign may stand in the wrong place.
  if (below < 0) {
    above = -above;
    below = -below;
  }
  mpq_class value;
  value.get_num().swap(above);
  value.get_den().swap(below);
  return rational(std::move(value));
}

std::size_t Rational::hash() const {
  const auto mix = [](std::uint64_t h, std::uint64_t word) {
    h = (h ^ word) * 0x9E3779B97F4A7C15ull;
    return h ^ (h >> 29);
  };
  std::uint64_t h =
      mix(mix(0, static_cast<std::uint64_t>(numerator_)), static_cast<std::uint64_t>(denominator_));
  if (!big_) return h;
  for (const mpz_class* z : {&big_->value.get_num(), &big_->value.get_den()})
    for (std::size_t i = 0; i < mpz_size(z->get_mpz_t()); ++i) h = mix(h, mpz_getlimbn(z->get_mpz_t(), i));
  return mix(h, static_cast<std::uint64_t>(sign()));
}

std::ostream& operator<<(std::ostream& out, const Rational& value) { return out << value.str(); }

Rational binomial(int n, int k) {
  if (k < 0 || k > n) return 0;
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return rational(result);
}

Rational factorial(int n) {
  if (n < 0) throw Undefined("the factorial of " + std::to_string(n) + " is not defined");
  mpz_class result;
  mpz_fac_ui(result.get_mpz_t(), static_cast<unsigned long>(n));
  return rational(result);
}

}  // namespace shortfall
