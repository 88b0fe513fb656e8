// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/linear_flow.hpp"

#include <algorithm>

#include "analysis/algebra/surd.hpp"
#include "analysis/program/print.hpp"

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

Fraction first(const std::vector<Fraction>& p) { return p.empty() ? Fraction() : p[0]; }

/// weight * vector * factor, left out when the weight is 0.
Expr product(const Expr& weight, const Expr& vector, const Expr& factor) {
  if (is_number(weight, 0)) return number(0);
  return chained(weight * vector, factor);
}

struct Fundamental {
  std::string condition;
  std::vector<Definition> definitions;
  Expr cosine, sine, cosine_rate, sine_rate;
  Expr shape = nullptr;  ///< where cosine_rate is -k times it
};

constexpr const char* kRunsAway = ": unstable physics, the true motion itself runs away";

Fundamental drag(const Force& force, const Wording& w) {  // 1 and (1 - e^-ct)/c
  const Expr c = formula(force.damping(), w);
  const Expr rate = formula(-force.damping(), w);  // log(1 - c), and not -(-log(1 - c))
  const Expr decay = call("exp", {rate * kT});
  const std::string name = print(c->op == Expression::Op::negate ? rate : c);
  const std::string condition = !force.c ? (force.own_c ? name : "c") + " is not 0"
                                : force.c->sign() < 0
                                    ? "c < 0, a drag that drives: the speed itself runs away"
                                    : "all t";
  const Expr sine =
      !force.c && c->op == Expression::Op::negate ? (decay - number(1)) / rate : (number(1) - decay) / c;
  return {condition, {}, number(1), sine, number(0), decay};
}

/// From cos(w t), sin(w t)/w, or what takes their place, and the damping.
Fundamental damped(const Force& force, const Wording& w, const Expr& cosine, const Expr& sine) {
  const Expr k = formula(force.stiffness(), w);
  if (!force.damper) return {{}, {}, cosine, sine, negate(chained(k, sine)), cosine, sine};
  const Expr half = formula(force.damping() / Fraction(2), w);
  const Expr decay = call("exp", {formula(-force.damping() / Fraction(2), w) * kT});
  return {{},
          {},
          decay * (cosine + chained(half, sine)),
          chained(decay, sine),
          negate(chained(k * decay, sine)),
          decay * (cosine - chained(half, sine)),
          chained(decay, sine)};
}

/// k - c^2/4, the sign of which tells the cases apart.
Fraction discriminant(const Force& force) { return force.stiffness() - force.damping().pow(2) / Fraction(4); }

/// "k > c^2/4", in the words of an integrator that damps by itself: "k > log(1 - c)^2/4".
std::string comparison(const Force& force, const Wording& w, const std::string& relation) {
  const std::string k = force.own_k ? print(formula(force.stiffness(), w)) : "k";
  const std::string c = force.own_c ? print(formula(force.damping().pow(2), w)) : "c^2";
  return k + relation + c + "/4";
}

Expr square_root(const Fraction& f, const Wording& w) {
  if (f.is_constant())
    if (const Surd root = Surd::sqrt(f.constant()); root.is_rational()) return number(root.rational_part());
  return call("sqrt", {formula(f, w)});
}

Fundamental oscillating(const Force& force, const Wording& w) {
  const Expr omega = name(unused_name(force.damper ? "wd" : "w", w.letters));
  // k sin(w t)/w is w sin(w t) where nothing damps.
  Fundamental f = damped(force, w, call("cos", {omega * kT}), call("sin", {omega * kT}) / omega);
  if (!force.damper) {
    f.cosine_rate = negate(omega * call("sin", {omega * kT}));
    f.shape = nullptr;
  }
  f.definitions = {{omega->name, square_root(discriminant(force), w),
                    force.damper ? "angular frequency of the damped oscillation" : "angular frequency"}};
  f.condition = force.damper ? comparison(force, w, " > ") + ", underdamped" : "k > 0";
  return f;
}

Fundamental critical(const Force& force, const Wording& w) {
  Fundamental f = damped(force, w, number(1), kT);
  f.condition = comparison(force, w, " = ") + ", critically damped";
  return f;
}

Fundamental running(const Force& force, const Wording& w) {
  const Expr s = name(unused_name("s", w.letters));
  Fundamental f = damped(force, w, call("cosh", {s * kT}), call("sinh", {s * kT}) / s);
  if (!force.damper) {
    f.cosine_rate = s * call("sinh", {s * kT});
    f.shape = nullptr;
  }
  f.definitions = {{s->name, square_root(-discriminant(force), w), "rate"}};
  f.condition =
      !force.damper ? std::string("k < 0") + kRunsAway : comparison(force, w, " < ") + ", overdamped";
  if (force.damper)
    f.condition += force.k && force.k->sign() < 0 ? std::string("; k < 0") + kRunsAway
                   : force.k                      ? ""
                                                  : std::string(" (with k < 0") + kRunsAway + ")";
  return f;
}

std::vector<Fundamental> fundamentals(const Force& force, const Wording& w) {
  if (!force.spring) return {drag(force, w)};
  if (const Fraction d = discriminant(force); d.is_constant()) {
    const int sign = d.constant().sign();
    return {sign > 0 ? oscillating(force, w) : sign < 0 ? running(force, w) : critical(force, w)};
  }
  if (!force.damper) return {oscillating(force, w), running(force, w)};
  return {oscillating(force, w), critical(force, w), running(force, w)};
}

/// The motion from x0, v0 under the force's polynomial.
FlowCase motion(const Force& force, const Wording& w, const Fundamental& f) {
  Expr x = chained(name("x0"), f.cosine);
  Expr v = is_number(f.cosine_rate, 0) ? number(0) : joined(number(0), chained(name("x0"), f.cosine_rate));
  if (f.shape) {  // -4 x0 e^(-2 t), and not -x0 4 e^(-2 t)
    const Expr weight = formula(-force.stiffness(), name("x0"), w);
    const bool minus = weight->op == Expression::Op::negate;
    v = chained(minus ? weight->operands[0] : weight, f.shape);
    if (minus) v = negate(v);
  } else if (f.cosine_rate->op == Expression::Op::negate) {
    v = negate(chained(name("x0"), f.cosine_rate->operands[0]));
  }
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
         {std::tuple{first(p), f.cosine, f.cosine_rate}, {first(rate), f.sine, f.sine_rate}}) {
      if (begin.is_zero()) continue;
      const bool minus = begin.numerator().terms().front().coefficient.sign() < 0;
      const Expr weight = formula(minus ? -begin : begin, w);
      for (const auto& [total, factor] : {std::pair{&x, &cosine}, {&v, &sine}}) {
        const Expr part = product(weight, letter, *factor);
        *total = minus ? *total + part : *total - part;
      }
    }
  }
  return {f.condition, f.definitions, x, v, f.cosine, f.sine};
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
  const Wording w{letters, "n", true};
  LinearFlow flow;
  for (const Fundamental& f : fundamentals(force, w)) {
    const FlowCase found = motion(force, w, f);
    if (flow.position)
      flow.others.push_back(found);
    else
      static_cast<FlowCase&>(flow) = found;
  }
  return flow;
}

}  // namespace shortfall
