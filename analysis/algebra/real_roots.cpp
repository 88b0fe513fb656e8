// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/real_roots.hpp"

#include <algorithm>

#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/root_count.hpp"

namespace shortfall {

namespace {

constexpr Letter kUnknown = 0;

/// Every root lies strictly between minus this and this: a power of two.
Rational root_bound(const Univariate<Rational>& p) {
  Rational largest;
  for (int k = 0; k < p.degree(); ++k) largest = std::max(largest, (p[k] / p.leading()).abs());
  Rational bound = 2;
  while (bound <= largest + 1) bound *= 2;
  return bound;
}

/// The real roots in (low, high] of an irreducible polynomial of degree 2 or more: no rational number is a
/// root.
void isolate(const Univariate<Rational>& p, const RootCount& roots, const Rational& low, const Rational& high,
             std::vector<RealRoot>& found) {
  const int count = roots.roots_between(low, high);
  if (count == 0) return;
  if (count == 1) {
    found.emplace_back(p, low, high);
    return;
  }
  const Rational middle = (low + high) / 2;
  isolate(p, roots, low, middle, found);
  isolate(p, roots, middle, high, found);
}

std::vector<Univariate<Rational>> irreducible_factors(const Univariate<Rational>& p) {
  std::vector<Univariate<Rational>> factors;
  if (p.degree() == 1) return {p};
  for (const auto& [factor, multiplicity] : factor(Polynomial::in(kUnknown, p.coefficients())).factors)
    factors.push_back(univariate(factor, kUnknown));
  return factors;
}

/// The largest multiple of a unit whose square is not greater than r, for r >= 0.
Rational root_below(const Rational& r, const Rational& unit) {
  mpz_class root = gmp_numerator((r / (unit * unit)).floor());
  mpz_sqrt(root.get_mpz_t(), root.get_mpz_t());
  return rational(root) * unit;
}

/// Halves the intervals of neighbours until they are apart.
void separate(std::vector<RealRoot>& roots) {
  std::ranges::sort(roots, [](const RealRoot& a, const RealRoot& b) { return a.compare(b) < 0; });
  for (std::size_t i = 0; i + 1 < roots.size(); ++i)
    while (!(roots[i].high() < roots[i + 1].low())) {
      roots[i] = roots[i].refined((roots[i].high() - roots[i].low()) / 2);
      roots[i + 1] = roots[i + 1].refined((roots[i + 1].high() - roots[i + 1].low()) / 2);
    }
}

std::vector<RealRoot> roots_from(const std::vector<Univariate<Rational>>& polynomials, bool positive_only) {
  std::vector<Univariate<Rational>> factors;
  for (const Univariate<Rational>& p : polynomials)
    for (Univariate<Rational>& f : irreducible_factors(p)) {
      f = primitive(f);
      if (std::ranges::find(factors, f) == factors.end()) factors.push_back(std::move(f));
    }
  std::vector<RealRoot> roots;
  for (const Univariate<Rational>& f : factors) {
    if (f.degree() == 1) {
      const Rational value = -f[0] / f[1];
      if (!positive_only || value.sign() > 0) roots.emplace_back(value);
      continue;
    }
    const Rational bound = root_bound(f);
    isolate(f, RootCount(f), positive_only ? Rational(0) : -bound, bound, roots);
  }
  separate(roots);
  if (positive_only)
    for (RealRoot& r : roots)
      while (r.low().sign() <= 0) r = r.refined((r.high() - r.low()) / 2);
  return roots;
}

}  // namespace

RealRoot::RealRoot(Rational value)
    : polynomial_(primitive(Univariate<Rational>({-value, 1}))), low_(value), high_(std::move(value)) {}

RealRoot::RealRoot(const Univariate<Rational>& irreducible, Rational low, Rational high)
    : polynomial_(primitive(irreducible)), low_(std::move(low)), high_(std::move(high)) {
  if (polynomial_.degree() == 1)
    low_ = high_ = rational();
  else if (const ExactSign sign(polynomial_); sign(low_) * sign(high_) >= 0)
    throw Error("the interval from " + low_.str() + " to " + high_.str() + " does not isolate a root");
}

Rational RealRoot::rational() const { return -polynomial_[0] / polynomial_[1]; }

std::optional<Rational> RealRoot::rational_square() const {
  if (is_rational()) return low_ * low_;
  if (degree() == 2 && polynomial_[1].is_zero()) return -polynomial_[0] / polynomial_[2];
  return std::nullopt;
}

void RealRoot::halve() {
  if (is_rational()) return;
  const ExactSign sign(polynomial_);
  Rational middle = (low_ + high_) / 2;
  if (sign(middle) == sign(low_))
    low_ = std::move(middle);
  else
    high_ = std::move(middle);
}

RealRoot RealRoot::refined(const Rational& width) const {
  RealRoot result = *this;
  if (result.high_ - result.low_ <= width) return result;
  const ExactSign sign(polynomial_);
  const int below = sign(low_);
  const auto keep = [&](Rational x) {  // whether it is below the root
    const bool is_below = sign(x) == below;
    (is_below ? result.low_ : result.high_) = std::move(x);
    return is_below;
  };
  constexpr int kByHalves = 64;
  for (int i = 0; i < kByHalves && result.high_ - result.low_ > width; ++i)
    keep((result.low_ + result.high_) / 2);
  // Then the secant says in which of 2^bits parts the root lies; where it is right the parts become as many
  // again, squared (Abbott (2006), Quadratic interval refinement for real roots).
  for (long bits = 8; result.high_ - result.low_ > width;) {
    const Rational size = result.high_ - result.low_;
    bits = std::min(bits, static_cast<long>((size / width).floor().digits() * 10 / 3) + 2);
    const Rational low = polynomial_.at(result.low_), parts = Rational(2).pow(static_cast<int>(bits)),
                   part = size / parts;
    const Rational share = (low / (low - polynomial_.at(result.high_)) * parts + Rational(1, 2)).floor();
    const Rational guess = result.low_ + share * part;
    const bool is_below = guess <= result.low_ || (guess < result.high_ && keep(guess));
    const Rational other = is_below ? guess + part : guess - part;
    const bool inside = result.low_ < other && other < result.high_;
    const bool found = !inside || keep(other) != is_below;
    bits = found ? 2 * bits : std::max(1L, bits / 2);
    if (!found) keep((result.low_ + result.high_) / 2);
  }
  return result;
}

int RealRoot::compare(const Rational& other) const {
  if (is_rational()) return (low_ > other) - (low_ < other);
  if (other <= low_) return 1;
  if (other >= high_) return -1;
  // No rational number is a root: on which side of it the sign changes.
  const ExactSign sign(polynomial_);
  return sign(other) == sign(low_) ? 1 : -1;
}

int RealRoot::compare(const RealRoot& other) const {
  if (other.is_rational()) return compare(other.low_);
  if (is_rational()) return -other.compare(low_);
  if (polynomial_ == other.polynomial_) {
    // Both intervals isolate: the roots are one if the polynomial changes sign where the intervals overlap.
    const Rational low = std::max(low_, other.low_), high = std::min(high_, other.high_);
    if (const ExactSign sign(polynomial_); low < high && sign(low) * sign(high) < 0) return 0;
  }
  RealRoot a = *this, b = other;
  while (!(a.high_ <= b.low_) && !(b.high_ <= a.low_)) {
    a.halve();
    b.halve();
  }
  return a.high_ <= b.low_ ? -1 : 1;
}

double RealRoot::to_double() const {
  if (is_rational()) return low_.to_double();
  for (RealRoot narrow = *this;; narrow.halve())
    if (narrow.low_.to_double() == narrow.high_.to_double()) return narrow.low_.to_double();
}

std::string RealRoot::decimal(int places) const {
  if (is_rational()) return low_.decimal(places);
  for (RealRoot narrow = refined(Rational(10).pow(-places) / 2);; narrow.halve())
    if (std::string text = narrow.low_.decimal(places); text == narrow.high_.decimal(places)) return text;
}

std::string RealRoot::significant(int digits) const {
  if (is_rational()) return low_.significant(digits);
  for (RealRoot narrow = *this;; narrow.halve())
    if (std::string text = narrow.low_.significant(digits); text == narrow.high_.significant(digits))
      return text;
}

int RealRoot::places(int significant_digits) const {
  const std::string whole = RealRoot(*this).decimal(0);
  const int before = static_cast<int>(whole.size()) - (whole.front() == '-');
  if (whole != "0" && whole != "-0" && compare(1) != -1) return std::max(0, significant_digits - before);
  int zeros = 0;
  for (Rational unit(1, 10); compare(unit) < 0 && compare(-unit) > 0 && zeros < 10'000; unit /= 10) ++zeros;
  return significant_digits + zeros;
}

Univariate<Rational> primitive(const Univariate<Rational>& p) {
  if (p.is_zero()) return p;
  Rational common = 1;
  for (const Rational& c : p.coefficients()) common *= (common * c).denominator();
  std::vector<Rational> whole;
  Rational content;
  for (const Rational& c : p.coefficients()) {
    whole.push_back(c * common);
    Rational a = content, b = whole.back().abs();
    while (!b.is_zero()) a = std::exchange(b, a - b * (a / b).floor());
    content = a;
  }
  if (p.leading().sign() < 0) content = -content;
  for (Rational& c : whole) c /= content;
  return whole;
}

Univariate<Rational> univariate(const Polynomial& p, Letter letter) {
  std::vector<Rational> result;
  for (const Polynomial& c : p.coefficients(letter)) {
    if (!c.is_constant()) throw Error("a polynomial in one letter was expected");
    result.push_back(c.constant());
  }
  return result;
}

std::vector<RealRoot> real_roots(const Univariate<Rational>& p) { return roots_from({p}, false); }

std::vector<RealRoot> positive_roots(const std::vector<Univariate<Rational>>& polynomials) {
  return roots_from(polynomials, true);
}

RealRoot square_root(const RealRoot& square) {
  if (square.compare(0) <= 0) throw Undefined("only a positive number has a positive square root");
  std::vector<Rational> doubled;  // p(z^2)
  for (const Rational& c : square.polynomial().coefficients()) {
    if (!doubled.empty()) doubled.push_back(0);
    doubled.push_back(c);
  }
  std::vector<Univariate<Rational>> factors = irreducible_factors(Univariate<Rational>(doubled));
  if (factors.size() > 1 && square.is_rational())
    for (const Univariate<Rational>& f : factors)
      if (const Rational z = -f[0] / f[1]; z.sign() > 0) return RealRoot(z);
  // p(z^2) has one root in (a, b) as long as p has one in (a^2, b^2), so one factor has a root there.
  const Rational least = square.is_rational() ? Rational(0) : std::max(square.low(), Rational(0));
  for (int bits = 32;; bits *= 2) {
    const Rational unit = Rational(1, 2).pow(bits);
    const RealRoot narrow = square.refined(square.high() * unit);
    if (narrow.low().sign() <= 0) continue;
    const Rational a = root_below(narrow.low(), unit), b = root_below(narrow.high(), unit) + unit;
    if (a.sign() <= 0 || a * a < least || (!square.is_rational() && b * b > square.high())) continue;
    for (const Univariate<Rational>& f : factors)
      if (const ExactSign sign(f); sign(a) * sign(b) < 0) return RealRoot(f, a, b);
  }
}

RealRoot scaled(const RealRoot& number, const Rational& factor) {
  if (number.is_rational()) return RealRoot(number.rational() * factor);
  std::vector<Rational> coefficients = number.polynomial().coefficients();
  for (std::size_t k = 0; k < coefficients.size(); ++k) coefficients[k] /= factor.pow(static_cast<int>(k));
  return RealRoot(std::move(coefficients), number.low() * factor, number.high() * factor);
}

Rational simplest_between(const Rational& low, const Rational& high) {
  // Stern and Brocot: the whole part is shared, or an integer fits.
  const Rational whole = low.floor();
  if (whole + 1 < high) return whole + 1;
  const Rational below = low - whole, above = high - whole;  // 0 <= below < above <= 1
  if (below.is_zero()) return whole + Rational(1) / ((Rational(1) / above).floor() + 1);
  return whole + Rational(1) / simplest_between(Rational(1) / above, Rational(1) / below);
}

}  // namespace shortfall
