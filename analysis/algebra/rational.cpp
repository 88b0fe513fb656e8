// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/rational.hpp"

#include <array>
#include <limits>
#include <numeric>
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
  static const mpq_class& big(const Rational& r) { return r.big_->value; }

  /// The GMP number to write a result into; what it holds may be one of the operands.
  static mpq_ptr room(Rational& r, Rational::BigPointer& fresh) {
    if (r.big_) return r.big_->value.get_mpq_t();
    fresh.reset(new Rational::Big);
    return fresh->value.get_mpq_t();
  }

  /// Takes what has been written into its room.
  static void settle(Rational& r, Rational::BigPointer fresh) {
    const mpq_class& value = (r.big_ ? r.big_ : fresh)->value;
    std::int64_t numerator, denominator;
    if (integer_64(value.get_num_mpz_t(), numerator) && integer_64(value.get_den_mpz_t(), denominator)) {
      r.numerator_ = numerator;
      r.denominator_ = denominator;
      r.big_.reset();
      return;
    }
    r.numerator_ = 0;
    r.denominator_ = 1;
    if (fresh) r.big_ = std::move(fresh);
  }

  static void assign(Rational& r, Int128 numerator, Int128 denominator) {
    if (fits_64(numerator) && fits_64(denominator)) [[likely]] {
      r.numerator_ = static_cast<std::int64_t>(numerator);
      r.denominator_ = static_cast<std::int64_t>(denominator);
      r.big_.reset();
      return;
    }
    Rational::BigPointer fresh;
    const mpq_ptr value = room(r, fresh);
    set(mpq_numref(value), numerator);
    set(mpq_denref(value), denominator);
    settle(r, std::move(fresh));
  }

  static void assign(Rational& r, mpq_class&& value) {
    Rational::BigPointer fresh;
    mpq_swap(room(r, fresh), value.get_mpq_t());
    settle(r, std::move(fresh));
  }

  /// r = operation(r, other), by GMP.
  static void apply(void (*operation)(mpq_ptr, mpq_srcptr, mpq_srcptr), Rational& r, const Rational& other) {
    Rational::BigPointer fresh;
    {
      const GmpView left(r), right(other);
      operation(room(r, fresh), left.get(), right.get());
    }
    settle(r, std::move(fresh));
  }

  static void set(mpz_ptr z, Int128 value) {
    const UInt128 size = magnitude(value);
    const std::array<mp_limb_t, 2> words{static_cast<mp_limb_t>(size), static_cast<mp_limb_t>(size >> 64)};
    mpz_t lent;
    mpz_set(z, mpz_roinit_n(lent, words.data(), value < 0 ? -2 : 2));
  }

  static bool integer_64(mpz_srcptr z, std::int64_t& value) {
    if (mpz_size(z) > 1) return false;
    const mp_limb_t word = mpz_getlimbn(z, 0);
    const bool negative = mpz_sgn(z) < 0;
    constexpr std::uint64_t kLargest = std::numeric_limits<std::int64_t>::max();
    if (word > kLargest + (negative ? 1 : 0)) return false;
    value = static_cast<std::int64_t>(negative ? 0 - word : word);
    return true;
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

GmpView::GmpView(const Rational& r) {
  if (!Access::is_small(r)) {
    read_ = Access::big(r).get_mpq_t();
    return;
  }
  const std::int64_t above = Access::numerator(r);
  words_[0] = magnitude(above);
  words_[1] = magnitude(Access::denominator(r));
  mpz_roinit_n(mpq_numref(lent_), &words_[0], above < 0 ? -1 : 1);
  mpz_roinit_n(mpq_denref(lent_), &words_[1], 1);
  read_ = lent_;
}

mpz_class gmp_integer(Int128 value) {
  mpz_class z;
  Access::set(z.get_mpz_t(), value);
  return z;
}

static_assert(GMP_NUMB_BITS == 64, "a 64-bit word is one limb of GMP");

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
  Access::apply(mpq_add, *this, other);
  return *this;
}

Rational& Rational::operator-=(const Rational& other) {
  if (!big_ && !other.big_) [[likely]] {
    Access::sum(*this, numerator_, denominator_, -static_cast<Int128>(other.numerator_), other.denominator_);
    return *this;
  }
  Access::apply(mpq_sub, *this, other);
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
  Access::apply(mpq_mul, *this, other);
  return *this;
}

Rational Rational::times(unsigned above, unsigned below) const {
  const unsigned common = std::gcd(above, below);
  above /= common;
  below /= common;
  Rational result;
  if (!big_) [[likely]] {
    const std::uint64_t size = magnitude(numerator_);
    const auto bottom = static_cast<std::uint64_t>(denominator_);
    const unsigned up = below == 1 ? 1 : std::gcd(static_cast<unsigned>(size % below), below);
    const unsigned down = above == 1 ? 1 : std::gcd(static_cast<unsigned>(bottom % above), above);
    const auto numerator = static_cast<Int128>(static_cast<UInt128>(size / up) * (above / down));
    Access::assign(result, numerator_ < 0 ? -numerator : numerator,
                   static_cast<Int128>(static_cast<UInt128>(bottom / down) * (below / up)));
    return result;
  }
  mpq_class value = big_->value;
  const mpz_ptr numerator = value.get_num_mpz_t(), denominator = value.get_den_mpz_t();
  if (const auto up = static_cast<unsigned>(mpz_gcd_ui(nullptr, numerator, below)); up > 1) {
    mpz_divexact_ui(numerator, numerator, up);
    below /= up;
  }
  if (const auto down = static_cast<unsigned>(mpz_gcd_ui(nullptr, denominator, above)); down > 1) {
    mpz_divexact_ui(denominator, denominator, down);
    above /= down;
  }
  mpz_mul_ui(numerator, numerator, above);
  mpz_mul_ui(denominator, denominator, below);
  Access::assign(result, std::move(value));
  return result;
}

Rational& Rational::operator/=(const Rational& other) {
  if (other.is_zero()) throw Undefined("division of " + (big_ ? "a number" : str()) + " by zero");
  if (!big_ && !other.big_) [[likely]] {
    Access::product(*this, (numerator_ < 0) != (other.numerator_ < 0), magnitude(numerator_),
                    magnitude(denominator_), magnitude(other.denominator_), magnitude(other.numerator_));
    return *this;
  }
  Access::apply(mpq_div, *this, other);
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
  return mpq_cmp(GmpView(*this).get(), GmpView(other).get()) <=> 0;
}

Rational Rational::floor() const {
  if (is_integer()) return *this;
  if (!big_) return from_integer(numerator_ / denominator_ - (numerator_ < 0 ? 1 : 0));
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), big_->value.get_num_mpz_t(), big_->value.get_den_mpz_t());
  return rational(result);
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
    for (mp_size_t i = 0; i < static_cast<mp_size_t>(mpz_size(z->get_mpz_t())); ++i)
      h = mix(h, mpz_getlimbn(z->get_mpz_t(), i));
  return mix(h, static_cast<std::uint64_t>(sign()));
}

std::ostream& operator<<(std::ostream& out, const Rational& value) { return out << value.str(); }

}  // namespace shortfall
