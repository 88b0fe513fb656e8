// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/linear_kit.hpp"

#include <algorithm>

#include "analysis/correction/matching.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr Letter kTrueStiffness = 11;
constexpr Letter kTrueDamping = 12;
constexpr Letter kFlowCosine = 13;  // C, position after h from x0 = 1, v0 = 0
constexpr Letter kFlowSine = 14;    // S, position after h from x0 = 0, v0 = 1
constexpr Letter kFlowDecay = 15;   // D = e^(-c h)

class Matcher {
 public:
  Matcher(const Program& program, const Force& force, const Values& given, int substeps)
      : program_(program), force_(force), given_(given), substeps_(substeps) {
    k_ = force.k ? Fraction(*force.k) : Fraction::letter(kTrueStiffness);
    c_ = force.c ? Fraction(*force.c) : Fraction::letter(kTrueDamping);
    cosine_ = force.spring ? Fraction::letter(kFlowCosine) : Fraction(1);
    decay_ = force.damper ? Fraction::letter(kFlowDecay) : Fraction(1);
    sine_ = force.spring ? Fraction::letter(kFlowSine) : (Fraction(1) - decay_) / c_;
    trace_ = force.spring ? Fraction(2) * cosine_ - (force.damper ? c_ * sine_ : Fraction())
                          : Fraction(1) + decay_;
  }

  LinearKit matched() {
    // The integrator with the parameters still free; without damping first, with it when the determinant asks
    // for it.
    Force free = force_;
    free.k.reset();
    free.c.reset();
    free.degree = std::max(force_.degree, 0);
    if (!load(free)) return kit_;
    if (!force_.damper && !(determinant_ == Fraction(1))) {
      free.damper = true;
      if (!load(free)) return kit_;
    }
    if (!match_parameters(free)) return kit_;
    match_forces();
    return kit_;
  }

 private:
  bool refuse(const std::string& obstruction) {
    kit_.exists = false;
    kit_.obstruction = obstruction;
    return false;
  }

  /// The amplification matrix and the effect of a constant force, in the free letters.
  bool load(const Force& free) {
    const LinearDerivation d = linear_derivation(program_, free, given_, substeps_);
    names_ = d.map.letters;
    if (static_cast<int>(names_.size()) > kTrueStiffness)
      throw Unable("corrections for linear forces carry at most 6 free parameters");
    names_.resize(kLetters);
    names_[kTrueStiffness] = "k";
    names_[kTrueDamping] = "c";
    names_[kFlowCosine] = "C";
    names_[kFlowSine] = "S";
    names_[kFlowDecay] = "D";
    if (d.amplification.empty())
      return refuse(
          "the reported position and velocity do not carry the motion by themselves (a state besides them "
          "matters), so the spectrum has more than two "
          "eigenvalues; the exact flow has two");
    m_ = d.amplification;
    determinant_ = *d.determinant;
    integrator_trace_ = *d.trace;
    push_ = {motion_at(d.form, true, 1, 2), motion_at(d.form, false, 1, 2)};
    return true;
  }

  bool match_parameters(const Force& free) {
    if (m_[0][1].is_zero())
      return refuse(
          "the velocity does not move the position: the Jordan form of the step is not that of the exact "
          "flow");
    std::vector<Letter> unknowns;
    if (free.spring) unknowns.push_back(kStiffness);
    if (free.damper) unknowns.push_back(kDamping);
    const Matching found = matching({integrator_trace_ - trace_, determinant_ - decay_}, unknowns, names_);
    if (!found.values) {
      kit_.impossible = found.impossible;
      return refuse((found.impossible
                         ? "trace and determinant of the step cannot both be matched to the exact flow's: "
                         : "trace and determinant of the step were not matched to the exact flow's: ") +
                    found.obstruction);
    }
    for (auto* entry : {&m_[0][0], &m_[0][1], &m_[1][0], &m_[1][1], &push_[0], &push_[1]})
      *entry = found.put_into(*entry);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const bool k = unknowns[i] == kStiffness;
      add(LinearCorrection::Kind::parameter, k ? "k" : "c", (*found.values)[i],
          k ? "give the integrator this stiffness: the frequency is then exact"
            : "give the integrator this damping: the decay is then exact");
      (k ? stiffness_ : damping_) = (*found.values)[i];
    }
    kit_.exists = m_[0][0] + m_[1][1] == trace_ && m_[0][0] * m_[1][1] - m_[0][1] * m_[1][0] == decay_;
    if (!kit_.exists) throw Error("matched parameters do not survive substitution");
    return true;
  }

  void add(LinearCorrection::Kind kind, const std::string& target, const Expr& value,
           const std::string& reason) {
    kit_.corrections.push_back({kind, target, value, reason});
  }
  void add(LinearCorrection::Kind kind, const std::string& target, const Fraction& value,
           const std::string& reason) {
    add(kind, target, formula(value, wording()), reason);
  }

  Wording wording() const { return {names_, "n", true}; }

  Expr sum_of(const std::vector<std::pair<Fraction, const char*>>& terms) const {
    Expr total = number(0);
    for (const auto& [weight, letter] : terms)
      total = joined(total, formula(weight, name(letter), wording()));
    return total;
  }

  /// g~, launch and read-out. Positions relative to the rest point (spring) or velocities to the terminal one
  /// (drag) obey the free motion.
  void match_forces() {
    const bool pushed = force_.degree == 0;
    if (force_.degree > 0) {
      kit_.exists = false;
      kit_.impossible = false;
      kit_.corrections.clear();
      kit_.obstruction =
          "for linear forces the kit is solved for a constant push at most, not for one that is a polynomial "
          "in t";
      return;
    }
    Fraction rest_v;       // velocity that the integrator reports at rest, or at its terminal speed
    Fraction push_factor;  // a~ / a
    const Fraction one(1);
    if (pushed && force_.spring) {
      // z = M z + b a~ at rest, with x = a/k
      const Fraction p = (one - m_[0][0]) * (one - m_[1][1]) - m_[0][1] * m_[1][0];
      const Fraction x = ((one - m_[1][1]) * push_[0] + m_[0][1] * push_[1]) / p;
      const Fraction v = (m_[1][0] * push_[0] + (one - m_[0][0]) * push_[1]) / p;
      push_factor = one / (k_ * x);
      rest_v = v * push_factor;
    } else if (pushed) {
      const Fraction terminal = push_[1] / (one - m_[1][1]);
      push_factor = Fraction::letter(kStepLetter) / c_ / (m_[0][1] * terminal + push_[0]);
      rest_v = terminal * push_factor;
    }
    if (pushed)
      add(LinearCorrection::Kind::parameter, "a", sum_of({{push_factor, "a"}}),
          force_.spring ? "give it this force: the rest point is then exact"
                        : "give it this force: the terminal speed is then exact");
    const Fraction per = one / m_[0][1];
    const Fraction shift = (cosine_ - m_[0][0]) * per;
    if (force_.spring) {
      // v0' - v* = ((C - m11) (x0 - x*) + S v0) / m12
      add(LinearCorrection::Kind::launch, "v0",
          sum_of({{shift, "x0"}, {sine_ * per, "v0"}, {pushed ? rest_v - shift / k_ : Fraction(), "a"}}),
          "start with this velocity: the first position is then exact");
      const Fraction back = one / sine_;
      add(LinearCorrection::Kind::read_out, "v",
          sum_of({{-shift / (sine_ * per), "x_n"},
                  {m_[0][1] * back, "v_n"},
                  {pushed ? shift / (sine_ * per) / k_ - m_[0][1] * back * rest_v : Fraction(), "a"}}),
          "report this velocity; go on with the integrator's own");
    } else {
      // v0' - v* = S (v0 - a/c) / m12
      const Fraction keep = sine_ * per;
      add(LinearCorrection::Kind::launch, "v0",
          sum_of({{keep, "v0"}, {pushed ? rest_v - keep / c_ : Fraction(), "a"}}),
          "start with this velocity: the first position is then exact");
      add(LinearCorrection::Kind::read_out, "v",
          sum_of({{one / keep, "v_n"}, {pushed ? one / c_ - rest_v / keep : Fraction(), "a"}}),
          "report this velocity; go on with the integrator's own");
    }
    kit_.proof =
        "trace and determinant of the step equal those of the exact flow over h, so both motions satisfy "
        "x(n+2) = T x(n+1) - D x(n) about the same rest "
        "motion; with the launch they agree at n = 0 and 1, hence for every n";
    define_flow();
  }

  void define_flow() {
    const LinearFlow flow = linear_flow(force_, names_);
    kit_.definitions = flow.definitions;
    const auto at_h = [](const Expr& e) { return replace(e, "t", name("h")); };
    if (force_.spring) {
      kit_.definitions.push_back({"C", at_h(flow.cosine), "true position after h from x0 = 1, v0 = 0"});
      kit_.definitions.push_back({"S", at_h(flow.sine), "true position after h from x0 = 0, v0 = 1"});
    }
    if (force_.damper) {
      const Expr c = force_.c ? number(*force_.c) : name("c");
      kit_.definitions.push_back({"D", call("exp", {negate(c) * name("h")}),
                                  "the share of the velocity that damping leaves after h"});
    }
  }

  const Program& program_;
  const Force& force_;
  const Values& given_;
  int substeps_;
  LinearKit kit_;
  std::vector<std::string> names_;
  Fraction k_, c_, cosine_, sine_, decay_, trace_;
  std::vector<std::vector<Fraction>> m_;
  std::vector<Fraction> push_;
  Fraction determinant_, integrator_trace_, stiffness_, damping_;
};

}  // namespace

std::optional<QuadraticForm> quadratic_form(const std::vector<std::vector<Fraction>>& m) {
  if (m.empty() || m[0][1].is_zero()) return std::nullopt;
  const Fraction det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  // Q = [-m21, (m11 - m22)/2; ., m12] satisfies M^T Q M = det(M) Q; divided by m12.
  const QuadraticForm q{-m[1][0] / m[0][1], (m[0][0] - m[1][1]) / m[0][1], det};
  const Fraction b = q.xv / Fraction(2);
  const Fraction xx = m[0][0].pow(2) * q.xx + Fraction(2) * m[0][0] * m[1][0] * b + m[1][0].pow(2);
  const Fraction xv =
      m[0][0] * m[0][1] * q.xx + (m[0][0] * m[1][1] + m[0][1] * m[1][0]) * b + m[1][0] * m[1][1];
  const Fraction vv = m[0][1].pow(2) * q.xx + Fraction(2) * m[0][1] * m[1][1] * b + m[1][1].pow(2);
  if (!(xx == det * q.xx) || !(xv == det * b) || !(vv == det))
    throw Error("a quadratic form does not survive substitution");
  return q;
}

LinearKit linear_kit(const Program& program, const Force& force, const Values& given, int substeps) {
  Matcher matcher(program, force, given, substeps);
  LinearKit kit = matcher.matched();
  kit.conserved = quadratic_form(linear_derivation(program, force, given, substeps).amplification);
  return kit;
}

}  // namespace shortfall
