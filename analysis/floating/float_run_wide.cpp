// SPDX-License-Identifier: GPL-3.0-or-later
#include <quadmath.h>

#include <cmath>
#include <limits>

#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/real.hpp"
#include "analysis/floating/double_double.hpp"
#include "analysis/floating/float_access.hpp"
#include "analysis/floating/float_variants.hpp"
#include "analysis/floating/quad.hpp"
#include "analysis/floating/real_in_place.hpp"
#include "analysis/floating/real_variants.hpp"

namespace shortfall {

namespace {

FloatAccess<Quad> quad_access(const FloatFormat& format) {
  FloatAccess<Quad> a;
  a.rounded = [storage = format.storage()](const Rational& value) {
    const std::function<Quad::Native(Quad::Native, long)> scaled = [](Quad::Native v, long e) {
      return ldexpq(v, static_cast<int>(e));
    };
    const Quad::Native infinity = static_cast<Quad::Native>(std::numeric_limits<double>::infinity());
    return Quad(stored_as<Quad::Native>(value, storage, Rounding::nearest_even, infinity, scaled));
  };
  a.exact = [](const Quad& q) -> FloatNumber {
    Quad::Native part = q.value();
    if (isnanq(part)) return {FloatNumber::Kind::not_a_number, {}};
    if (isinfq(part)) return {FloatNumber::Kind::infinite, part < 0 ? -1 : 1};
    if (part == 0) return {};
    int exponent = 0;
    part = frexpq(part, &exponent);
    Rational sum;
    for (int shift = 1; part != 0; ++shift) {
      part = ldexpq(part, 32);
      const Quad::Native whole = truncq(part);
      sum += scaled_by_two(Rational(static_cast<std::int64_t>(whole)), -32L * shift);
      part -= whole;
    }
    return {FloatNumber::Kind::finite, scaled_by_two(sum, exponent)};
  };
  a.rough = [](const Quad& q) { return static_cast<double>(q.value()); };
  return a;
}

FloatAccess<DoubleDouble> double_double_access() {
  FloatAccess<DoubleDouble> a;
  a.rounded = double_double;
  a.exact = [](const DoubleDouble& d) -> FloatNumber {
    if (std::isnan(d.high())) return {FloatNumber::Kind::not_a_number, {}};
    if (std::isinf(d.high())) return {FloatNumber::Kind::infinite, d.high() < 0 ? -1 : 1};
    return {FloatNumber::Kind::finite, Rational::from_double(d.high()) + Rational::from_double(d.low())};
  };
  a.rough = [](const DoubleDouble& d) { return d.high(); };
  return a;
}

FloatNumber exactly(mpfr_srcptr raw) {
  if (mpfr_nan_p(raw)) return {FloatNumber::Kind::not_a_number, {}};
  if (mpfr_inf_p(raw)) return {FloatNumber::Kind::infinite, mpfr_sgn(raw)};
  if (mpfr_zero_p(raw)) return {};
  mpz_class whole;
  const mpfr_exp_t exponent = mpfr_get_z_2exp(whole.get_mpz_t(), raw);
  return {FloatNumber::Kind::finite, scaled_by_two(rational(whole), exponent)};
}

FloatAccess<Real> real_access(const FloatFormat& format) {
  FloatAccess<Real> a;
  const BinaryFormat storage = format.storage();
  a.rounded = [digits = format.digits, storage, rounding = format.rounding()](const Rational& value) {
    // A number of the format is exactly a Real of its digits.
    return real(*rounded(value, storage, rounding), digits);
  };
  a.exact = [](const Real& r) { return exactly(r.backend().data()); };
  a.rough = [](const Real& r) { return r.convert_to<double>(); };
  a.within = [digits = format.digits](const std::function<void()>& work) {
    const Precision precision(digits);
    work();
  };
  return a;
}

FloatAccess<RealInPlace> in_place_access(const FloatFormat& format) {
  FloatAccess<RealInPlace> a;
  a.rounded = [access = real_access(format)](const Rational& value) {
    return RealInPlace(access.rounded(value).backend().data());
  };
  a.exact = [](const RealInPlace& r) { return exactly(r.get()); };
  a.rough = [](const RealInPlace& r) { return mpfr_get_d(r.get(), MPFR_RNDN); };
  return a;
}

template <class T>
std::unique_ptr<FloatRun> made(const FloatQuestion& q, const FloatFormat& format,
                               const FloatAccess<T>& access) {
  if (format.variant == FloatFormat::Variant::compensated)
    return std::make_unique<TypedFloatRun<Compensated<T>>>(q, wrapped<Compensated<T>>(access));
  return std::make_unique<TypedFloatRun<T>>(q, access);
}

}  // namespace

std::unique_ptr<FloatRun> wide_float_run(const FloatFormat& format, const FloatQuestion& question) {
  const bool fused = format.variant == FloatFormat::Variant::fused;
  switch (format.kind) {
    case FloatFormat::Kind::binary128: {
      const FloatAccess<Quad> access = quad_access(format);
      if (fused) return std::make_unique<TypedFloatRun<Fused<Quad>>>(question, wrapped<Fused<Quad>>(access));
      return made(question, format, access);
    }
    case FloatFormat::Kind::double_double:
      return made(question, format, double_double_access());
    default:
      break;
  }
  const FloatAccess<Real> access = real_access(format);
  if (fused)
    return std::make_unique<TypedFloatRun<Fused<FusedReal>>>(
        question, wrapped<Fused<FusedReal>>(wrapped<FusedReal>(access)));
  if (format.variant == FloatFormat::Variant::toward_zero)
    return std::make_unique<TypedFloatRun<RealTowardZero>>(question, wrapped<RealTowardZero>(access));
  if (format.variant == FloatFormat::Variant::plain)
    return std::make_unique<TypedFloatRun<RealInPlace>>(question, in_place_access(format));
  return made(question, format, access);
}

}  // namespace shortfall
