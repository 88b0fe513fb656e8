// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/damping_text.hpp"

#include <nlohmann/json.hpp>

#include "notebooks-export/text_table.hpp"

namespace shortfall {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDampingDigits = 8;  // digits of a number in a text
constexpr int kDampingDigitsInJson = 30;

std::string digits(const Ball& b, int count = kDampingDigits) {
  if (b.is_zero()) return "0";
  return b.significant(count).value_or(b.midpoint().significant(count));
}

std::string about(const Ball& b, Style style) {
  return std::string(style == Style::language ? "~ " : "≈ ") + digits(b);
}

std::string given(const DampingReport& r) {
  std::string text;
  for (const auto& [name, value] : r.parameters)
    if (mentions(r.share, name) || (r.solves && mentions(r.solves, name)))
      text += ", " + name + " = " + value.str();
  return text;
}

std::string percent(const Ball& value, const Ball& reference) {
  const Ball relative = (value / reference - Ball(1, value.bits())) * Ball(100, value.bits());
  if (relative.contains_zero()) return "equal";
  const std::string text = digits(relative, 4);
  return (text.starts_with('-') ? "" : "+") + text + " %";
}

std::string stop(const DampingReport& r) {
  if (r.here.share.sign() == 1) return "";
  if (r.here.share.is_zero())
    return "\nStops dead\n  One frame takes the whole velocity away: what it leaves of v is 0.\n";
  const bool grows = (Ball(1, r.here.share.bits()) + r.here.share).sign() == -1;
  return std::string("\nTurns round\n  One frame reverses the velocity") +
         (grows ? " and makes it larger: the motion explodes.\n" : ": what it leaves of v is negative.\n");
}

Json ball_json(const Ball& b) {
  return {
      {"decimal", digits(b, kDampingDigitsInJson)}, {"digits", kDampingDigitsInJson}, {"radius", b.radius()}};
}

Json rate_json(const DampingAtRate& r) {
  return {{"dt", r.h.str()},
          {"share", ball_json(r.share)},
          {"kept_after_1s", ball_json(r.kept)},
          {"rate", r.rate ? ball_json(*r.rate) : Json(nullptr)},
          {"terminal_speed", ball_json(r.terminal)},
          {"coast", ball_json(r.coast)}};
}

}  // namespace

std::string as_text(const DampingReport& r, Style style) {
  std::string text =
      r.integrator + given(r) + ", dt = " + r.here.h.str() + " s, g = " + r.g.str() + " m/s^2\n";
  if (r.solves)
    text += "It is meant for x'' = " + print(r.solves, style) + ".\n";
  else
    text += "It names no equation of motion for its damping.\n";
  text += "\nFormulas, exact";
  for (std::size_t i = 0; i < r.assumptions.size(); ++i) text += (i ? ", " : " where ") + r.assumptions[i];
  if (!r.assumed_hold) text += "; NOT SO for these numbers, which are the step's own";
  text += "\n  one frame leaves of v      " + print(r.share, style) + "\n  terminal speed             " +
          print(r.terminal, style) + "\n  a body coasts, for 1 m/s   " + print(r.coast, style) + "\n";
  text += "\nAt this frame time\n  one frame leaves of v      " + about(r.here.share, style) +
          "\n  left of v after 1 s        " + about(r.here.kept, style) + "\n";
  if (r.here.rate) {
    text += "  equivalent to exp(-c t)    c " + about(*r.here.rate, style) + " 1/s";
    if (r.true_rate)
      text += "; its equation has " + digits(*r.true_rate) + " 1/s: " + percent(*r.here.rate, *r.true_rate);
    text += "\n";
  }
  text += "  terminal speed             " + about(r.here.terminal, style) + " m/s";
  if (r.true_terminal)
    text += "; its equation has " + digits(*r.true_terminal) +
            " m/s: " + percent(r.here.terminal, *r.true_terminal);
  text += "\n  a body coasts, for 1 m/s   " + about(r.here.coast, style) + " m";
  if (r.true_rate && r.true_rate->sign() == 1) {
    const Ball true_coast = Ball(1, r.here.coast.bits()) / *r.true_rate;
    text += "; its equation has " + digits(true_coast) + " m: " + percent(r.here.coast, true_coast);
  }
  text += "\n" + stop(r);
  text +=
      "\nThe same number at other rates\n  rate      left after 1 s   terminal speed   coasts, for 1 m/s\n";
  for (const DampingAtRate& rate : r.rates)
    text += "  " + padded((Rational(1) / rate.h).str() + " Hz", 8) + "  " + padded(digits(rate.kept), 15) +
            "  " + padded(digits(rate.terminal) + " m/s", 15) + "  " + digits(rate.coast) + " m\n";
  if (r.here.share.sign() == 1) {
    text += "\nThe same decay at this frame time, in other conventions\n";
    for (int i = 0; i < kDampingConventions; ++i) {
      const auto c = static_cast<DampingConvention>(i);
      text += "  " + padded(name_of(c) + ", " + print(share_of(c), style), 30) + " c " +
              about(damping_number(c, r.here.share, r.here.h), style) + "\n";
    }
  }
  text +=
      "\nThe same at every rate: v and x of the exact motion, with --lang\n"
      "  x := x + q v + (h - q)/c a, v := exp(-c h) v + q a, q = (1 - exp(-c h))/c\n";
  return text;
}

Json as_json(const DampingReport& r) {
  Json json{{"schema", "shortfall.damping/1"}, {"integrator", r.integrator}};
  if (r.substeps != 1) json["substeps"] = r.substeps;
  json["parameters"] = Json::object();
  for (const auto& [name, value] : r.parameters) json["parameters"][name] = value.str();
  json["g"] = r.g.str();
  json["solves"] = r.solves ? Json(print(r.solves)) : Json(nullptr);
  json["formulas"] = {
      {"share", print(r.share)}, {"terminal_speed", print(r.terminal)}, {"coast", print(r.coast)}};
  json["assumptions"] = r.assumptions;
  json["assumptions_hold"] = r.assumed_hold;
  json["here"] = rate_json(r.here);
  json["true_rate"] = r.true_rate ? ball_json(*r.true_rate) : Json(nullptr);
  json["true_terminal_speed"] = r.true_terminal ? ball_json(*r.true_terminal) : Json(nullptr);
  json["rates"] = Json::array();
  for (const DampingAtRate& rate : r.rates) json["rates"].push_back(rate_json(rate));
  json["conventions"] = Json::array();
  for (int i = 0; i < kDampingConventions; ++i) {
    const auto from = static_cast<DampingConvention>(i);
    Json one{{"name", name_of(from)}, {"share", print(share_of(from))}};
    one["c"] =
        r.here.share.sign() == 1 ? ball_json(damping_number(from, r.here.share, r.here.h)) : Json(nullptr);
    for (int j = 0; j < kDampingConventions; ++j) {
      const auto to = static_cast<DampingConvention>(j);
      one["to"][name_of(to)] = print(converted_damping(from, to));
    }
    json["conventions"].push_back(one);
  }
  return json;
}

std::string damping_table(const std::vector<DampingReport>& reports,
                          const std::vector<std::pair<std::string, std::string>>& refused, Style style) {
  std::string text;
  if (!reports.empty())
    text += "dt = " + reports[0].here.h.str() + " s, g = " + reports[0].g.str() +
            " m/s^2; numbers are rounded\n\n";
  text += "  " + padded("integrator", 27) + padded("left after 1 s", 16) + padded("terminal speed", 16) +
          "terminal speed, exactly\n";
  for (const DampingReport& r : reports)
    text += "  " + padded(r.integrator, 27) + padded(digits(r.here.kept, 6), 16) +
            padded(digits(r.here.terminal, 6) + " m/s", 16) + print(r.terminal, style) + "\n";
  for (const auto& [name, why] : refused) text += "  " + padded(name, 27) + why + "\n";
  return text;
}

Json damping_table_json(const std::vector<DampingReport>& reports,
                        const std::vector<std::pair<std::string, std::string>>& refused) {
  Json json{{"schema", "shortfall.damping/1"}, {"integrators", Json::array()}, {"refused", Json::object()}};
  for (const DampingReport& r : reports) json["integrators"].push_back(as_json(r));
  for (const auto& [name, why] : refused) json["refused"][name] = why;
  return json;
}

}  // namespace shortfall
