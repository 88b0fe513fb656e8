// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/trade_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "notebooks-export/text_table.hpp"

namespace shortfall {

namespace {

std::string cost_text(const Trade& trade, const SceneOutcome& o) {
  return trade.timed ? duration_text(o.nanoseconds) : std::to_string(o.evaluations);
}

std::string step_text(const Trade& trade, const SceneOutcome& o) {
  if (o.tolerance > 0) return "tolerance " + fmt::format("{:.0e}", o.tolerance);
  return short_number(o.choice.frame) + " " + trade.scene.units.time;
}

/// Labels hold commas, so they stand in quotes.
std::string csv_quoted(const std::string& text) { return "\"" + text + "\""; }

std::string order_text(const TradeSeries& s, std::size_t observable) {
  const auto& order = s.orders[observable];
  return order ? fmt::format("{:.2f}", order->order) : "-";
}

std::string failures(const Trade& trade) {
  std::string text;
  for (const TradeSeries& s : trade.series) {
    std::string steps, why;
    std::size_t count = 0;
    for (const SceneOutcome& o : s.points) {
      if (!o.failed) continue;
      ++count;
      steps += (steps.empty() ? "" : "; ") + step_text(trade, o);
      why = o.why;
    }
    if (count == 0) continue;
    if (count == s.points.size()) steps = "every step";
    text += "  " + s.label + ", " + steps + ": " + why + "\n";
  }
  for (const auto& [label, why] : trade.refused) text += "  " + label + ": " + why + "\n";
  return text.empty() ? text : "\nFailed\n" + text;
}

nlohmann::ordered_json finite(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

std::string duration_text(double ns) {
  if (ns < 1e3) return fmt::format("{:.0f} ns", ns);
  if (ns < 1e6) return fmt::format("{:.3g} us", ns / 1e3);
  if (ns < 1e9) return fmt::format("{:.3g} ms", ns / 1e6);
  return fmt::format("{:.3g} s", ns / 1e9);
}

std::string short_number(const Rational& value) { return fmt::format("{:.6g}", value.to_double()); }

std::string error_text(double value, const std::string& unit) {
  return fmt::format("{:.3g}", value) + (unit.empty() ? "" : " " + unit);
}

CheapestPoints cheapest_points(const Trade& trade) {
  CheapestPoints table;
  table.rows = {{"", "step", "steps", "evaluations", trade.timed ? "time" : "cost"}};
  for (const SceneObservable& o : trade.scene.observables) {
    table.rows[0].push_back(o.name);
    table.rows[0].emplace_back("order");
  }
  const auto best = cheapest(trade);
  for (std::size_t s = 0; s < trade.series.size(); ++s) {
    const TradeSeries& series = trade.series[s];
    const SceneOutcome* least = nullptr;
    for (const SceneOutcome& o : series.points)
      if (o.meets(trade.scene) && (!least || cost(trade, o) < cost(trade, *least))) least = &o;
    if (!least) {
      table.unable.push_back(series.label);
      continue;
    }
    const bool is_best = best && best->series == s;
    std::vector<std::string> row{(is_best ? "* " : "  ") + series.label, step_text(trade, *least),
                                 std::to_string(least->steps), std::to_string(least->evaluations),
                                 cost_text(trade, *least)};
    for (std::size_t i = 0; i < trade.scene.observables.size(); ++i) {
      row.push_back(error_text(least->errors[i], trade.scene.observables[i].unit));
      row.push_back(order_text(series, i));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string as_text(const Trade& trade) {
  const Scene& scene = trade.scene;
  std::string text = scene.title.empty() ? scene.name : scene.title;
  text +=
      "\n  errors are exact minus computed (of places, paths and energies their size); the truth is known "
      "by " +
      trade.reference.how + "\n";
  for (std::size_t i = 0; i < scene.observables.size(); ++i) {
    const SceneObservable& o = scene.observables[i];
    text += "  " + o.name + ": tolerance " + error_text(o.tolerance.to_double(), o.unit) +
            ", the two computations of the true value differ by " +
            error_text(trade.reference.uncertain[i], o.unit) + "\n";
  }
  text += "\nThe cheapest point of each within all tolerances (* the cheapest of all)\n";
  const CheapestPoints table = cheapest_points(trade);
  text += table.rows.size() > 1 ? aligned_table(table.rows) : std::string("  none\n");
  if (!table.unable.empty()) {
    text += "\nNot within the tolerances at any step that was tried\n";
    for (const std::string& label : table.unable) text += "  " + label + "\n";
  }
  text += failures(trade);
  if (trade.timed)
    text +=
        "\n  times are processor times, the least of repeated runs of compiled code, interleaved; those of "
        "the other "
        "libraries call the "
        "same force\n";
  return text;
}

std::string as_csv(const Trade& trade) {
  std::string text =
      "series,integrator,format,launched,step,substeps,tolerance,steps,evaluations,nanoseconds,failed";
  for (const SceneObservable& o : trade.scene.observables)
    text += "," + csv_quoted(o.name + (o.unit.empty() ? "" : " / " + o.unit));
  text += "\n";
  for (const TradeSeries& s : trade.series)
    for (const SceneOutcome& o : s.points) {
      text += csv_quoted(s.label) + "," + s.integrator + "," + s.format + "," + (s.launched ? "1" : "0") +
              "," + fmt::format("{:.17g}", o.choice.frame.to_double()) + "," +
              std::to_string(o.choice.substeps) + "," + fmt::format("{:.3g}", o.tolerance) + "," +
              std::to_string(o.steps) + "," + std::to_string(o.evaluations) + "," +
              fmt::format("{:.6g}", o.nanoseconds) + "," + (o.failed ? csv_quoted(o.why) : "");
      for (std::size_t i = 0; i < trade.scene.observables.size(); ++i)
        text += "," + (o.failed ? std::string() : fmt::format("{:.9g}", o.errors[i]));
      text += "\n";
    }
  return text;
}

nlohmann::ordered_json as_json(const Trade& trade) {
  nlohmann::ordered_json j{
      {"schema", "shortfall.trade/1"}, {"scene", trade.scene.name}, {"title", trade.scene.title}};
  j["truth"] = trade.reference.how;
  for (std::size_t i = 0; i < trade.scene.observables.size(); ++i) {
    const SceneObservable& o = trade.scene.observables[i];
    nlohmann::ordered_json entry{{"name", o.name},
                                 {"unit", o.unit},
                                 {"tolerance", o.tolerance.str()},
                                 {"computations_differ_by", finite(trade.reference.uncertain[i])}};
    for (const auto& [format, floor] : trade.floors[i]) entry["floors"][format] = floor;
    for (const TradePlace& p : pareto_front(trade, i))
      entry["pareto"].push_back({{"series", p.series}, {"point", p.point}});
    j["observables"].push_back(std::move(entry));
  }
  for (const TradeSeries& s : trade.series) {
    nlohmann::ordered_json series{
        {"label", s.label}, {"integrator", s.integrator}, {"format", s.format}, {"launched", s.launched}};
    if (s.at_once > 0) series["at_once"] = s.at_once;
    for (const auto& o : s.orders)
      series["orders"].push_back(o ? nlohmann::ordered_json{{"order", o->order},
                                                            {"longest_step", o->longest},
                                                            {"shortest_step", o->shortest}}
                                   : nlohmann::ordered_json(nullptr));
    for (const SceneOutcome& o : s.points) {
      nlohmann::ordered_json point{{"step", o.choice.frame.str()},
                                   {"substeps", o.choice.substeps},
                                   {"steps", o.steps},
                                   {"evaluations", o.evaluations},
                                   {"nanoseconds", o.nanoseconds > 0 ? finite(o.nanoseconds) : nullptr}};
      if (o.tolerance > 0) point["tolerance"] = o.tolerance;
      if (o.failed)
        point["failed"] = o.why;
      else
        for (double e : o.errors) point["errors"].push_back(finite(e));
      series["points"].push_back(std::move(point));
    }
    j["series"].push_back(std::move(series));
  }
  for (const auto& [label, why] : trade.refused) j["refused"].push_back({{"label", label}, {"why", why}});
  if (const auto best = cheapest(trade))
    j["cheapest"] = {{"series", best->series}, {"point", best->point}};
  else
    j["cheapest"] = nullptr;
  return j;
}

}  // namespace shortfall
