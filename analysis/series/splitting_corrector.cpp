// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_corrector.hpp"

#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/linear_solve.hpp"
#include "analysis/series/splitting_first_order.hpp"

namespace shortfall {

namespace {

void append_stage(SplittingParts<Surd>& parts, const Surd& a, const Surd& b) {
  parts.push_back({false, a});
  parts.push_back({true, b});
  parts.push_back({false, Surd(-2) * a});
  parts.push_back({true, -b});
  parts.push_back({false, a});
}

}  // namespace

SplittingParts<Surd> SymplecticCorrector::parts() const {
  const int stages = static_cast<int>(weights.size());
  SplittingParts<Surd> result;
  for (int i = stages; i >= 1; --i) append_stage(result, -a(i), b(i));
  for (int i = 1; i <= stages; ++i) append_stage(result, a(i), -b(i));
  return merged(result);
}

SymplecticCorrector symplectic_corrector(int stages, const Rational& alpha_squared) {
  if (stages < 1 || stages > 30)
    throw BadInput("a corrector has from 1 to 30 stages, not " + std::to_string(stages));
  if (alpha_squared.sign() <= 0) throw Undefined("a corrector's alpha squared is positive");
  const SplittingParts<Rational> step{{false, Rational(1, 2)}, {true, 1}, {false, Rational(1, 2)}};
  const auto error = first_order_in_kick(step, 2 * stages + 1).logarithm;
  std::vector<std::vector<Rational>> powers;
  std::vector<Rational> wanted;
  for (int k = 0; k < stages; ++k) {
    // -4 sum of r_i / alpha * (i alpha)^(2k+1) / (2k+1)! = c_(2k+1), and c_(2k+1) = l_(2k+2).
    std::vector<Rational>& row = powers.emplace_back();
    for (int i = 1; i <= stages; ++i) row.push_back(Rational(i).pow(2 * k + 1));
    wanted.push_back(error[static_cast<std::size_t>(2 * k + 2)] * factorial(2 * k + 1) /
                     (Rational(-4) * alpha_squared.pow(k)));
  }
  return {alpha_squared, *solve_linear(powers, wanted).solution};
}

int corrector_stages(int number) {
  if (number < 3 || number > 61 || number % 2 == 0)
    throw BadInput("a corrector is known by an odd number from 3 to 61, not by " + std::to_string(number));
  return (number - 1) / 2;
}

}  // namespace shortfall
