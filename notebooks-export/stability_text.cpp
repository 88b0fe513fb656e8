// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/stability_text.hpp"

#include <numbers>
#include <utility>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/algebra/general_text.hpp"
#include "notebooks-export/stability_words.hpp"

namespace shortfall {

namespace {

constexpr int kShortDigits = 20;
constexpr std::size_t kWidestFormula = 200;

class StabilityWriter {
 public:
  StabilityWriter(const Stability& s, Style style) : s_(s), style_(style) {}

  std::string text() {
    head();
    answer();
    amplification();
    drag();
    damped();
    function();
    runaway();
    proof();
    return text_;
  }

 private:
  bool unicode() const { return style_ == Style::unicode; }
  std::string omega() const { return unicode() ? "ω" : "w"; }
  std::string squared() const { return unicode() ? "²" : "^2"; }
  std::string minus() const { return unicode() ? "−" : "-"; }
  std::string formula(const Expr& e) const {
    const std::string text = print(e, style_);
    return text.size() <= kWidestFormula
               ? text
               : "a formula of " + std::to_string(text.size()) + " characters (--json shows it)";
  }
  std::string formula(const Fraction& f, const Amplification& a) const {
    return formula(stability_formula(f, a, StabilityLetters::products));
  }

  void section(const std::string& title) { text_ += "\n" + title + "\n"; }
  /// One line: what, and what is to be said about it; empty for a continuation.
  void line(const std::string& what, const std::string& said) {
    text_ += "  " + what + std::string(what.size() < 14 ? 14 - what.size() : 1, ' ') + said + "\n";
  }

  void head() {
    text_ += s_.integrator + ", the oscillator x'' = " + minus() + omega() + squared() + " x with z = h " +
             omega();
    text_ += s_.substeps > 1 ? "; h is the frame, stepped in " + std::to_string(s_.substeps) + " substeps\n"
                             : "\n";
    std::string values;
    for (const auto& [name, value] : s_.parameters)
      values += (values.empty() ? "" : ", ") + name + " = " + parameter_text(value);
    if (s_.dt) values = "dt = " + s_.dt->str() + " s" + (values.empty() ? "" : ", ") + values;
    if (!values.empty())
      text_ += "for " + values +
               (s_.assumed.empty() ? "" : " (defaults where --param does not say otherwise)") + "\n";
    text_ += "\n";
  }

  std::string inside(const Window& w) const {
    if (w.is_point()) return "bounded at this single value";
    return w.decays  ? "every oscillation decays"
           : w.keeps ? "no oscillation grows or decays"
                     : "no oscillation grows";
  }

  void answer() {
    const Windows& w = s_.windows;
    if (w.always()) {
      line("stable", "for every z > 0: " + inside(w.windows[0]));
      return;
    }
    if (w.windows.empty()) {
      line("stable", "for no z > 0: however small the step, an oscillation grows");
      return;
    }
    if (!w.from_zero()) line("stable", "for no small z: an oscillation grows slowly");
    for (std::size_t i = 0; i < w.windows.size(); ++i) {
      const Window& window = w.windows[i];
      line(i == 0 ? (w.from_zero() ? "stable" : "") : "stable again",
           window_text(window, "z", style_) + "   " + inside(window));
    }
    if (w.windows.back().to) line("beyond", "unstable for every larger z");
    if (!s_.limit()) return;
    line("limit", "z = " + value_words(*s_.limit(), style_, kStabilityDigits));
    if (!s_.limit()->is_rational()) line("", isolation_words(*s_.limit(), style_));
    line("", "steps a period: more than " + steps_a_period());
    at_limit();
  }

  std::string steps_a_period() const {
    return general_text(2 * std::numbers::pi / s_.limit()->to_double(), 5) +
           (s_.substeps > 1 ? " (of " + std::to_string(s_.substeps) + " substeps each)" : "");
  }

  void at_limit() {
    if (!s_.at_limit) {
      line("at the limit", "there is no step: its stage equation is singular");
      return;
    }
    const LimitMotion* motion = s_.limit_motion ? &*s_.limit_motion : nullptr;
    line("at the limit", growth_sentence(*s_.at_limit, motion, style_));
    const std::string reason = growth_reason(*s_.at_limit, style_);
    // Signs of a frame's would be others: the powers of one substep's.
    line("", reason + (s_.substeps > 1 && !reason.empty() ? " (of one substep)" : ""));
    if (!motion) return;
    line("", (unicode() ? "xₙ = " : "x(n) = ") + formula(motion->position));
    line("", (unicode() ? "vₙ = " : "v(n) = ") + formula(motion->velocity));
    line("",
         std::string(motion->proved ? "proved for every n" : "NOT PROVED: a bug of ours, please report it") +
             (motion->valid_from > 0 ? " from " + std::to_string(motion->valid_from) + " on" : ""));
  }

  void amplification() {
    const Amplification& a = s_.undamped;
    section(s_.of_substep ? "Amplification by one substep, of h/" + std::to_string(s_.substeps)
                          : "Amplification by one step");
    if (!a.pair.empty()) {
      line("trace", formula(a.trace(), a));
      line("determinant", formula(a.determinant(), a));
    } else {
      line("polynomial", formula(characteristic_formula(a, StabilityLetters::products)));
      line(
          "",
          "its " + std::to_string(a.nonzero.size() - 1) +
              " roots are the eigenvalues; the motion's two are no rational functions apart from the others");
    }
    if (a.spurious_count() > 0)
      line("spurious", std::to_string(a.spurious_count()) + " eigenvalue(s) besides the two of the motion");
    if (a.zeros > 0)
      line("spurious", "eigenvalue 0, " +
                           std::string(a.zeros == 1 ? "once" : std::to_string(a.zeros) + " times") + ": of " +
                           comma_list(a.states) + " only " +
                           std::to_string(a.states.size() - static_cast<std::size_t>(a.zeros)) +
                           " matter for the next step");
  }

  void drag() {
    if (!s_.drag) return;
    const Drag& d = *s_.drag;
    section("Drag alone, x'' = " + minus() + "c v with d = c h");
    if (d.factor && s_.substeps == 1)
      line("velocity", "multiplied by " + formula(*d.factor, *s_.damped) + " each step");
    if (d.factor)
      line("turns round", d.reversals.empty() ? "never: the velocity keeps its sign"
                                              : "each " + std::string(s_.substeps > 1 ? "substep" : "step") +
                                                    " reverses the velocity for " + reversals(d));
    windows_of_drag(d.windows);
  }

  std::string reversals(const Drag& d) const {
    std::string text;
    for (const Drag::Reversal& r : d.reversals)
      text += (text.empty() ? "" : ", ") + short_exact(r.from, style_) + " < d" +
              (r.to ? " < " + short_exact(*r.to, style_) : "");
    return text;
  }

  void windows_of_drag(const Windows& windows) {
    if (windows.always()) return line("stable", "for every d > 0");
    if (windows.windows.empty()) return line("stable", "for no d > 0");
    for (const Window& w : windows.windows) line("stable", window_text(w, "d", style_));
    if (const WindowEdge* edge = windows.limit())
      line("limit", "d = " + exact_number(edge->at, style_, kShortDigits));
  }

  void damped() {
    if (!s_.damped || s_.damped->spurious_count() != 0 || s_.substeps > 1) return;
    const Amplification& a = *s_.damped;
    section("Both, x'' = " + minus() + omega() + squared() + " x " + minus() + " c v");
    const Fraction t = a.trace(), d = a.determinant();
    line("trace", "T = " + formula(t, a));
    line("determinant", "D = " + formula(d, a));
    const std::string at_least = unicode() ? " ≥ 0" : " >= 0", less = " " + minus() + " ";
    const std::pair<std::string, Fraction> conditions[] = {{"1" + less + "D", Fraction(1) - d},
                                                           {"1" + less + "T + D", Fraction(1) - t + d},
                                                           {"1 + T + D", Fraction(1) + t + d}};
    for (const auto& [name, value] : conditions) {
      const std::string text = print(stability_formula(value, a, StabilityLetters::products), style_);
      line(name == conditions[0].first ? "stable where" : "",
           name + (text.size() <= kWidestFormula ? " = " + text : "") + at_least);
    }
    line("", "(where one of the three is 0, an eigenvalue lies on the unit circle)");
  }

  void function() {
    if (!s_.function) return;
    const StabilityProperties& p = *s_.properties;
    section("Every linear problem y' = " + std::string(unicode() ? "λ" : "lambda") + " y with z = h " +
            (unicode() ? "λ" : "lambda") + (s_.substeps > 1 ? ", for one substep" : "") +
            ": a step multiplies y by R(z)");
    line("R(z)", formula(stability_function_formula(*s_.function)));
    std::string why;
    if (!p.poles_right) why = "it has a pole whose real part is not positive";
    if (!p.imaginary_axis && p.violated_at)
      why += (why.empty() ? "" : ", and ") + std::string("|R(i y)| > 1 at y = ") + p.violated_at->str();
    line("A-stable", p.a_stable ? "yes: all poles have positive real parts, and |R(i y)| " +
                                      std::string(unicode() ? "≤" : "<=") + " 1 for every real y"
                                : "no: " + why);
    if (p.a_stable) {
      const std::string far = algebraic_text(*s_.function->size_at_infinity(), style_);
      line("L-stable", p.l_stable ? "yes: besides, R(z) tends to 0 for large z"
                                  : "no: |R(z)| tends to " + far + " for large z");
    }
    if (p.real_axis.always()) line("real axis", "stable for every z < 0");
    for (const Window& w : p.real_axis.windows)
      if (w.to || w.from) line("real axis", "stable for " + window_text(w, minus() + "z", style_));
    if (const WindowEdge* edge = p.real_axis.limit())
      line("", "limit " + minus() + "z = " + exact_number(edge->at, style_, kShortDigits));
  }

  void runaway() {
    section("Unstable physics, k < 0: x'' = q" + squared() +
            " x, the motion itself grows like exp(q t); with s = h q");
    const Windows& w = s_.runaway;
    if (w.windows.empty())
      return line("growth", "the computed motion grows, too, for every s > 0: this growth is right");
    if (w.always()) return line("growth", "the computed motion does not grow for any s > 0: wrong");
    line("growth", "the computed motion grows, too, as is right, but");
    for (const Window& window : w.windows)
      line("wrong", "it does not grow for " + window_text(window, "s", style_));
  }

  void proof() {
    section("Proof");
    const auto count = [](int n, const std::string& what) {
      return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
    };
    const Windows& w = s_.windows;
    text_ +=
        "  What happens changes only where eigenvalues reach or leave the unit circle, or meet on it: at "
        "roots of certain polynomials\n  in z" +
        squared() + ". ";
    if (w.points == 0)
      text_ +=
          "These have no positive root, so that one rational value of z" + squared() + " decides for all.";
    else
      text_ += "These have " + count(w.points, "positive root") +
               ", isolated exactly. One rational value decides in each of the " + std::to_string(w.cells) +
               " intervals\n  between them, and each root is decided in its own number field.";
    text_ += "\n  Decided by: the test of Schur and Cohn, Sturm's sequence, the Jordan form.";
    if (s_.rounded.empty()) text_ += " No number was rounded.\n";
    for (const std::string& what : s_.rounded)
      text_ +=
          "\n  " + what + " was rounded to 100 digits; all else is exact for the number that it became.\n";
  }

  const Stability& s_;
  Style style_;
  std::string text_;
};

}  // namespace

std::string as_text(const Stability& stability, Style style) {
  return StabilityWriter(stability, style).text();
}

}  // namespace shortfall
