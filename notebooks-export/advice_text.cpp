// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/advice_text.hpp"

#include <cmath>

#include "analysis/algebra/comma_list.hpp"
#include "notebooks-export/text_table.hpp"
#include "notebooks-export/trade_text.hpp"

namespace shortfall {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string way(const Advice& a, const SceneOutcome& o) {
  const std::string unit = a.scene.units.time;
  std::string text = o.choice.label() + ", dt = " + short_number(o.choice.frame) + " " + unit;
  if (o.choice.substeps > 1)
    text += " in " + std::to_string(o.choice.substeps) + " substeps of " +
            short_number(o.choice.frame / Rational(o.choice.substeps)) + " " + unit;
  return text;
}

std::string costs(const SceneOutcome& o) {
  return std::to_string(o.evaluations) + " evaluations of the force" +
         (o.nanoseconds > 0 ? ", " + duration_text(o.nanoseconds) : std::string());
}

std::string forces(const Advice& a) {
  std::vector<std::string> kept, left_out;
  for (std::size_t i = 0; i < a.effects.size(); ++i) {
    const ForceEffect& e = a.effects[i];
    if (!e.dropped) {
      kept.push_back(e.name + (a.scene.forces[i].by_engine && !a.scene.budget.integrator.empty()
                                   ? " (the engine does it)"
                                   : ""));
      continue;
    }
    std::size_t worst = 0;
    for (std::size_t o = 1; o < e.changes.size(); ++o)
      if (e.changes[o] / a.scene.observables[o].tolerance.to_double() >
          e.changes[worst] / a.scene.observables[worst].tolerance.to_double())
        worst = o;
    left_out.push_back(e.name + " (" + a.scene.observables[worst].name + " changes by " +
                       error_text(e.changes[worst], a.scene.observables[worst].unit) + ")");
  }
  return comma_list(kept) + (left_out.empty() ? "" : "; leave out " + comma_list(left_out));
}

std::string left(const Advice& a, const SceneOutcome& o) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < o.errors.size(); ++i) {
    const SceneObservable& seen = a.scene.observables[i];
    words.push_back(seen.name + " " + error_text(o.errors[i], seen.unit) + " (allowed " +
                    error_text(seen.tolerance.to_double(), seen.unit) + ")");
  }
  return comma_list(words);
}

std::string against_naive(const Advice& a) {
  if (!a.naive)
    return "  The usual choice, " + a.scene.naive +
           " with substeps, is not good enough with any number that was tried.\n";
  const double ratio =
      a.naive->nanoseconds > 0 && a.best->nanoseconds > 0
          ? a.naive->nanoseconds / a.best->nanoseconds
          : static_cast<double>(a.naive->evaluations) / static_cast<double>(a.best->evaluations);
  const std::string text = "  The usual choice, " + way(a, *a.naive) + ": " + costs(*a.naive);
  if (ratio > 1.02) return text + ": " + Rational::from_double(ratio).significant(2) + " times as much.\n";
  if (a.naive->choice.label() == a.best->choice.label() && ratio > 0.9)
    return text + ": the advice is that choice.\n";
  return text + ": the advice does not beat it.\n";
}

std::string tables(const Advice& a) {
  const Scene& scene = a.scene;
  std::string text = "\nWhat each force does: the change of the true motion when it is left out\n";
  Rows rows{{"force"}};
  for (const SceneObservable& o : scene.observables) rows[0].push_back(o.name);
  rows[0].emplace_back("");
  for (const ForceEffect& e : a.effects) {
    std::vector<std::string> row{e.name};
    for (std::size_t i = 0; i < scene.observables.size(); ++i)
      row.push_back(e.changes.empty() ? "-" : error_text(e.changes[i], scene.observables[i].unit));
    row.emplace_back(e.dropped ? "left out" : "kept");
    rows.push_back(std::move(row));
  }
  std::vector<std::string> tolerances{"tolerance"};
  for (const SceneObservable& o : scene.observables)
    tolerances.push_back(error_text(o.tolerance.to_double(), o.unit));
  tolerances.emplace_back("");
  rows.push_back(std::move(tolerances));
  text += aligned_table(rows);
  for (const ForceEffect& e : a.effects)
    if (e.changes.empty()) text += "  without " + e.name + ": " + e.without + "\n";

  if (!a.considered.empty()) {
    text +=
        "\nWhat is good enough, the cheapest first (" + std::to_string(a.tried) + " runs were looked at)\n";
    rows = {{"", "dt", "substeps", "evaluations", "time"}};
    for (const SceneObservable& o : scene.observables) rows[0].push_back(o.name);
    for (const SceneOutcome& o : a.considered) {
      std::vector<std::string> row{o.choice.label(), short_number(o.choice.frame) + " " + scene.units.time,
                                   std::to_string(o.choice.substeps), std::to_string(o.evaluations),
                                   o.nanoseconds > 0 ? duration_text(o.nanoseconds) : "-"};
      for (std::size_t i = 0; i < scene.observables.size(); ++i)
        row.push_back(error_text(o.errors[i], scene.observables[i].unit));
      rows.push_back(std::move(row));
    }
    text += aligned_table(rows);
  }
  if (!a.errors.empty()) {
    text += "\nThe parts of the error that is left, exact minus computed (of places and paths their sizes)\n";
    rows = {{"", "total", "forces left out", "method", "rounding"}};
    for (std::size_t i = 0; i < a.errors.size(); ++i) {
      const std::string& unit = scene.observables[i].unit;
      rows.push_back({scene.observables[i].name, error_text(a.errors[i].total, unit),
                      error_text(a.errors[i].modelling, unit), error_text(a.errors[i].method, unit),
                      error_text(a.errors[i].rounding, unit)});
    }
    text += aligned_table(rows);
  }
  return text;
}

nlohmann::ordered_json outcome_json(const SceneOutcome& o) {
  nlohmann::ordered_json j{{"integrator", o.choice.integrator}, {"format", o.choice.format},
                           {"launched", o.choice.launched},     {"dt", o.choice.frame.str()},
                           {"substeps", o.choice.substeps},     {"steps", o.steps},
                           {"evaluations", o.evaluations}};
  j["nanoseconds"] =
      o.nanoseconds > 0 ? nlohmann::ordered_json(o.nanoseconds) : nlohmann::ordered_json(nullptr);
  j["errors"] = o.errors;
  return j;
}

}  // namespace

std::string as_text(const Advice& a, bool why) {
  std::string text = (a.scene.title.empty() ? a.scene.name : a.scene.title) + "\n";
  if (!a.best) {
    text += "  Nothing that was tried meets all tolerances with a margin of " +
            short_number(Rational::from_double(a.margin)) + ".\n";
    if (a.closest)
      text += "  Closest      " + way(a, *a.closest) + "; " + costs(*a.closest) + "\n  What is left " +
              left(a, *a.closest) + "\n";
    return why ? text + tables(a) : text;
  }
  text += "  Step it      " + way(a, *a.best) + "; " + costs(*a.best) + "\n";
  text += "  Model        " + forces(a) + "\n";
  text += "  What is left " + left(a, *a.best) + "\n";
  text += against_naive(a);
  text += "  Errors are exact minus computed, seen in this run against the true motion (" + a.reference.how +
          "), and at most 1/" + short_number(Rational::from_double(a.margin)) + " of what is allowed.\n";
  return why ? text + tables(a) : text;
}

nlohmann::ordered_json as_json(const Advice& a) {
  nlohmann::ordered_json j{{"schema", "shortfall.advise/1"}, {"scene", a.scene.name}, {"margin", a.margin}};
  for (std::size_t i = 0; i < a.scene.observables.size(); ++i) {
    const SceneObservable& o = a.scene.observables[i];
    j["observables"].push_back({{"name", o.name}, {"unit", o.unit}, {"tolerance", o.tolerance.str()}});
  }
  for (const ForceEffect& e : a.effects) {
    nlohmann::ordered_json entry{{"name", e.name}, {"dropped", e.dropped}};
    if (e.changes.empty())
      entry["without"] = e.without;
    else
      entry["changes"] = e.changes;
    j["forces"].push_back(std::move(entry));
  }
  j["best"] = a.best ? outcome_json(*a.best) : nlohmann::ordered_json(nullptr);
  for (const AdviceError& e : a.errors)
    j["errors"].push_back(
        {{"total", e.total}, {"modelling", e.modelling}, {"method", e.method}, {"rounding", e.rounding}});
  j["naive"] = a.naive ? outcome_json(*a.naive) : nlohmann::ordered_json(nullptr);
  j["closest"] = !a.best && a.closest ? outcome_json(*a.closest) : nlohmann::ordered_json(nullptr);
  for (const SceneOutcome& o : a.considered) j["considered"].push_back(outcome_json(o));
  j["tried"] = a.tried;
  return j;
}

}  // namespace shortfall
