// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/growing_fixed_point.hpp"

#include <algorithm>

namespace shortfall {

namespace {

constexpr std::size_t kSpare = 16;  // limbs of room, beside half of those in use
constexpr mp_limb_t kOnes = ~mp_limb_t{0};

/// The whole number in two's complement.
mpz_class signed_integer(const mp_limb_t* limbs, std::size_t size) {
  const bool negative = (limbs[size - 1] >> (GMP_NUMB_BITS - 1)) != 0;
  mpz_class result;
  mp_limb_t* out = mpz_limbs_write(result.get_mpz_t(), static_cast<mp_size_t>(size));
  if (negative)
    mpn_neg(out, limbs, static_cast<mp_size_t>(size));
  else
    mpn_copyi(out, limbs, static_cast<mp_size_t>(size));
  const auto length = static_cast<mp_size_t>(size);
  mpz_limbs_finish(result.get_mpz_t(), negative ? -length : length);
  return result;
}

}  // namespace

GrowingFixedPoint::GrowingFixedPoint(const mpz_class& value, std::int64_t places, std::size_t whole) {
  fraction_ = static_cast<std::size_t>((places + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS);
  const mpz_class n = value << (fraction_ * GMP_NUMB_BITS - static_cast<std::size_t>(places));
  const std::size_t limbs = mpz_size(n.get_mpz_t());
  const std::size_t used = std::max(fraction_ + whole, limbs + 1);
  limbs_.assign(kSpare + used + used / 2 + kSpare, 0);
  high_ = limbs_.size() - kSpare;
  low_ = high_ - used;
  if (n != 0) mpn_copyi(&limbs_[low_], mpz_limbs_read(n.get_mpz_t()), static_cast<mp_size_t>(limbs));
  if (n < 0) mpn_neg(&limbs_[low_], &limbs_[low_], static_cast<mp_size_t>(used));
  trim();
}

int GrowingFixedPoint::sign() const {
  if (negative()) return -1;
  return std::any_of(&limbs_[low_], &limbs_[high_ - 1] + 1, [](mp_limb_t l) { return l != 0; }) ? 1 : 0;
}

bool GrowingFixedPoint::has_guard() const {
  const mp_limb_t top = limbs_[high_ - 1];
  if (top != 0 && top != kOnes) return false;
  return size() < 2 || (limbs_[high_ - 2] >> (GMP_NUMB_BITS - 1)) == (top & 1);
}

void GrowingFixedPoint::widen() {
  const mp_limb_t fill = negative() ? kOnes : 0;
  if (high_ == limbs_.size()) limbs_.resize(limbs_.size() + kSpare);
  limbs_[high_++] = fill;
}

void GrowingFixedPoint::clear() {
  low_ = high_ - whole();
  fraction_ = 0;
  std::fill(limbs_.begin() + static_cast<std::ptrdiff_t>(low_),
            limbs_.begin() + static_cast<std::ptrdiff_t>(high_), 0);
}

void GrowingFixedPoint::prepend(std::size_t limbs) {
  if (limbs > low_) {
    const std::size_t more = limbs + size() / 2 + kSpare;
    limbs_.insert(limbs_.begin(), more, 0);
    low_ += more;
    high_ += more;
  }
  std::fill_n(limbs_.begin() + static_cast<std::ptrdiff_t>(low_ - limbs), limbs, 0);
  low_ -= limbs;
  fraction_ += limbs;
}

void GrowingFixedPoint::trim() {
  while (fraction_ > 0 && limbs_[low_] == 0) {
    ++low_;
    --fraction_;
  }
}

void GrowingFixedPoint::add_product(const GrowingFixedPoint& other, mp_limb_t word, std::size_t down,
                                    bool subtract) {
  const std::size_t needed = other.fraction_ + down;
  if (fraction_ < needed) prepend(needed - fraction_);
  const auto length = static_cast<mp_size_t>(other.size()), above = static_cast<mp_size_t>(down);
  mp_limb_t* const to = &limbs_[low_ + fraction_ - needed];
  const mp_limb_t* const from = &other.limbs_[other.low_];
  mp_limb_t carry = 0;
  if (word == 1)
    carry = subtract ? mpn_sub_n(to, to, from, length) : mpn_add_n(to, to, from, length);
  else
    carry = subtract ? mpn_submul_1(to, from, length, word) : mpn_addmul_1(to, from, length, word);
  if (above == 0) return;
  // The limbs of a negative number are those of its sum with 2^(64 length).
  mp_limb_t* const rest = to + length;
  if (subtract) {
    mpn_sub_1(rest, rest, above, carry);
    if (other.negative()) mpn_add_1(rest, rest, above, word);
  } else {
    mpn_add_1(rest, rest, above, carry);
    if (other.negative()) mpn_sub_1(rest, rest, above, word);
  }
}

mpz_class GrowingFixedPoint::numerator() const { return signed_integer(&limbs_[low_], size()); }

mpz_class GrowingFixedPoint::leading(std::size_t limbs, std::size_t& dropped) const {
  // What only repeats the sign does not count.
  std::size_t top = high_;
  const mp_limb_t fill = negative() ? kOnes : 0;
  while (top > low_ + 1 && limbs_[top - 1] == fill) --top;
  top = std::min(top + 1, high_);
  const std::size_t from = top - low_ > limbs ? top - limbs : low_;
  dropped = from - low_;
  return signed_integer(&limbs_[from], top - from);
}

}  // namespace shortfall
