// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/linear_kit.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit_letters.hpp"
#include "analysis/correction/lettered_step.hpp"
#include "analysis/correction/linear_launch.hpp"
#include "analysis/correction/matching.hpp"
#include "analysis/correction/open_step.hpp"
#include "analysis/correction/own_parameters.hpp"
#include "analysis/correction/stiffness_alone.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kLongestKit = 2000;   // terms
constexpr int kHighestReadableDegree = 12;  // of a force polynomial: nobody reads what is longer

class Matcher {
 public:
  Matcher(const Program& program, const Force& asked, const Values& given, int substeps)
      : program_(program),
        own_(own_parameters(program, asked, given, substeps)),
        force_(own_.force),
        given_(own_.given),
        substeps_(substeps) {
    const auto known = [](bool there, const auto& own, const auto& number, Letter letter) {
      return !there ? Fraction() : own ? *own : number ? Fraction(*number) : Fraction::letter(letter);
    };
    k_ = known(force_.spring, force_.own_k, force_.k, kTrueStiffness);
    c_ = known(force_.damper, force_.own_c, force_.c, kTrueDamping);
    cosine_ = force_.spring ? Fraction::letter(kFlowCosine) : Fraction(1);
    decay_ = !force_.damper ? Fraction(1)
             : own_.decay   ? Fraction::letter(own_.decay->letter).pow(own_.decay->power)
                            : Fraction::letter(kFlowDecay);
    sine_ = force_.spring ? Fraction::letter(kFlowSine) : (Fraction(1) - decay_) / c_;
    trace_ = force_.spring ? Fraction::letter(kFlowTrace) : Fraction(1) + decay_;
    point_ = {{kStiffness, 0}, {kDamping, 0}, {kFlowTrace, 2}, {kFlowDecay, 1}};
  }

  LinearKit matched() {
    if (force_.degree > kHighestReadableDegree)
      throw Unable("corrections for linear forces are solved for up to poly:" +
                   std::to_string(kHighestReadableDegree));
    // The integrator with the parameters still free; without damping first, with it when that cannot be
    // matched.
    Force free = without_own_equation(force_);
    free.k.reset();
    free.c.reset();
    Matching found = match(free);
    // Every substep leaves the same share of the velocity: with the root of D the parameter is rational.
    const int parts = found.kind == Matching::Kind::algebraic && !force_.spring && own_.tuned_for(kDamping)
                          ? equal_parts(program_, given_, substeps_)
                          : 1;
    if (parts > 1) {
      decay_ = Fraction::letter(kFlowDecay).pow(parts);
      sine_ = (Fraction(1) - decay_) / c_;
      trace_ = Fraction(1) + decay_;
      if (const Matching finer = match(free); finer.kind == Matching::Kind::rational) {
        found = finer;
        parts_ = parts;
        names_[kFlowDecay] = unused_name("d", step_->map.letters);
      } else {
        throw Error("a root of the decay does not give the parameter");
      }
    }
    if (found.kind == Matching::Kind::impossible && (!force_.damper || own_.decay)) {
      kit_.notes.push_back(!own_.decay ? why_not_stiffness_alone(*step_, found.obstruction, names_)
                           : found.obstruction.empty()
                               ? "a stiffness alone is not enough: it changes the determinant of the step, "
                                 "which the decay has to make"
                               : "a stiffness alone is not enough: " + found.obstruction);
      free.damper = true;
      found = match(free);
    }
    if (found.kind == Matching::Kind::impossible || found.kind == Matching::Kind::unknown) {
      kit_.impossible = found.kind == Matching::Kind::impossible;
      kit_.obstruction =
          (kit_.impossible ? "the spectrum of the step cannot be that of the exact flow: "
                           : "the spectrum of the step was not matched to the exact flow's: ") +
          found.obstruction;
      return kit_;
    }
    launch(found);
    kit_.letters = names_;
    return kit_;
  }

 private:
  /// Opens the step and solves for the parameters that it leaves free.
  Matching match(const Force& free) {
    step_ = open_step(program_, free, given_, substeps_, own_.replacements);
    if (program_.solves) {  // its functions become letters that the true motion may use
      const NumberField field(step_->map.generators);
      own_equation(program_, given_, *step_->map.force.extras);
      step_->map.letters = step_->map.force.extras->names();
      step_->map.extras = step_->map.force.extras->all();
    }
    names_ = step_->map.letters;
    kit_.extras = step_->map.extras;
    for (const auto& value : step_->small_step_values()) point_.push_back(value);
    if (static_cast<int>(names_.size()) > kTrueStiffness)
      throw Unable("corrections for linear forces carry at most 6 free parameters, roots and functions");
    names_.resize(kLetters);
    const std::vector<std::string> own = step_->map.letters;
    names_[kStiffness] = unused_name("k_new", own);
    names_[kDamping] = unused_name("c_new", own);
    for (const OwnParameters::Tuned& t : own_.tuned)
      if (t.scale.is_one()) names_[t.unknown] = unused_name(t.name + "_new", own);
    names_[kFlowTrace] = unused_name("T", own);
    names_[kTrueStiffness] = own[kStiffness];
    names_[kTrueDamping] = own[kDamping];
    names_[kFlowCosine] = unused_name("C", own);
    names_[kFlowSine] = unused_name("S", own);
    names_[kFlowDecay] = unused_name("D", own);
    if (own_.decay) names_[decay_letter()] = unused_name(own_.decay->power == 1 ? "D" : "d", own);
    std::vector<Letter> unknowns;
    if (free.spring || own_.tuned_for(kStiffness)) unknowns.push_back(kStiffness);
    if (free.damper || own_.tuned_for(kDamping)) unknowns.push_back(kDamping);
    if (unknowns.empty()) return nothing_to_tune();
    // k alone, and a determinant that depends on it: see stiffness_alone.hpp. No common factor has to be
    // looked for.
    if (unknowns == std::vector<Letter>{kStiffness} && !step_->pair.empty() &&
        step_->pair[0].contains(kStiffness))
      return {Matching::Kind::impossible, unknowns, {}, {}, {}, false};
    return matching(conditions(), unknowns, point_, names_);
  }

  Matching nothing_to_tune() const {
    Matching m{Matching::Kind::rational, {}, {}, {}, {}};
    for (const Fraction& condition : conditions())
      if (!condition.is_zero()) {
        m.kind = Matching::Kind::unknown;
        m.obstruction = "it damps by " + print(formula(decay_, wording())) +
                        ", with no parameter left that could change the difference " +
                        print(formula(condition, wording()));
      }
    return m;
  }

  /// That z^2 - T z + D divides the characteristic polynomial.
  std::vector<Fraction> conditions() const {
    if (!step_->pair.empty()) return {-step_->pair[1] - trace_, step_->pair[0] - decay_};
    std::vector<Fraction> rest = step_->nonzero;
    for (std::size_t j = rest.size() - 1; j >= 2; --j) {
      rest[j - 1] += rest[j] * trace_;
      rest[j - 2] -= rest[j] * decay_;
    }
    return {rest[1], rest[0]};
  }

  void launch(const Matching& found) {
    // Where trace and determinant are functions of the open parameters, all is solved in these; the matched
    // values follow.
    const bool open = !step_->pair.empty();
    if (!open && found.kind != Matching::Kind::rational) {
      kit_.impossible = false;
      kit_.obstruction =
          "the parameters exist for small steps, as roots of equations, but the step has further eigenvalues "
          "that no "
          "formula without roots tells apart; the launch is not solved for then";
      return;
    }
    const bool substitute = found.kind == Matching::Kind::rational;
    // With roots of equations the entries stay letters, or nobody could read the formulas.
    if (!substitute && force_.spring) lettered_ = lettered(*step_, names_);
    const OpenStep& step = lettered_ ? lettered_->step : *step_;
    const LaunchProblem problem{step,
                                [&](const Fraction& f) { return open ? f : found.put_into(f); },
                                open ? -step.pair[1] : trace_,
                                open ? step.pair[0] : decay_,
                                k_,
                                c_,
                                cosine_,
                                sine_};
    const LinearLaunch solved = linear_launch(problem);
    if (!solved.obstruction.empty()) {
      kit_.obstruction = solved.obstruction;
      return;
    }
    put_ = [&](Fraction f) {
      if (substitute) f = found.put_into(f);
      // Without damping the flow is said by C alone; and C by the parameters, where these are roots of
      // equations: what vanishes by them is then seen to be 0.
      if (force_.spring && !force_.damper) {
        f = f.substitute(kFlowTrace, Fraction(2) * cosine_);
        if (!substitute)
          f = f.substitute(kFlowCosine, -(lettered_ ? lettered_->step : *step_).pair[1] / Fraction(2));
      }
      return f;
    };
    if (const std::size_t terms = term_count(solved); terms > kLongestKit) {
      kit_.impossible = false;
      kit_.obstruction =
          "the parameters exist for small steps, as roots of equations, and so does the launch, but its "
          "formulas have " +
          std::to_string(terms) + " terms and are not written out: ask for a force of lower degree";
      return;
    }
    kit_.exists = true;
    for (std::size_t i = 0; i < found.unknowns.size(); ++i) {
      const bool k = found.unknowns[i] == kStiffness;
      const OwnParameters::Tuned* own = own_.tuned_for(found.unknowns[i]);
      const Expr value =
          substitute ? formula(own ? put_(found.values[i] / own->scale) : put_(found.values[i]), wording())
          : own      ? name(names_[found.unknowns[i]]) / formula(own->scale, wording())
                     : name(names_[found.unknowns[i]]);
      add(LinearCorrection::Kind::parameter,
          own ? own->name
          : k ? "k"
              : "c",
          value,
          std::string(k ? "give the integrator this stiffness"
                      : !own && has_parameter("c")
                          ? "give the force a damping -c v with this c, and keep the integrator's own"
                          : "give the integrator this damping") +
              (own ? ", its parameter" : "") + ": the " + (k ? "frequency" : "decay") + " is then exact");
    }
    if (own_.decay && !force_.spring)
      kit_.notes.push_back(
          "the step takes the decay " + print(formula(decay_, wording())) +
          " exactly: without a force every velocity is exact already, and there is no damping to be tuned");
    if (!substitute) {
      kit_.implicit = implicit_parameters(found, point_, k_, c_, program_, given_, substeps_, names_);
      if (kit_.implicit->jacobian.is_zero()) {
        kit_ = {};
        kit_.impossible = false;
        kit_.obstruction = "the implicit function theorem does not tell whether the parameters exist";
        return;
      }
    }
    add_forces(solved);
    prove(solved.by_states);
    define_flow();
  }

  void add(LinearCorrection::Kind kind, const std::string& target, const Expr& value,
           const std::string& reason, const Expr& spelled = nullptr) {
    kit_.corrections.push_back({kind, target, value, reason, spelled ? spelled : value});
  }

  bool has_parameter(const std::string& name) const {
    return std::ranges::find(program_.parameters, name, &Parameter::name) != program_.parameters.end();
  }

  Wording wording() const { return {names_, "n", true}; }
  Wording launch_wording() const { return {lettered_ ? lettered_->names : names_, "n", true}; }

  /// x * first + v * second + the force and its derivatives, the latter as f, f', ... or spelled out.
  Expr combination(const ForceForm& form, const char* x, const char* v, bool spelled, bool at_zero) const {
    Expr total = number(0);
    const auto add = [&](const Fraction& weight, const Expr& what) {
      const Fraction w = put_(weight);
      if (w.is_zero()) return;
      const bool sum = what->op == Expression::Op::add;
      total = joined(total, sum ? formula(w, launch_wording()) * what : formula(w, what, launch_wording()));
    };
    if (x) add(form.x, name(x));
    if (v) add(form.v, name(v));
    for (std::size_t j = 0; j < form.f.size(); ++j) {
      const int i = static_cast<int>(j);
      add(form.f[j], spelled && force_.degree > 0 ? derivative(i, force_.degree, at_zero)
                                                  : derivative_name(i, force_.degree));
    }
    return total;
  }

  void add_forces(const LinearLaunch& solved) {
    if (force_.degree >= 0) {
      const ForceForm f{{}, {}, solved.force};
      add(LinearCorrection::Kind::parameter, force_.degree == 0 ? "a" : "f",
          combination(f, nullptr, nullptr, false, false),
          force_.degree > 0
              ? "let it see this force instead: the motion that is polynomial in time is then exact"
          : force_.spring ? "give it this force: the rest point is then exact"
                          : "give it this force: the terminal speed is then exact",
          combination(f, nullptr, nullptr, true, false));
    }
    for (const auto& [target, form] : solved.start) {
      const bool same = target == "x0" || target == "x"
                            ? put_(form.x).is_one() && put_(form.v).is_zero() && all_zero(form.f)
                            : false;
      if (same) continue;
      add(LinearCorrection::Kind::launch, target, combination(form, "x0", "v0", false, true),
          solved.by_states ? "begin with this, in place of what the integrator's own start makes"
          : target == "v0" ? "start with this velocity: the first position is then exact"
                           : "start at this position",
          combination(form, "x0", "v0", true, true));
    }
    if (solved.read_out)
      add(LinearCorrection::Kind::read_out, "v", combination(*solved.read_out, "x_n", "v_n", false, false),
          "report this velocity; go on with the integrator's own",
          combination(*solved.read_out, "x_n", "v_n", true, false));
    else
      kit_.notes.emplace_back(
          "the reported velocity says nothing about the next position, so it has no read-out");
  }

  bool all_zero(const std::vector<Fraction>& f) const {
    return std::ranges::all_of(f, [&](const Fraction& e) { return put_(e).is_zero(); });
  }

  void prove(bool by_states) {
    kit_.proof =
        std::string(
            "z^2 - T z + D divides the characteristic polynomial of the step, T and D being trace and "
            "determinant ") +
        "of the exact flow over h; the launch puts the state into the plane that M^2 - T M + D takes to 0" +
        (step_->states() > 2 && by_states ? ", so that the further eigenvalues are not excited" : "") +
        ". So the positions and the true ones satisfy x(n+2) = T x(n+1) - D x(n) about the same motion" +
        (force_.degree > 0 ? ", polynomial in time" : "") +
        "; they agree at n = 0 and 1, hence for every n. Each premise was compared as a rational function.";
  }

  Letter decay_letter() const { return own_.decay ? own_.decay->letter : kFlowDecay; }

  /// What the letter of an exact decay stands for, as the integrator writes it.
  Expr own_share() const {
    for (const ExtraLetters::Extra& e : step_->map.force.extras->all())
      if (e.letter == own_.decay->letter) return letter_expression(e.name);
    throw Error("the letter of a decay is gone");
  }

  void define_flow() {
    const LinearFlow flow = linear_flow(force_, step_->map.force.extras->names());
    for (const auto& [there, number, what] :
         {std::tuple{force_.spring, force_.k, "k < 0: unstable physics, the true motion itself runs away"},
          {force_.damper, force_.c, "c < 0: a damper that drives, the true motion itself runs away"}})
      if (there && number && number->sign() < 0)
        kit_.notes.push_back(std::string(what) +
                             "; the corrected one runs away with it, exact on every frame");
    kit_.definitions = flow.definitions;
    kit_.other_flows = flow.others;
    const auto at_h = [](const Expr& e) { return replace(e, "t", name("h")); };
    if (force_.spring) {
      kit_.definitions.push_back(
          {names_[kFlowCosine], at_h(flow.cosine), "true position after h from x0 = 1, v0 = 0"});
      kit_.definitions.push_back(
          {names_[kFlowSine], at_h(flow.sine), "true position after h from x0 = 0, v0 = 1"});
    }
    const int parts = own_.decay ? own_.decay->power : parts_;
    if (force_.damper)
      kit_.definitions.push_back(
          {names_[decay_letter()],
           own_.decay ? own_share() : call("exp", {formula(-c_ / Fraction(parts), wording()) * name("h")}),
           "the share of the velocity that damping leaves after h" +
               (parts == 1 ? "" : "/" + std::to_string(parts))});
    if (force_.spring && force_.damper)
      kit_.definitions.push_back(
          {names_[kFlowTrace],
           number(2) * name(names_[kFlowCosine]) - chained(formula(c_, wording()), name(names_[kFlowSine])),
           "the trace of the exact flow over h"});
    if (kit_.implicit) {
      if (force_.spring && !force_.damper)
        for (Polynomial& p : kit_.implicit->equations)
          p = p.substitute(kFlowTrace, Polynomial(2) * Polynomial::letter(kFlowCosine));
      for (const Definition& d : kit_.implicit->radicals) kit_.definitions.push_back(d);
    }
    if (lettered_) {
      for (const LetteredStep::Meaning& m : lettered_->meanings)
        if (used(m.name)) kit_.step_definitions.push_back({m.name, formula(m.value, wording()), m.note});
    }
  }

  bool used(const std::string& letter) const {
    return std::ranges::any_of(kit_.corrections, [&](const auto& c) { return mentions(c.value, letter); });
  }

  const Program& program_;
  OwnParameters own_;
  const Force& force_;   ///< of the true motion
  const Values& given_;  ///< the parameters that are not solved for
  int substeps_;
  int parts_ = 1;  ///< D is this power of the letter kFlowDecay
  LinearKit kit_;
  std::optional<OpenStep> step_;
  std::optional<LetteredStep> lettered_;
  std::vector<std::string> names_;
  Fraction k_, c_, cosine_, sine_, decay_, trace_;
  BranchPoint point_;
  std::function<Fraction(Fraction)> put_;
};

}  // namespace

LinearKit linear_kit(const Program& program, const Force& force, const Values& given, int substeps) {
  const LinearDerivation d = linear_derivation(program, force, given, substeps);
  const NumberField field(d.map.generators);  // roots that the integrator's coefficients contain are numbers
  LinearKit kit = Matcher(program, force, given, substeps).matched();
  kit.conserved = quadratic_form(d.amplification);
  return kit;
}

}  // namespace shortfall
