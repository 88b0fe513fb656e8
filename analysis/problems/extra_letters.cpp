// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/problems/extra_letters.hpp"

#include <algorithm>
#include <numeric>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/problems/letters.hpp"

namespace shortfall {

namespace {

constexpr std::int64_t kLargestTrialDivisor = 1 << 20;

/// whole = square^2 * product of primes, as far as trial division finds them; what is left counts as a prime.
struct SquareFree {
  std::int64_t square = 1;
  std::vector<std::int64_t> primes;
};

SquareFree square_free(std::int64_t whole) {
  SquareFree result;
  for (std::int64_t p = 2; p <= kLargestTrialDivisor && p <= whole / p; ++p) {
    int power = 0;
    for (; whole % p == 0; whole /= p) ++power;
    for (int k = 0; k < power / 2; ++k) result.square *= p;
    if (power % 2 == 1) result.primes.push_back(p);
  }
  const Surd rest = Surd::sqrt(Rational(whole));
  std::int64_t root = 0;
  if (rest.is_rational() && rest.rational_part().fits_int64(root))
    result.square *= root;
  else
    result.primes.push_back(whole);
  return result;
}

/// 1 - c rather than -c + 1.
std::string shown(const Fraction& f, const std::vector<std::string>& names) {
  const Polynomial& p = f.numerator();
  const Rational constant = p.constant();
  const Polynomial rest = Polynomial(constant) - p;
  const bool turned = f.is_polynomial() && constant.sign() > 0 && rest.terms().size() == 1 &&
                      rest.terms().front().coefficient.sign() > 0;
  return turned ? constant.str() + " - " + rest.str(names) : f.str(names);
}

}  // namespace

Letter ExtraLetters::new_letter(std::string name) {
  if (static_cast<int>(names_.size()) >= kLetters)
    throw Unable("symbolic answers carry at most " + std::to_string(kLetters) +
                 " letters; there is none left for " + name);
  names_.push_back(std::move(name));
  return static_cast<Letter>(names_.size()) - 1;
}

std::vector<NumberField::Generator> ExtraLetters::generators() const {
  std::vector<NumberField::Generator> result;
  for (const Extra& e : extras_) {
    if (!e.root) continue;
    const Univariate<Rational> monic = e.root->polynomial().monic();
    result.push_back({e.letter, monic.coefficients()});
  }
  return result;
}

void ExtraLetters::adjoin(Extra extra) {
  extras_.push_back(std::move(extra));
  // The field that is open learns of it too, if it does not know it yet.
  if (NumberField* field = NumberField::innermost()) {
    const NumberField::Generator g = generators().back();
    if (std::ranges::find(field->generators(), g) == field->generators().end()) field->adjoin(g);
  }
}

Fraction ExtraLetters::square_root_of_prime(const Rational& prime) {
  const std::string name = "sqrt(" + prime.str() + ")";
  for (const Extra& e : extras_) {
    if (!e.root) continue;
    if (e.name == name) return Fraction::letter(e.letter);
    // Radicands with a common factor that trial division did not find would be related.
    const auto square = e.root->rational_square();
    std::int64_t a = 0, b = 0;
    if (square && square->fits_int64(a) && prime.fits_int64(b) && std::gcd(a, b) != 1)
      throw Unable("the square roots of " + square->str() + " and " + prime.str() +
                   " are related in a way that we cannot use");
    if (e.root->degree() > 2 && e.root->degree() % 2 == 0)
      throw Unable("the root '" + e.name + "' of even degree and " + name +
                   " may be related; we compute with one root of degree above 2 and, if that is odd, with "
                   "square roots");
  }
  const RealRoot value = shortfall::square_root(RealRoot(prime));
  const Letter letter = new_letter(name);
  adjoin({letter, name, std::make_shared<const RealRoot>(value), Function::sqrt, {}, {}});
  return Fraction::letter(letter);
}

Fraction ExtraLetters::square_root(const Rational& value) {
  if (value.sign() < 0) throw Undefined("the square root of a negative number, " + value.str());
  if (value.is_zero()) return 0;
  const Rational below = value.denominator();
  std::int64_t whole = 0;
  if (!(value.numerator() * below).fits_int64(whole))
    throw Unable("the square root of " + value.str().substr(0, 60) + ": we take exact ones up to about 9e18");
  const SquareFree parts = square_free(whole);
  Fraction result = Rational(parts.square) / below;
  for (const std::int64_t prime : parts.primes)
    if (prime != 1) result *= square_root_of_prime(prime);
  return result;
}

Fraction ExtraLetters::root(const RealRoot& root, const std::string& name) {
  if (root.is_rational()) return root.rational();
  if (root.degree() == 2) {
    const Univariate<Rational> p = root.polynomial().monic();
    const Rational middle = -p[1] / Rational(2);
    const Fraction radius = square_root(middle * middle - p[0]);
    return root.compare(middle) > 0 ? Fraction(middle) + radius : Fraction(middle) - radius;
  }
  for (const Extra& e : extras_) {
    if (!e.root) continue;
    if (e.name == name && *e.root == root) return Fraction::letter(e.letter);
    if (e.root->degree() > 2 || root.degree() % 2 == 0)
      throw Unable("the roots '" + e.name + "' and '" + name +
                   "' may be related; we compute with one root of degree above 2 and, if that is odd, with "
                   "square roots");
  }
  const Letter letter = new_letter(name);
  adjoin({letter, name, std::make_shared<const RealRoot>(root), Function::sqrt, {}, {}});
  return Fraction::letter(letter);
}

void ExtraLetters::assume(Fraction positive, std::string text) {
  if (std::ranges::none_of(assumed_, [&](const Assumed& a) { return a.positive == positive; }))
    assumed_.push_back({std::move(positive), std::move(text)});
}

std::vector<std::string> ExtraLetters::used() const {
  std::vector<std::string> result;
  for (const Assumed& a : assumed_)
    if (a.used) result.push_back(a.text);
  return result;
}

/// Of a - b, the two values that max or min compares.
int ExtraLetters::sign(const Fraction& difference, Function f) {
  if (difference.is_constant()) return difference.constant().sign();
  for (Assumed& a : assumed_) {
    if (a.positive.is_zero()) continue;
    const Fraction ratio = difference / a.positive;
    if (!ratio.is_constant()) continue;
    a.used = true;
    return ratio.constant().sign();
  }
  if (difference.numerator().terms().size() == 1 && difference.is_polynomial() &&
      difference / Fraction::letter(kStepLetter) ==
          Fraction((difference / Fraction::letter(kStepLetter)).constant()))
    return (difference / Fraction::letter(kStepLetter)).constant().sign();
  throw Unable("which value of " + std::string(name_of(f)) + " is taken depends on the sign of " +
               shown(difference, names_) + "; say so in the integrator's head: assume " +
               shown(difference, names_) + " > 0");
}

namespace {

/// Whether it is a number, or a multiple of powers of the step, and positive.
bool is_positive(const Fraction& f) {
  if (!f.is_polynomial() || f.is_zero()) return false;
  for (const Polynomial::Term& t : f.numerator().terms())
    if (t.monomial.total_degree() != t.monomial.exponent(kStepLetter) || t.coefficient.sign() < 0)
      return false;
  return true;
}

}  // namespace

Fraction ExtraLetters::function(Function f, const Fraction& a, const Fraction& b) {
  switch (f) {
    case Function::max:
      return sign(a - b, f) < 0 ? b : a;
    case Function::min:
      return sign(a - b, f) < 0 ? a : b;
    case Function::sqrt:
      if (!a.is_constant())
        throw Unable("the square root of " + a.str(names_) +
                     " has no formula of the kind that we compute with");
      return square_root(a.constant());
    case Function::exp:
      if (a.is_zero()) return 1;
      break;
    case Function::log:
      if (a.is_one()) return 0;
      if (a.is_constant() && a.constant().sign() <= 0)
        throw Undefined("log of " + a.constant().str() + " is no real number");
      break;
    case Function::pow: {
      std::int64_t exponent = 0;
      if (a.is_one() || b.is_zero()) return 1;
      if (b.is_constant() && b.constant().fits_int64(exponent) && exponent >= -1000 && exponent <= 1000)
        return a.pow(static_cast<int>(exponent));
      if (a.is_zero() && is_positive(b)) return 0;  // what damps everything away in one second leaves nothing
      if (a.is_constant() && a.constant().sign() <= 0)
        throw Undefined("pow of " + a.constant().str() +
                        (a.is_zero() ? " is known only for a positive exponent" : " is no real number"));
      break;
    }
    default:
      throw Unable("the function " + std::string(name_of(f)) + " does not stand in programs");
  }
  if (a.contains(kTimeLetter) || b.contains(kTimeLetter) || a.contains(kCount) || b.contains(kCount))
    throw Unable(std::string(name_of(f)) +
                 " of what changes from step to step has no closed form of this kind");
  const bool two = arity(f) == 2;
  for (const Extra& e : extras_)
    if (!e.root && e.function == f && e.a == a && (!two || e.b == b)) return Fraction::letter(e.letter);
  const std::string name =
      std::string(name_of(f)) + "(" + shown(a, names_) + (two ? ", " + shown(b, names_) : "") + ")";
  const Letter letter = new_letter(name);
  extras_.push_back({letter, name, nullptr, f, a, two ? b : Fraction()});
  return Fraction::letter(letter);
}

}  // namespace shortfall
