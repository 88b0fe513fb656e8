// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/linear_flow.hpp"

#include <algorithm>

namespace shortfall {

namespace {

const Expr kT = name("t");

std::vector<Fraction> derivative(const std::vector<Fraction>& p) {
  std::vector<Fraction> result;
  for (std::size_t j = 1; j < p.size(); ++j) result.push_back(p[j] * Fraction(static_cast<int>(j)));
  return result;
}

Fraction as_fraction(const std::vector<Fraction>& p) {
  Fraction total;
  for (std::size_t j = 0; j < p.size(); ++j)
    total += p[j] * Fraction::letter(kTimeLetter).pow(static_cast<int>(j));
  return total;
}

Expr first(const std::vector<Fraction>& p, const Wording& w) {
  return p.empty() ? number(0) : formula(p[0], w);
}

/// weight * vector * factor, left out when the weight is 0.
Expr product(const Expr& weight, const Expr& vector, const Expr& factor) {
  if (is_number(weight, 0)) return number(0);
  return chained(weight * vector, factor);
}

struct Fundamental {
  Expr cosine, sine, cosine_rate, sine_rate;
};

Fundamental fundamental(const Force& force, const Wording& w, LinearFlow& flow) {
  const Expr k = formula(force.stiffness(), w);
  const Expr c = formula(force.damping(), w);
  if (!force.spring) {  // drag: 1 and (1 - e^-ct)/c
    const Expr decay = call("exp", {negate(c) * kT});
    flow.condition = "c is not 0";
    return {number(1), (number(1) - decay) / c, number(0), decay};
  }
  const std::string frequency = force.damper ? "wd" : "w";
  const Expr omega = name(frequency);
  const Expr cosine = call("cos", {omega * kT});
  const Expr sine = call("sin", {omega * kT});
  if (!force.damper) {
    flow.definitions.push_back({frequency, call("sqrt", {k}), "angular frequency"});
    flow.condition =
        "k > 0 (for k < 0 the physics itself runs away: w is imaginary, cos and sin become cosh and sinh)";
    return {cosine, sine / omega, negate(omega * sine), cosine};
  }
  flow.definitions.push_back({frequency, call("sqrt", {k - power(c, 2) / number(4)}),
                              "angular frequency of the damped oscillation"});
  flow.condition =
      "k > c^2/4, underdamped (for k < c^2/4 wd is imaginary, cos and sin become cosh and sinh; at k = c^2/4 "
      "exactly, critical damping, "
      "cos becomes 1 and sin(wd t)/wd becomes t)";
  const Expr decay = call("exp", {negate(c / number(2)) * kT});
  const Expr half = c / number(2);
  return {decay * (cosine + half * sine / omega), decay * sine / omega, negate(k * decay * sine / omega),
          decay * (cosine - half * sine / omega)};
}

}  // namespace

std::vector<Fraction> particular_polynomial(int d, const Fraction& k, const Fraction& c) {
  const int lift = k.is_zero() ? (c.is_zero() ? 2 : 1) : 0;
  std::vector<Fraction> p(d + lift + 1);
  for (int j = d; j >= 0; --j) {
    // The coefficient of t^j: (j+2)(j+1) p_{j+2} + c (j+1) p_{j+1} + k p_j = [j = d]; solve for the highest p
    // that is still unknown.
    const auto at = [&](int i) { return i < static_cast<int>(p.size()) ? p[i] : Fraction(); };
    Fraction rest = j == d ? 1 : 0;
    if (lift == 0)
      p[j] = (rest - Fraction((j + 2) * (j + 1)) * at(j + 2) - c * Fraction(j + 1) * at(j + 1)) / k;
    else if (lift == 1)
      p[j + 1] = (rest - Fraction((j + 2) * (j + 1)) * at(j + 2)) / (c * Fraction(j + 1));
    else
      p[j + 2] = rest / Fraction((j + 2) * (j + 1));
  }
  return p;
}

LinearFlow linear_flow(const Force& force, const std::vector<std::string>& letters) {
  LinearFlow flow;
  const Wording w{letters, "n", true};
  const Fundamental f = fundamental(force, w, flow);
  flow.cosine = f.cosine;
  flow.sine = f.sine;
  Expr x = name("x0") * f.cosine;
  Expr v = is_number(f.cosine_rate, 0) ? number(0) : joined(number(0), name("x0") * f.cosine_rate);
  x = x + chained(name("v0"), f.sine);
  v = joined(v, chained(name("v0"), f.sine_rate));
  for (int d = 0; d <= force.degree; ++d) {
    const Expr letter = name(column_name(2 + d, force.degree));
    const std::vector<Fraction> p = particular_polynomial(d, force.stiffness(), force.damping());
    const std::vector<Fraction> rate = derivative(p);
    // The particular motion minus the free one that has the same beginning.
    x = joined(x, formula(as_fraction(p), letter, w));
    v = joined(v, formula(as_fraction(rate), letter, w));
    for (const auto& [begin, cosine, sine] :
         {std::tuple{first(p, w), f.cosine, f.cosine_rate}, {first(rate, w), f.sine, f.sine_rate}}) {
      x = x - product(begin, letter, cosine);
      v = v - product(begin, letter, sine);
    }
  }
  flow.position = x;
  flow.velocity = v;
  return flow;
}

}  // namespace shortfall
