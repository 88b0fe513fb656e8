// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/linear_code.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit_letters.hpp"
#include "analysis/program/print.hpp"
#include "notebooks-export/code_block.hpp"

namespace shortfall {

namespace {

constexpr int kParts = 8;                 // steps from 0 to dt in which a root is followed
constexpr int kRounds = 40;               // of Newton's method
constexpr int kIrrationalDigits = 25;     // of a root in the integrator's coefficients
constexpr const char* kReached = "1e-8";  // the last move of a root, relative; it is squared in every round

using Names = std::vector<std::string>;

class KitWriter {
 public:
  KitWriter(const LinearKit& kit, const LinearDerivation& d, Language language)
      : kit_(kit), d_(d), language_(language), block_(language) {
    if (kit_.implicit && kit_.implicit->radicals.empty()) unknowns_ = kit_.implicit->unknowns;
    name_vectors();
    name_members();
  }

  std::string text() {
    block_.open_class(class_name(), members_, arguments_);
    block_.close_constructor("prepare");
    for (const LinearCorrection& c : kit_.corrections) write_function(c);
    write_flow();
    write_prepare();
    block_.close_class();
    const std::string head = language_ == Language::cpp      ? "#include <cmath>\n\n"
                             : language_ == Language::python ? "import math\n\n\n"
                                                             : "";
    return head + about() + block_.text();
  }

 private:
  std::string class_name() const {
    return !d_.force.spring ? "ExactDrag" : d_.force.damper ? "ExactDampedSpring" : "ExactSpring";
  }

  std::string about() const {
    CodeBlock head(language_);
    std::string motion = d_.force.degree < 0 ? "" : d_.force.degree == 0 ? "a" : "f(t)";
    for (const auto& [there, term] : {std::pair{d_.force.spring, "k x"}, {d_.force.damper, "c v"}})
      if (there) motion += (motion.empty() ? "-" : " - ") + std::string(term);
    head.comment("Makes " + d_.integrator +
                 (d_.substeps > 1 ? ", " + std::to_string(d_.substeps) + " substeps a frame," : "") +
                 " exact on every frame of dt seconds, for the motion x'' = " + motion + ": " +
                 "proved in exact arithmetic, here computed in binary64.");
    head.comment(
        "Force, stiffness (1/s^2) and damping (1/s) are over the mass. Differences such as 1 - cos(w dt) "
        "lose "
        "digits where w dt is small: about twice as many as 1/(w dt) has.");
    for (const LinearCorrection& c : kit_.corrections) head.comment("- " + said(c) + ": " + c.reason + ".");
    if (d_.force.degree > 0)
      head.comment(
          "f, f1, f2, ... are the force and its derivatives by time; in a launch at t = 0, in a "
          "read-out at t = n dt.");
    if (!unknowns_.empty())
      head.comment(
          "The parameters are roots of equations, followed by Newton's method from small steps up to "
          "dt; NaN where it finds none.");
    if (!d_.assumptions.empty()) {
      std::string text = "Assumed: ";
      for (std::size_t i = 0; i < d_.assumptions.size(); ++i) text += (i ? "; " : "") + d_.assumptions[i];
      head.comment(text + ".");
    }
    head.comment("Written by shortfall. What it writes is yours.");
    return head.text();
  }

  /// What a correction is called in the class.
  std::string said(const LinearCorrection& c) const {
    return is_function(c) ? block_.routine_name(function_name(c)) : spelled("given_" + c.target);
  }

  std::string spelled(const std::string& name) const { return identifier(name, language_); }

  bool is_function(const LinearCorrection& c) const {
    return c.kind != LinearCorrection::Kind::parameter || c.target == "a" || c.target == "f";
  }

  std::string function_name(const LinearCorrection& c) const {
    switch (c.kind) {
      case LinearCorrection::Kind::parameter:
        return "given_" + c.target;
      case LinearCorrection::Kind::launch:
        return "launch_" + c.target;
      case LinearCorrection::Kind::read_out:
        break;
    }
    return "shown_" + c.target;
  }

  /// The vectors that functions take: names of ours, and of their arguments.
  void name_vectors() {
    vectors_ = {{"x0", "x0"}, {"v0", "v0"}, {"x_n", "x"}, {"v_n", "v"}, {"a", "a"}};
    for (int j = 0; j <= d_.force.degree; ++j)
      vectors_.emplace_back("f" + std::string(static_cast<std::size_t>(j), '\''),
                            j == 0 ? "f" : "f" + std::to_string(j));
  }

  void name_members() {
    const auto define = [&](const std::string& ours, const std::string& theirs) {
      if (names_.contains(ours)) return;
      names_[ours] = block_.member(theirs);
      if (std::ranges::find(members_, theirs) == members_.end()) members_.push_back(theirs);
    };
    // What the class is made from comes first, so that its names are the shortest.
    std::set<std::string> defined{"h", "t"};
    for (const auto& [ours, theirs] : vectors_) defined.insert(ours);
    std::vector<Expr> formulas;
    const auto meet = [&](const std::vector<Definition>& list) {
      for (const Definition& d : list) {
        defined.insert(d.name);
        formulas.push_back(d.value);
      }
    };
    meet(kit_.definitions);
    meet(kit_.step_definitions);
    for (const FlowCase& other : kit_.other_flows) {
      meet(other.definitions);
      formulas.insert(formulas.end(), {other.cosine, other.sine});
    }
    for (const ExtraLetters::Extra& e : kit_.extras)
      if (e.root) defined.insert(e.name);
    for (const Letter u : unknowns_) {
      defined.insert(kit_.letters[u]);
      formulas.push_back(first_guess(u));
    }
    for (const LinearCorrection& c : kit_.corrections) formulas.push_back(c.value);
    for (const Expr& e : equations()) formulas.push_back(e);
    Names letters{};
    for (const std::string first : {"k", "c"})
      if (std::ranges::any_of(formulas, [&](const Expr& e) { return mentions(e, first); }))
        letters.push_back(first);
    const auto fixed = static_cast<std::ptrdiff_t>(letters.size());
    for (const Expr& e : formulas) collect_names(e, letters);
    std::sort(letters.begin() + fixed, letters.end());
    for (const std::string& letter : letters)
      if (!defined.contains(letter)) {
        define(letter, free(spelled(letter)));
        arguments_.push_back(members_.back());
      }
    define("h", "dt");
    arguments_.emplace_back("dt");
    if (d_.force.spring) {
      define(kit_.letters[kFlowCosine], spelled("true_cosine"));
      define(kit_.letters[kFlowSine], spelled("true_sine"));
      define(kit_.letters[kFlowTrace], spelled("true_trace"));
    }
    define(kit_.letters[kFlowDecay], spelled("true_decay"));
    for (const Letter u : unknowns_) define(kit_.letters[u], spelled(given_as(u)));
    for (const LinearCorrection& c : kit_.corrections)
      if (!is_function(c)) define("given " + c.target, spelled("given_" + c.target));
    for (const std::string& name : defined)
      if (name != "t" && std::ranges::none_of(vectors_, [&](const auto& v) { return v.first == name; }))
        define(name, free(spelled(name)));
    if (!unknowns_.empty()) define("last move", spelled("last_move"));
    // Only what is used is declared.
    drop_unused(formulas);
  }

  void drop_unused(const std::vector<Expr>& formulas) {
    const std::set<std::string> kept{"h", "last move"};
    for (const auto& names : names_) {
      const std::string &ours = names.first, &theirs = names.second;
      const bool used = kept.contains(ours) || ours.starts_with("given ") ||
                        std::ranges::any_of(unknowns_, [&](Letter u) { return kit_.letters[u] == ours; }) ||
                        std::ranges::any_of(formulas, [&](const Expr& e) { return mentions(e, ours); });
      if (!used) std::erase_if(members_, [&](const std::string& m) { return block_.member(m) == theirs; });
      if (!used) unused_.insert(ours);
    }
  }

  /// Where a parameter that is solved for is what the integrator is given, it bears that name.
  std::string given_as(Letter unknown) const {
    const std::string& ours = kit_.letters[unknown];
    for (const LinearCorrection& c : kit_.corrections)
      if (!is_function(c) && c.value->op == Expression::Op::name && c.value->name == ours)
        return "given_" + c.target;
    return unknown == kStiffness ? "tuned_k" : "tuned_c";
  }

  /// A member's name that is no argument of a function.
  std::string free(std::string name) const {
    while (std::ranges::any_of(vectors_, [&](const auto& v) { return v.second == name; }) ||
           std::ranges::find(members_, name) != members_.end())
      name += "_";
    return name;
  }

  std::string value(const Expr& e) const { return code_in_binary64(e, language_, names_); }
  void assign(const std::string& ours, const Expr& e) {
    if (!unused_.contains(ours)) block_.assign(names_.at(ours), value(e));
  }
  void assign(const std::vector<Definition>& list) {
    for (const Definition& d : list) assign(d.name, d.value);
  }

  void write_function(const LinearCorrection& c) {
    if (!is_function(c)) return;
    block_.line();
    block_.comment(c.reason + ".");
    std::map<std::string, std::string> names = names_;
    Names arguments;
    for (const auto& [ours, theirs] : vectors_) {
      names[ours] = theirs;
      if (mentions(c.value, ours)) arguments.push_back(theirs);
    }
    block_.function(function_name(c), arguments, code_in_binary64(c.value, language_, names));
  }

  /// The exact flow over dt, for every kind of spring that the letters leave open.
  void write_flow() {
    block_.open_routine("flow", {});
    for (const ExtraLetters::Extra& e : kit_.extras)
      if (e.root && names_.contains(e.name) && e.name.find('(') == std::string::npos)
        assign(e.name, number(Rational::parse(e.root->significant(kIrrationalDigits))));
    const auto at_h = [](const Expr& e) { return replace(e, "t", name("h")); };
    const std::string cosine = d_.force.spring ? kit_.letters[kFlowCosine] : "",
                      sine = d_.force.spring ? kit_.letters[kFlowSine] : "";
    std::size_t first = 0;
    if (!kit_.other_flows.empty()) {
      // The first definition is the frequency: the root of what tells the cases apart.
      const Expr root = kit_.definitions.front().value;
      const std::string side = value(root->operands.at(0));
      block_.open_if(side + " > " + value(number(0)));
      for (; first < 3; ++first) assign(kit_.definitions[first].name, kit_.definitions[first].value);
      const FlowCase& beyond = kit_.other_flows.back();
      block_.open_else_if(side + " < " + value(number(0)));
      assign(beyond.definitions);
      assign(cosine, at_h(beyond.cosine));
      assign(sine, at_h(beyond.sine));
      block_.open_else();
      const bool critical = kit_.other_flows.size() > 1;  // without a damper k = 0: nothing acts
      assign(cosine, critical ? at_h(kit_.other_flows.front().cosine) : number(1));
      assign(sine, critical ? at_h(kit_.other_flows.front().sine) : name("h"));
      block_.close();
    }
    for (; first < kit_.definitions.size(); ++first)
      assign(kit_.definitions[first].name, kit_.definitions[first].value);
    if (kit_.definitions.empty()) block_.nothing();
    block_.close();
  }

  Expr first_guess(Letter unknown) const {
    return formula(unknown == kStiffness ? d_.force.stiffness() : d_.force.damping(), d_.wording());
  }

  /// Each equation, then its derivatives by the unknowns.
  std::vector<Expr> equations() const {
    std::vector<Expr> result;
    if (unknowns_.empty()) return result;
    for (const Polynomial& p : kit_.implicit->equations) {
      result.push_back(formula(Fraction(p), kit_.wording()));
      for (const Letter u : unknowns_) result.push_back(formula(Fraction(p.derivative(u)), kit_.wording()));
    }
    return result;
  }

  void write_prepare() {
    block_.open_routine("prepare", {});
    if (unknowns_.empty()) {
      block_.call("flow", {});
      write_given();
    } else {
      write_newton();
    }
    block_.close();
  }

  void write_given() {
    assign(kit_.step_definitions);
    for (const LinearCorrection& c : kit_.corrections) {
      if (is_function(c)) continue;
      const std::string& member = names_.at("given " + c.target);
      if (const std::string text = value(c.value); text != member) block_.assign(member, text);
    }
  }

  void write_newton() {
    for (const Letter u : unknowns_) block_.assign(names_.at(kit_.letters[u]), value(first_guess(u)));
    const std::string move = names_.at("last move"), dt = block_.member("dt"), whole = spelled("whole_dt");
    block_.assign(move, value(number(0)));
    block_.let(whole, dt);
    block_.open_loop("part", kParts);
    block_.assign(dt, whole + " * " + block_.as_number("part") + " / " + value(number(kParts)));
    block_.call("flow", {});
    block_.open_loop(language_ == Language::rust ? "_round" : "round", kRounds);
    const std::vector<Expr> terms = equations();
    const bool two = unknowns_.size() == 2;
    const Names words = two ? Names{"f1", "f1_k", "f1_c", "f2", "f2_k", "f2_c"} : Names{"f1", "f1_u"};
    Names ours;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      ours.push_back(spelled(words[i]));
      block_.let(ours[i], value(terms[i]));
    }
    Names steps{"shift"};
    if (two) {
      steps = {spelled("shift_k"), spelled("shift_c")};
      block_.let("slope", ours[1] + " * " + ours[5] + " - " + ours[2] + " * " + ours[4]);
      block_.let(steps[0], "(" + ours[0] + " * " + ours[5] + " - " + ours[3] + " * " + ours[2] + ") / slope");
      block_.let(steps[1], "(" + ours[3] + " * " + ours[1] + " - " + ours[0] + " * " + ours[4] + ") / slope");
    } else {
      block_.let(steps[0], ours[0] + " / " + ours[1]);
    }
    std::string moved, size;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      const std::string& u = names_.at(kit_.letters[unknowns_[i]]);
      block_.assign(u, u + " - " + steps[i]);
      moved += (i ? " + " : "") + block_.magnitude(steps[i]);
      size += (i ? " + " : "") + block_.magnitude(u);
    }
    block_.assign(move, "(" + moved + ") / (" + size + " + 1e-300)");
    block_.leave_loop_if(move + " < 1e-15");
    block_.close();
    block_.close();
    std::string reached = move + " < " + kReached;
    if (const auto& range = kit_.implicit->range; range && range->least) {
      const bool spring = unknowns_[0] == kStiffness;
      reached = block_.both(reached, names_.at(kit_.letters[spring ? kFlowCosine : kFlowDecay]) +
                                         " >= " + value(number(Rational::parse(*range->least))));
    }
    block_.open_if(reached);
    const std::size_t before = block_.text().size();
    write_given();
    if (block_.text().size() == before) block_.nothing();
    block_.open_else();
    for (const LinearCorrection& c : kit_.corrections)
      if (!is_function(c)) block_.assign(names_.at("given " + c.target), block_.not_a_number());
    for (const Definition& d : kit_.step_definitions)
      if (!unused_.contains(d.name)) block_.assign(names_.at(d.name), block_.not_a_number());
    block_.close();
  }

  const LinearKit& kit_;
  const LinearDerivation& d_;
  Language language_;
  CodeBlock block_;
  std::vector<Letter> unknowns_;  ///< roots of equations; empty where formulas give all
  std::vector<std::pair<std::string, std::string>> vectors_;
  std::map<std::string, std::string> names_;  ///< names of ours, as methods say them
  std::set<std::string> unused_;
  Names members_;
  Names arguments_;  ///< of the constructor
};

}  // namespace

std::string linear_kit_code(const LinearKit& kit, const LinearDerivation& derivation, Language language) {
  if (!kit.exists) throw Undefined("there is no correction to write: " + kit.obstruction);
  return KitWriter(kit, derivation, language).text();
}

}  // namespace shortfall
