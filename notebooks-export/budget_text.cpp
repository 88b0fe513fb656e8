// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/budget_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/algebra/general_text.hpp"
#include "notebooks-export/text_table.hpp"

namespace shortfall {

namespace {

constexpr int kBudgetDigits = 9;  // shown
constexpr int kFewDigits = 4;     // of what would be

struct BudgetScale {
  const char* unit;
  int exponent;  ///< of ten: shown = value * 10^exponent
};

/// A unit in which lengths and times are read easily.
BudgetScale scale_for(const std::vector<Budget>& budgets, std::size_t line) {
  double largest = 0;
  bool time = false;
  for (const Budget& b : budgets)
    if (line < b.lines.size()) {
      time = b.lines[line].unit == "s";
      if (!time && b.lines[line].unit != "m") return {b.lines[line].unit.c_str(), 0};
      largest = std::max(largest, std::abs(b.lines[line].observed.to_double()));
    }
  if (largest == 0 || largest >= 0.5) return {time ? "s" : "m", 0};
  if (largest >= 5e-7) return {time ? "ms" : "mm", 3};
  return {time ? "ns" : "nm", 9};
}

std::string shown(const Ball& value, const BudgetScale& scale, int digits = kBudgetDigits) {
  const Ball scaled = value * Ball(Rational(10).pow(scale.exponent), value.bits());
  if (scaled.is_zero()) return "0";
  if (const auto text = scaled.significant(digits)) return *text;
  return "0 +- " + scaled.radius();
}

/// A bound with two digits, never below it.
std::string bound_text(double bound) {
  if (bound == 0 || !std::isfinite(bound)) return bound == 0 ? "0" : "none";
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - 1);
  return general_text(std::ceil(bound / unit) * unit, 2);
}

std::string quantity_words(const Budget& b, const BudgetLine& l) {
  if (l.quantity == "peak")
    return "The highest frame (" + std::to_string(b.steps) + "), against the height asked for";
  if (l.quantity == "landing")
    return "The time of landing, between frames " + std::to_string(b.steps - 1) + " and " +
           std::to_string(b.steps) + ", against the true one";
  if (l.quantity == "period")
    return "The period, over " + (b.periods == 1 ? "one" : std::to_string(b.periods)) +
           " of them, against the true one";
  const std::string after = " after " + std::to_string(b.steps) + " steps";
  if (l.quantity == "energy") return "Energy per mass" + after;
  return l.quantity + after;
}

/// The part that is largest.
std::string largest_part(const Budget& b) {
  const BudgetTerm* largest = nullptr;
  for (const BudgetTerm& t : b.lines.front().terms)
    if (!largest || std::abs(t.value.to_double()) > std::abs(largest->value.to_double())) largest = &t;
  return largest && !largest->value.is_zero() ? largest->name : "";
}

/// What can be done about a part besides.
std::string mend(const std::string& part, const FloatQuestion& q) {
  if (part == "method") {
    const bool plain = q.force.text == "constant";
    return "a correction (shortfall correct " + q.program.name + (plain ? "" : " --force " + q.force.text) +
           "); a wider format mends nothing";
  }
  if (part == "representation") return "a step that the format holds exactly (1/64 s, 1/128 s)";
  if (part == "rounding") return "a wider format; a smaller step makes it worse";
  return "a launch that puts the peak on a frame (shortfall jump says which)";
}

/// "  method          dt = 1/100 s leaves 28.449 mm; or ..."
std::string remedies_text(const std::vector<Budget>& budgets, const BudgetScale& scale) {
  const Budget* first = nullptr;
  for (const Budget& b : budgets)
    if (!first && !b.lines.empty()) first = &b;
  if (!first) return "";
  std::string text;
  for (const BudgetTerm& t : first->lines[0].terms) {
    // Method and sampling are the same whatever the format.
    const bool of_format = t.name == "representation" || t.name == "rounding";
    std::string line;
    for (const Budget& b : budgets)
      for (const BudgetRemedy& r : b.remedies) {
        if (r.term != t.name || (!of_format && !line.empty())) continue;
        line += (line.empty() ? "" : "; ") + (of_format ? b.format.name() + ": " : "") + r.change +
                ", then " + shown(r.becomes, scale, kFewDigits) +
                (r.becomes.is_zero() ? "" : std::string(" ") + scale.unit);
      }
    const bool any = std::ranges::any_of(budgets, [&](const Budget& b) {
      return !b.lines.empty() && std::ranges::any_of(b.lines[0].terms, [&](const BudgetTerm& other) {
        return other.name == t.name && !other.value.contains_zero();
      });
    });
    if (!any) continue;
    const bool known = t.name != "sampling" || first->lines[0].quantity == "peak";
    text += "  " + t.name + std::string(16 - t.name.size(), ' ') + line;
    if (known) text += (line.empty() ? "" : "; or ") + mend(t.name, first->question);
    text += "\n";
  }
  return text.empty() ? "" : "\nWhat mends it, " + first->lines[0].quantity + "\n" + text;
}

/// "step 3, line 9: x = x + h*v"
std::string place_words(const FirstDifference::Rounding& r) {
  std::string text = r.step == 0 ? "at the start" : "in step " + std::to_string(r.step);
  if (r.read_out) text = "in what is reported after step " + std::to_string(r.step);
  if (r.line > 0) text += ", line " + std::to_string(r.line);
  return r.statement.empty() ? text : text + ": " + r.statement;
}

std::string difference_words(const Budget& b) {
  const FirstDifference& d = b.difference;
  if (!d.rounding)
    return d.compared == 0 ? ""
                           : "  " + b.format.name() + ": no rounding at all in the first " +
                                 std::to_string(d.compared) + " steps\n";
  std::string text = "  " + b.format.name() + ": the first rounding is " + place_words(*d.rounding);
  if (d.reported && *d.reported != d.rounding->step)
    text += "; x and v show none before step " + std::to_string(*d.reported);
  return text + "\n";
}

std::string tracked_words(const Budget& b) {
  if (!b.tracked) return "";
  const double tracked = b.tracked->first;
  std::string text = "  " + b.format.name() + ": rounding of x as tracked beside the run, ";
  text += general_text(tracked, 6) + " m";
  if (b.lines.empty()) return text + "\n";
  const auto exact = std::ranges::find(b.lines[0].terms, "rounding", &BudgetTerm::name);
  if (exact == b.lines[0].terms.end()) return text + "\n";
  const double off = (exact->value - Ball(Rational::from_double(tracked), exact->value.bits())).to_double();
  if (off == 0) return text + ": exactly the part above\n";
  const double digits = std::floor(-std::log10(std::abs(off / exact->value.to_double())));
  return text + ": the part above to " + std::to_string(static_cast<int>(std::max(digits, 0.0))) +
         " digits\n";
}

nlohmann::ordered_json as_json(const std::optional<FirstDifference::Rounding>& r) {
  if (!r) return nullptr;
  return {{"step", r->step}, {"line", r->line}, {"statement", r->statement}, {"read_out", r->read_out}};
}

nlohmann::ordered_json as_json(const Ball& b) {
  if (b.is_exact()) {
    const Rational exact = b.midpoint();
    if (exact.digits() < 80) return exact.str();
  }
  const auto decimal = b.significant(30);
  return {{"decimal", decimal ? nlohmann::ordered_json(*decimal) : nlohmann::ordered_json(nullptr)},
          {"radius", b.radius()}};
}

nlohmann::ordered_json as_json(const FloatNumber& n) {
  if (!n.is_finite()) return n.str(1);
  return {{"exact", n.value.str()}, {"decimal", n.value.significant(20)}};
}

}  // namespace

std::string as_text(const std::vector<Budget>& budgets, const std::string& about) {
  std::string text = about + "\n  parts are exact minus computed: positive means that the run is too low\n";
  std::size_t lines = 0;
  for (const Budget& b : budgets) lines = std::max(lines, b.lines.size());
  for (std::size_t i = 0; i < lines; ++i) {
    const BudgetScale scale = scale_for(budgets, i);
    std::vector<std::vector<std::string>> rows;
    std::string head;
    for (const Budget& b : budgets) {
      if (i >= b.lines.size()) continue;
      const BudgetLine& l = b.lines[i];
      if (rows.empty()) {
        head = quantity_words(b, l) + ", in " + scale.unit;
        rows.push_back({"format", "observed"});
        for (const BudgetTerm& t : l.terms) rows[0].push_back(t.name);
        if (l.quantity == "x") rows[0].push_back("rounding at most");
      }
      std::vector<std::string> row{b.format.name(), shown(l.observed, scale)};
      for (const BudgetTerm& t : l.terms) row.push_back(shown(t.value, scale));
      if (l.quantity == "x") {
        row.push_back(b.rounding_bound ? bound_text(*b.rounding_bound * std::pow(10.0, scale.exponent))
                                       : "-");
      }
      rows.push_back(std::move(row));
    }
    text += "\n" + head + "\n" + aligned_table(rows);
  }
  text += "\n";
  for (const Budget& b : budgets) {
    text += difference_words(b);
    if (b.not_finite_at) {
      text += "  " + b.format.name() + ": no longer a finite number from step " +
              std::to_string(*b.not_finite_at) + " on; there is no budget\n";
      continue;
    }
    text += tracked_words(b);
    if (!b.reason.empty()) text += "  " + b.format.name() + ": no other part is known: " + b.reason + "\n";
    for (const BudgetLine& l : b.lines)
      if (!l.closes())
        text += "  " + b.format.name() + ", " + l.quantity +
                ": the parts were not found narrowly enough; residual within " + l.residual.radius() + "\n";
  }
  for (const char* part : {"method", "representation", "rounding", "sampling"}) {
    std::string formats;
    for (const Budget& b : budgets)
      if (!b.lines.empty() && largest_part(b) == part)
        formats += (formats.empty() ? "" : ", ") + b.format.name();
    if (!formats.empty()) text += "  " + formats + ": most of it is " + part + "\n";
  }
  const bool all = std::ranges::all_of(budgets, [](const Budget& b) {
    if (!b.reason.empty()) return false;
    return b.not_finite_at || std::ranges::all_of(b.lines, [](const BudgetLine& l) { return l.closes(); });
  });
  if (all && lines > 0)
    text +=
        "  the parts add up to what is observed: the residual holds 0 and is narrower than 1e-40 of it; the "
        "digits shown are certain\n";
  return text + remedies_text(budgets, scale_for(budgets, 0));
}

nlohmann::ordered_json as_json(const std::vector<Budget>& budgets) {
  nlohmann::ordered_json json{{"schema", "shortfall.budget/1"}};
  if (!budgets.empty()) {
    const FloatQuestion& q = budgets[0].question;
    json["integrator"] = q.program.name;
    json["force"] = q.force.text;
    json["dt"] = q.h.str();
  }
  json["budgets"] = nlohmann::ordered_json::array();
  for (const Budget& b : budgets) {
    nlohmann::ordered_json one{{"format", b.format.name()}, {"steps", b.steps}};
    one["not_finite_at"] =
        b.not_finite_at ? nlohmann::ordered_json(*b.not_finite_at) : nlohmann::ordered_json(nullptr);
    one["quantities"] = nlohmann::ordered_json::array();
    for (const BudgetLine& l : b.lines) {
      nlohmann::ordered_json quantity{{"quantity", l.quantity},
                                      {"unit", l.unit},
                                      {"computed", as_json(l.computed)},
                                      {"truth", as_json(l.truth)},
                                      {"observed", as_json(l.observed)}};
      for (const BudgetTerm& t : l.terms) quantity[t.name] = as_json(t.value);
      quantity["residual"] = as_json(l.residual);
      quantity["closes"] = l.closes();
      one["quantities"].push_back(std::move(quantity));
    }
    if (b.periods > 0) one["periods"] = b.periods;
    one["remedies"] = nlohmann::ordered_json::array();
    for (const BudgetRemedy& r : b.remedies)
      one["remedies"].push_back({{"term", r.term}, {"change", r.change}, {"becomes", as_json(r.becomes)}});
    one["rounding_bound"] =
        b.rounding_bound ? nlohmann::ordered_json(*b.rounding_bound) : nlohmann::ordered_json(nullptr);
    if (!b.reason.empty()) one["reason"] = b.reason;
    one["rounding_tracked"] =
        b.tracked ? nlohmann::ordered_json{{"x", b.tracked->first}, {"v", b.tracked->second}} : nullptr;
    one["compared_steps"] = b.difference.compared;
    one["differs_at"] = b.difference.reported ? nlohmann::ordered_json(*b.difference.reported) : nullptr;
    one["first_rounding"] = as_json(b.difference.rounding);
    json["budgets"].push_back(std::move(one));
  }
  return json;
}

namespace {

/// Names that fit above a bar.
std::string short_name(const std::string& part) { return part == "representation" ? "storing" : part; }

}  // namespace

Figure budget_figure(const std::vector<Budget>& budgets, const std::string& title) {
  Figure figure;
  figure.title = title;
  const BudgetScale scale = scale_for(budgets, 0);
  const double factor = std::pow(10.0, scale.exponent);
  for (const Budget& b : budgets) {
    if (b.lines.empty()) continue;
    const BudgetLine& l = b.lines[0];
    Figure::Panel panel;
    panel.title = b.format.words();
    panel.note = "exact minus computed; the last is their sum";
    panel.y.label = l.quantity == "peak"                                ? "too low by"
                    : l.quantity == "landing" || l.quantity == "period" ? l.quantity + " too short by"
                                                                        : "shortfall of " + l.quantity;
    panel.y.unit = scale.unit;
    panel.x.low = 0;
    panel.x.high = static_cast<double>(l.terms.size()) + 1;
    double level = 0, low = 0, high = 0;
    const auto bar = [&](double at, double from, double to, Figure::Ink ink, const std::string& name,
                         const Ball& value) {
      panel.regions.push_back(
          {{{{at + 0.15, from}, {at + 0.85, from}, {at + 0.85, to}, {at + 0.15, to}, {at + 0.15, from}}},
           ink,
           0.6});
      low = std::min({low, from, to});
      high = std::max({high, from, to});
      const Figure::Point top{at + 0.5, std::max(from, to)};
      panel.labels.push_back({top, name, Figure::Ink::black, Figure::Align::centre, 1.9});
      panel.labels.push_back(
          {top, general_text(value.to_double() * factor, 3), Figure::Ink::dark, Figure::Align::centre, 0.7});
    };
    constexpr std::array<Figure::Ink, 4> kInks{Figure::Ink::sky, Figure::Ink::orange, Figure::Ink::green,
                                               Figure::Ink::vermillion};
    for (std::size_t i = 0; i < l.terms.size(); ++i) {
      const double next = level + l.terms[i].value.to_double() * factor;
      bar(static_cast<double>(i), level, next, kInks[i % kInks.size()], short_name(l.terms[i].name),
          l.terms[i].value);
      level = next;
    }
    bar(static_cast<double>(l.terms.size()), 0, level, Figure::Ink::grey, "observed", l.observed);
    const double room = 0.12 * std::max(high - low, 1e-300);
    panel.y.low = low - room;
    panel.y.high = high + 2 * room;
    panel.curves.push_back({{{{panel.x.low, 0}, {panel.x.high, 0}}}, Figure::Ink::dark, 1, false});
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

}  // namespace shortfall
