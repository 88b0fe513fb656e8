// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/flow_series.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit_letters.hpp"

namespace shortfall {

namespace {

constexpr int kOrder = 10;  // two powers are lost on the way to k

/// A power series in h up to h^kOrder; coefficients in the true k and c.
using Series = std::vector<Polynomial>;

Series constant(const Polynomial& p) {
  Series s(kOrder + 1);
  s[0] = p;
  return s;
}

Series operator*(const Series& a, const Series& b) {
  Series result(kOrder + 1);
  for (int i = 0; i <= kOrder; ++i) {
    if (a[i].is_zero()) continue;
    for (int j = 0; i + j <= kOrder; ++j)
      if (!b[j].is_zero()) result[i + j] += a[i] * b[j];
  }
  return result;
}

Series shifted(const Series& s, int by) {  // h^by s
  Series result(kOrder + 1);
  for (int i = 0; i <= kOrder; ++i)
    if (i - by >= 0 && i - by <= kOrder) result[i] = s[i - by];
  return result;
}

/// trace(exp(h A)) and det(exp(h A)).
std::pair<Series, Series> flow(const Polynomial& k, const Polynomial& c) {
  Series trace(kOrder + 1), determinant(kOrder + 1);
  Polynomial before = 2, now = -c;  // of A^0 and A^1; A^2 = -c A - k
  Rational factorial = 1;
  Polynomial decay = 1;
  for (int j = 0; j <= kOrder; ++j) {
    if (j > 0) factorial *= j;
    trace[j] = before * Polynomial(Rational(1) / factorial);
    determinant[j] = decay * Polynomial(Rational(1) / factorial);
    decay = decay * -c;
    const Polynomial next = -c * now - k * before;
    before = now;
    now = next;
  }
  return {trace, determinant};
}

class Powers {
 public:
  explicit Powers(Series s) : powers_{constant(1), std::move(s)} {}
  const Series& operator[](int exponent) {
    while (static_cast<int>(powers_.size()) <= exponent) powers_.push_back(powers_.back() * powers_[1]);
    return powers_[exponent];
  }

 private:
  std::vector<Series> powers_;
};

}  // namespace

std::vector<Fraction> leading_differences(const Matching& m, const BranchPoint& point, const Fraction& k,
                                          const Fraction& c) {
  for (const Polynomial& equation : m.equations)
    for (Letter letter = 0; letter < kLetters; ++letter)
      if (equation.contains(letter) && letter != kStepLetter && letter != kStiffness && letter != kDamping &&
          letter != kFlowTrace && letter != kFlowDecay)
        return {};
  // With h = 1 in the unknowns: y = h^2 k and d = h c.
  const auto weight = [](Letter unknown) { return unknown == kStiffness ? 2 : 1; };
  const std::size_t count = m.unknowns.size();
  std::vector<Rational> jacobian;
  for (const Polynomial& equation : m.equations)
    for (const Letter unknown : m.unknowns) {
      Polynomial d = small_step_part(equation).derivative(unknown);
      for (const auto& [letter, value] : point) d = d.substitute(letter, value);
      jacobian.push_back(d.constant());
    }
  const Rational det = count == 1 ? jacobian[0] : jacobian[0] * jacobian[3] - jacobian[1] * jacobian[2];
  if (det.is_zero()) return {};

  const auto [trace, determinant] = flow(k.numerator(), c.numerator());
  Powers t(trace), d(determinant);
  std::vector<Series> values;
  for (const Letter unknown : m.unknowns)
    values.push_back(constant(unknown == kStiffness ? k.numerator() : c.numerator()));
  const std::vector<Series> truth = values;
  for (int round = 0; round <= kOrder; ++round) {
    std::vector<Powers> powers;
    for (std::size_t i = 0; i < count; ++i) powers.emplace_back(values[i]);
    std::vector<Series> residual;
    bool settled = true;
    for (const Polynomial& equation : m.equations) {
      Series sum(kOrder + 1);
      // An equation may carry a common power of h: with h = 1 in the unknowns it disappears.
      int least = 1 << 20;
      const auto own = [&](const Polynomial::Term& term) {
        int power = term.monomial.exponent(kStepLetter);
        for (const Letter unknown : m.unknowns) power -= weight(unknown) * term.monomial.exponent(unknown);
        return power;
      };
      for (const auto& term : equation.terms()) least = std::min(least, own(term));
      for (const auto& term : equation.terms()) {
        Series product = constant(Polynomial(term.coefficient));
        product = product * t[term.monomial.exponent(kFlowTrace)];
        product = product * d[term.monomial.exponent(kFlowDecay)];
        int shift = own(term) - least;
        for (std::size_t i = 0; i < count; ++i) {
          const int exponent = term.monomial.exponent(m.unknowns[i]);
          product = product * powers[i][exponent];
          shift += weight(m.unknowns[i]) * exponent;
        }
        product = shifted(product, shift);
        for (int j = 0; j <= kOrder; ++j) sum[j] += product[j];
      }
      for (const Polynomial& p : sum) settled = settled && p.is_zero();
      residual.push_back(std::move(sum));
    }
    if (settled) break;
    // One step of Newton's method with the Jacobian at the point: it gains a power of h.
    for (std::size_t i = 0; i < count; ++i) {
      Series step(kOrder + 1);
      for (int j = 0; j <= kOrder; ++j) {
        if (count == 1) {
          step[j] = residual[0][j] * Polynomial(Rational(1) / det);
        } else {
          const Rational a = i == 0 ? jacobian[3] : -jacobian[2];
          const Rational b = i == 0 ? -jacobian[1] : jacobian[0];
          step[j] = (residual[0][j] * Polynomial(a) + residual[1][j] * Polynomial(b)) *
                    Polynomial(Rational(1) / det);
        }
      }
      const int w = weight(m.unknowns[i]);
      for (int j = w; j <= kOrder; ++j) values[i][j - w] -= step[j];
      if (round == 0)
        for (int j = 0; j < w; ++j)
          if (!step[j].is_zero()) return {};  // not the branch that tends to the true value
    }
  }
  std::vector<Fraction> result;
  for (std::size_t i = 0; i < count; ++i) {
    Fraction leading;
    for (int j = 0; j <= kOrder - 2 && leading.is_zero(); ++j)
      leading = Fraction((values[i][j] - truth[i][j]) * Polynomial::letter(kStepLetter, j));
    result.push_back(leading);
  }
  return result;
}

}  // namespace shortfall
