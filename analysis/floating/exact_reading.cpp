// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/floating/exact_parts.hpp"

namespace shortfall {

namespace {

/// An integer by its leading digits.
Ball leading(const mpz_class& value, int bits) {
  const auto length = static_cast<std::int64_t>(mpz_sizeinbase(value.get_mpz_t(), 2));
  const std::int64_t drop = length - bits - 8;
  if (drop <= 0) return {rational(value), bits + 8};
  mpz_class top;
  mpz_tdiv_q_2exp(top.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(drop));
  const Ball head(rational(top), bits + 16);
  const Ball next(rational(mpz_class(top + (value < 0 ? -1 : 1))), bits + 16);
  return hull(head, next) * pow(Ball(2, bits + 16), static_cast<int>(drop));
}

Modular modular(const mpz_class& value) {
  const mpz_class rest = value % mpz_class(Modular::kPrime);
  return Modular(static_cast<std::int64_t>(rest.get_si()));
}

}  // namespace

int ExactReading::sign() const {
  ExactTrajectory::Parts& p = *trajectory_->parts_;
  if (const int unit = p.report(velocity_).unit; unit >= 0) return p.state.sign(unit);
  mpz_class room;
  return sgn(p.numerator(velocity_, room));
}

std::size_t ExactReading::bits() const {
  mpz_class room;
  return mpz_sizeinbase(trajectory_->parts_->numerator(velocity_, room).get_mpz_t(), 2);
}

Rational ExactReading::rational() const {
  mpz_class room;
  const mpz_class& numerator = trajectory_->parts_->numerator(velocity_, room);
  return shortfall::rational(numerator, trajectory_->parts_->denominator(velocity_));
}

Ball ExactReading::ball(int bits) const {
  ExactTrajectory::Parts& p = *trajectory_->parts_;
  if (sign() == 0) return {0, bits};
  if (const int unit = p.report(velocity_).unit; unit >= 0)
    if (std::optional<Ball> value = p.state.scaled(unit, bits + 16)) {
      *value /= leading(p.report(velocity_).denominator, bits + 16);
      return *value /= leading(p.step.start_denominator, bits + 16);
    }
  mpz_class room;
  // A power multiplies the relative error of its base by n, which has fewer than 64 bits.
  const int more = bits + 80;
  Ball value = leading(p.numerator(velocity_, room), more);
  value /= leading(p.report(velocity_).denominator, more);
  value /= leading(p.step.start_denominator, more);
  if (p.step.base != 1) value /= powered(leading(p.step.base, more), p.state.frame());
  return value;
}

std::string ExactReading::significant(int digits) const {
  for (int most = 4 * digits + 64;; most *= 2) {
    if (const auto text = ball(most).significant(digits)) return *text;
    // A tie, or nearly: no number of leading digits need decide it.
    if (most > 1 << 16 || static_cast<std::size_t>(most) > bits() + 64) return rational().significant(digits);
  }
}

std::string ExactReading::decimal(int places) const {
  ExactTrajectory::Parts& p = *trajectory_->parts_;
  mpz_class room, scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(std::max(places, 0)));
  const mpz_class denominator = p.denominator(velocity_);
  const mpz_class& numerator = p.numerator(velocity_, room);
  // |N| scale / denominator + 1/2, rounded down.
  mpz_class units = 2 * abs(numerator) * scale + denominator;
  units /= 2 * denominator;
  if (numerator < 0) units = -units;
  return shortfall::rational(units, scale).decimal(places);
}

bool ExactReading::equals(const Rational& value) const {
  ExactTrajectory::Parts& p = *trajectory_->parts_;
  mpz_class room;
  // Most numbers differ in their leading digits.
  if (!(ball(128) - Ball(value, 256)).contains_zero()) return false;
  return p.numerator(velocity_, room) * gmp_denominator(value) ==
         p.denominator(velocity_) * gmp_numerator(value);
}

Ball ExactReading::minus(const Rational& value, int bits) const {
  for (int more = bits + 128;; more *= 2) {
    Ball difference = ball(more) - Ball(value, more + 64);
    if (!difference.contains_zero() && difference.significant((bits * 3 + 9) / 10 + 1)) return difference;
    if (more == bits + 128 && equals(value)) return {0, bits};
  }
}

Modular ExactReading::fingerprint() const {
  ExactTrajectory::Parts& p = *trajectory_->parts_;
  mpz_class room;
  const Modular below = modular(p.report(velocity_).denominator) * modular(p.step.start_denominator) *
                        modular(p.step.base).pow(p.state.frame());
  return modular(p.numerator(velocity_, room)) / below;
}

}  // namespace shortfall
