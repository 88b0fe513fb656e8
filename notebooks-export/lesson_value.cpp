// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/lesson_value.hpp"

#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/damping_report.hpp"
#include "analysis/correction/jump.hpp"
#include "analysis/correction/kit.hpp"
#include "analysis/floating/clock.hpp"
#include "analysis/motion/faulhaber.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/series/step_series.hpp"
#include "analysis/stability/stability.hpp"
#include "notebooks-export/example_setting.hpp"
#include "notebooks-export/modified_text.hpp"
#include "notebooks-export/notebook_document.hpp"
#include "notebooks-export/python_expression.hpp"
#include "notebooks-export/python_step.hpp"

namespace shortfall {

namespace {

/// The words of a substitution: what is asked, arguments in order, and NAME=VALUE.
struct Words {
  std::vector<std::string> plain;
  Values given;

  const std::string& at(std::size_t i) const {
    if (i >= plain.size()) throw BadInput("'" + plain.front() + "' wants more words");
    return plain[i];
  }
  int count(std::size_t i) const { return static_cast<int>(Rational::parse(at(i)).to_double()); }
};

Words split(const std::string& text) {
  Words words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos)
      words.plain.push_back(word);
    else
      words.given[word.substr(0, sign)] = Rational::parse(word.substr(sign + 1));
  }
  if (words.plain.empty()) throw BadInput("there is no word in it");
  return words;
}

/// One of several words, or a complaint with a suggestion.
template <class Value>
Value chosen(const std::string& word, const std::vector<std::pair<std::string, Value>>& from) {
  std::vector<std::string> names;
  for (const auto& [name, value] : from) {
    if (name == word) return value;
    names.push_back(name);
  }
  throw BadInput("unknown word '" + word + "'" + did_you_mean(word, names));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// step INTEGRATOR [FUNCTION]: def FUNCTION(x, v, ..., t, h, a): one step; FUNCTION_start where it needs one.
std::string step(const Words& w) {
  const Program program = find_integrator(w.at(1));
  const PythonStep python(program, w.given, 1, PythonUse::alone);
  const std::string name = w.plain.size() > 2 ? w.plain[2] : replaced(program.name, "-", "_");
  std::string text = python.functions();
  text = replaced(text, "def start(", "def " + name + "_start(");
  text = replaced(text, "def step(", "def " + name + "(");
  text = replaced(text, "def finish(", "def " + name + "_finish(");
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

/// solver INTEGRATOR: what an implicit step calls for its stages.
std::string solver(const Words& w) {
  std::string text = PythonStep(find_integrator(w.at(1)), w.given, 1, PythonUse::alone).solver();
  if (text.empty()) throw BadInput("this step is explicit and solves nothing");
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

std::string program(const Words& w) {
  Program bare = find_integrator(w.at(1));
  bare.description.clear();
  bare.aliases.clear();
  bare.sources.clear();
  bare.claims.clear();
  std::string text = print(bare);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

std::string sources(const Words& w) {
  std::string text;
  for (const std::string& source : find_integrator(w.at(1)).sources)
    text += (text.empty() ? "" : "; ") + markdown_escaped(source);
  return text;
}

/// jump INTEGRATOR HEIGHT WHAT PLACES: a number of a jump, metres; WHAT:cm and WHAT:mm for other units.
std::string jump_number(const Words& w) {
  const Jump j = jump(find_integrator(w.at(1)),
                      {Rational::parse(w.at(2)), kExampleFrame, kExampleGravity, 1, w.given, 0});
  std::string what = w.at(3);
  Surd scale(1);
  for (const auto& [ending, factor] : {std::pair{std::string(":cm"), 100}, {std::string(":mm"), 1000}}) {
    if (!what.ends_with(ending)) continue;
    scale = Surd(factor);
    what.resize(what.size() - ending.size());
  }
  if (what == "frame") return j.best_frame.n.str();
  const auto corrected = [&]() -> const Jump::Corrected& {
    if (!j.corrected) throw BadInput("this jump has no correction");
    return *j.corrected;
  };
  const auto value =
      chosen<std::function<Surd()>>(what, {{"launch", [&] { return j.launch_velocity; }},
                                           {"peak", [&] { return j.best_frame.height; }},
                                           {"short", [&] { return j.shortfall.total; }},
                                           {"method", [&] { return j.shortfall.method; }},
                                           {"sampling", [&] { return j.shortfall.sampling; }},
                                           {"ideal", [&] { return j.ideal_time_height.value(); }},
                                           {"top", [&] { return j.parabola_top.value(); }},
                                           {"corrected-launch", [&] { return corrected().launch; }},
                                           {"corrected-short", [&] { return corrected().shortfall.total; }},
                                           {"on-frame", [&] {
                                              if (!j.on_frame) throw BadInput(j.no_on_frame);
                                              return Surd(j.on_frame->launch);
                                            }}});
  return (scale * value()).decimal(w.count(4));
}

/// derive INTEGRATOR DEGREE WHAT: a formula in LaTeX.
std::string formula_of(const Words& w) {
  const Derivation d = derivation(find_integrator(w.at(1)), w.count(2), w.given, 1, false);
  const Expr e = chosen<Expr>(w.at(3), {{"position", d.position},
                                        {"velocity", d.velocity},
                                        {"shortfall", d.shortfall_position},
                                        {"shortfall-velocity", d.shortfall_velocity}});
  const std::string text = inlined(e);
  return text.substr(1, text.size() - 2);
}

/// powers M: 1^m + ... + n^m as a polynomial in n, in LaTeX;  powers M list: its coefficients in Python.
std::string powers(const Words& w) {
  const int m = w.count(1);
  if (m < 1 || m > 60) throw BadInput("sums of powers 1 to 60");
  std::vector<Rational> c = power_sums(m).back();
  c.resize(static_cast<std::size_t>(m) + 2);
  c[static_cast<std::size_t>(m)] = c[static_cast<std::size_t>(m)] + Rational(1);  // that of 0 .. n-1, and n^m
  if (w.plain.size() > 2) {
    std::string text;
    for (const Rational& value : c)
      text += (text.empty() ? "[" : ", ") + std::string("Fraction(") + value.numerator().str() + ", " +
              value.denominator().str() + ")";
    return text + "]";
  }
  Expr sum;
  for (std::size_t k = c.size(); k-- > 0;) {
    if (c[k].is_zero()) continue;
    const Rational size = c[k].abs();
    const Expr n =
        k == 1 ? name("n") : binary(Expression::Op::power, name("n"), number(Rational(static_cast<int>(k))));
    const Expr term = size == Rational(1) ? n : binary(Expression::Op::multiply, number(size), n);
    if (!sum)
      sum = term;
    else
      sum = binary(c[k].sign() < 0 ? Expression::Op::subtract : Expression::Op::add, sum, term);
  }
  return print(sum, Style::latex);
}

std::string letters_of_oscillator(const Fraction& f, const Amplification& a) {
  Wording wording;
  wording.letters = a.letters;
  for (std::string& letter : wording.letters)
    if (letter == "k") letter = "y";
  return print(formula(f, wording), Style::latex);
}

/// stability INTEGRATOR WHAT: trace and determinant with y = h^2 k, the limit of h w, x_n and v_n there.
std::string stability_of(const Words& w) {
  const Stability s = stability(find_integrator(w.at(1)), w.given);
  const std::string& what = w.at(2);
  if (what == "trace") return letters_of_oscillator(s.undamped.trace(), s.undamped);
  if (what == "determinant") return letters_of_oscillator(s.undamped.determinant(), s.undamped);
  if (what == "limit") {
    if (!s.limit()) return "0";
    const Ball limit = ball(*s.limit(), 200);
    return limit.significant(w.plain.size() > 3 ? w.count(3) : 10).value_or(limit.midpoint().significant(10));
  }
  if (!s.limit_motion) throw BadInput("its motion at the limit is no formula");
  const Expr e = chosen<Expr>(
      what, {{"position-there", s.limit_motion->position}, {"velocity-there", s.limit_motion->velocity}});
  return print(e, Style::latex);
}

/// modified INTEGRATOR ORDER: the lines of the modified equation in LaTeX.
std::string modified_lines(const Words& w) {
  const SeriesSource source(find_integrator(w.at(1)), w.given);
  const ModifiedEquation m = modified_equation(source, &force_class("a(x)"), w.count(2));
  std::istringstream lines(as_text(m, source, Style::latex));
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("\\dot")) {
      const std::size_t equals = line.find(" =");
      text += (text.empty() ? "" : " \\\\\n") + line.substr(0, equals) + " &" + line.substr(equals + 1);
    }
  return "\\begin{aligned}\n" + text + "\n\\end{aligned}";
}

/// clock DT STEPS WHAT [DIGITS]: what an accumulator in binary32 holds, is short by, and where it stops.
std::string clock_number(const Words& w) {
  ClockQuestion question;
  question.dt = Rational::parse(w.at(1));
  question.additions = Rational::parse(w.at(2));
  const ClockReport r = clock_report(question);
  if (!r.freezes) throw BadInput("this clock does not stop");
  const Rational value = chosen<Rational>(w.at(3), {{"value", r.value.value()},
                                                    {"short", r.shortfall.value()},
                                                    {"stops-at", r.freezes->value},
                                                    {"stops-after", r.freezes->additions}});
  return w.plain.size() > 4 ? value.decimal(w.count(4)) : value.str();
}

/// damping INTEGRATOR WHAT NAME=VALUE: a formula in LaTeX, or a number at 50 frames a second.
std::string damping_of(const Words& w) {
  const DampingReport r = damping_report(find_integrator(w.at(1)), w.given, kExampleFrame, kExampleGravity);
  const std::string& what = w.at(2);
  const std::vector<std::pair<std::string, Expr>> formulas{
      {"share-formula", r.share}, {"terminal-formula", r.terminal}, {"coast-formula", r.coast}};
  for (const auto& [name, e] : formulas)
    if (name == what) return print(e, Style::latex);
  const Ball value = chosen<Ball>(what, {{"share", r.here.share},
                                         {"kept", r.here.kept},
                                         {"terminal", r.here.terminal},
                                         {"coast", r.here.coast}});
  const int digits = w.count(3);
  return value.is_zero() ? "0" : value.significant(digits).value_or(value.midpoint().significant(digits));
}

}  // namespace

std::string lesson_value(const std::string& words) {
  const Words w = split(words);
  return chosen<std::string (*)(const Words&)>(w.plain.front(), {{"step", step},
                                                                 {"solver", solver},
                                                                 {"program", program},
                                                                 {"sources", sources},
                                                                 {"jump", jump_number},
                                                                 {"derive", formula_of},
                                                                 {"powers", powers},
                                                                 {"stability", stability_of},
                                                                 {"modified", modified_lines},
                                                                 {"clock", clock_number},
                                                                 {"damping", damping_of}})(w);
}

}  // namespace shortfall
