// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_pair.hpp"

#include <algorithm>

#include "analysis/algebra/wide.hpp"

namespace shortfall {

namespace {

static_assert(GMP_NUMB_BITS == 64);

constexpr int kMostBits = 61;

/// Which of the two terms of a row is subtracted. Rows are turned so that their values are not negative, as
/// far as the leading limbs tell: so never both.
enum Subtracted { none, first, second };

/// The next limb of (+-) a (+-) b; the carry is a signed word. Modulo 2^128, which the bounds make exact, and
/// in halves: pairs of registers for the carry would be spilled.
template <Subtracted kWhich>
std::uint64_t limb(std::int64_t& carry, UInt128 a, UInt128 b) {
  const UInt128 sum = kWhich == first ? b - a : kWhich == second ? a - b : a + b;
  const auto low = static_cast<std::uint64_t>(sum);
  const std::uint64_t result = low + static_cast<std::uint64_t>(carry);
  carry = static_cast<std::int64_t>(static_cast<std::uint64_t>(sum >> 64)) + (carry >> 63) + (result < low);
  return result;
}

UInt128 times(std::uint64_t a, std::uint64_t b) { return static_cast<UInt128>(a) * b; }

struct Carries {
  std::int64_t x, y;
};

// A loop of its own, not inlined, keeps its carries in registers.
template <Subtracted kX, Subtracted kY>
[[gnu::noinline]] Carries pass(mp_limb_t* x, mp_limb_t* y, std::size_t limbs,
                               const std::array<std::uint64_t, 4>& m) {
  const std::uint64_t a = m[0], b = m[1], c = m[2], d = m[3];
  std::int64_t carry_x = 0, carry_y = 0;
  for (std::size_t i = 0; i < limbs; ++i) {
    const std::uint64_t u = x[i], v = y[i];
    x[i] = limb<kX>(carry_x, times(a, u), times(b, v));
    y[i] = limb<kY>(carry_y, times(c, u), times(d, v));
  }
  return {carry_x, carry_y};
}

/// Calls f<in_x, in_y>() for values known at run time.
template <class F>
Carries with_signs(Subtracted in_x, Subtracted in_y, F&& f) {
  const auto second_of = [&]<Subtracted kX>() {
    if (in_y == none) return f.template operator()<kX, none>();
    return in_y == first ? f.template operator()<kX, first>() : f.template operator()<kX, second>();
  };
  if (in_x == none) return second_of.template operator()<none>();
  return in_x == first ? second_of.template operator()<first>() : second_of.template operator()<second>();
}

/// A row's signs, and whether its value is the negative of what they make.
struct Turned {
  Subtracted subtracted = none;
  bool negative = false;
};
Turned turned(bool first_negative, double a, bool second_negative, double b) {
  if (first_negative == second_negative) return {none, first_negative};
  // a - b, or b - a.
  const bool flip = first_negative ? b < a : a < b;
  return {first_negative != flip ? first : second, flip};
}

/// Limbs 0..limbs, the last of them the carry; negated where the leading limbs did not tell.
void finish(mpz_ptr z, mp_limb_t* limb, std::size_t limbs, std::int64_t carry, bool negative) {
  limb[limbs] = static_cast<mp_limb_t>(carry);
  if (carry < 0) {
    mpn_neg(limb, limb, static_cast<mp_size_t>(limbs + 1));
    negative = !negative;
  }
  const auto size = static_cast<mp_size_t>(limbs + 1);
  mpz_limbs_finish(z, negative ? -size : size);
}

}  // namespace

bool ExactPair::fits(const std::vector<std::vector<mpz_class>>& matrix) {
  return matrix.size() == 2 && std::ranges::all_of(matrix, [](const auto& row) {
           return std::ranges::all_of(
               row, [](const mpz_class& m) { return mpz_sizeinbase(m.get_mpz_t(), 2) <= kMostBits; });
         });
}

ExactPair::ExactPair(const std::vector<std::vector<mpz_class>>& matrix) {
  for (int i = 0; i < 4; ++i) entries_[i] = matrix[i / 2][i % 2].get_si();
}

void ExactPair::apply(std::vector<mpz_class>& z) const {
  const mpz_ptr p = z[0].get_mpz_t(), q = z[1].get_mpz_t();
  const std::size_t of_p = mpz_size(p), of_q = mpz_size(q), limbs = std::max(of_p, of_q);
  if (limbs == 0) return;
  const bool p_negative = mpz_sgn(p) < 0, q_negative = mpz_sgn(q) < 0;
  mp_limb_t* const x = mpz_limbs_modify(p, static_cast<mp_size_t>(limbs + 1));
  mp_limb_t* const y = mpz_limbs_modify(q, static_cast<mp_size_t>(limbs + 1));
  std::fill(x + of_p, x + limbs, 0);
  std::fill(y + of_q, y + limbs, 0);

  const auto leading = [limbs](const mp_limb_t* limb) {
    return static_cast<double>(limb[limbs - 1]) * 0x1p64 +
           (limbs > 1 ? static_cast<double>(limb[limbs - 2]) : 0.0);
  };
  const double u = leading(x), v = leading(y);
  const auto size = [](std::int64_t m) { return static_cast<double>(magnitude(m)); };
  const auto signs = [&](int i) {
    return turned((entries_[i] < 0) != p_negative, size(entries_[i]) * u, (entries_[i + 1] < 0) != q_negative,
                  size(entries_[i + 1]) * v);
  };
  const Turned in_x = signs(0), in_y = signs(2);
  const Carries carries = with_signs(in_x.subtracted, in_y.subtracted, [&]<Subtracted kX, Subtracted kY>() {
    return pass<kX, kY>(
        x, y, limbs,
        {magnitude(entries_[0]), magnitude(entries_[1]), magnitude(entries_[2]), magnitude(entries_[3])});
  });
  finish(p, x, limbs, carries.x, in_x.negative);
  finish(q, y, limbs, carries.y, in_y.negative);
}

}  // namespace shortfall
