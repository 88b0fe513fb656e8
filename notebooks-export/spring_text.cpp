// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/spring_text.hpp"

#include <nlohmann/json.hpp>

#include "notebooks-export/text_table.hpp"

namespace shortfall {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSpringDigits = 8;
constexpr int kSpringDigitsInJson = 30;

std::string digits_or_zero(const Ball& b, int count = kSpringDigits) {
  // A ball around 0 that is as narrow as the working precision allows.
  if (b.is_zero() || (b.contains_zero() && (abs(b) - Ball(Rational(1, 10).pow(40), b.bits())).sign() == -1))
    return "0";
  return b.significant(count).value_or(b.midpoint().significant(count));
}

std::string short_number(const Rational& value, bool rounded) {
  return rounded || value.digits() > 12 ? value.significant(kSpringDigits) : value.str();
}

std::string stability_verdict(const EffectiveSpring& e) {
  if (!e.stable) return "at the edge of stability, undecided";
  if (*e.stable) return "stable";
  // One eigenvalue of size 1 twice.
  const bool at_the_limit = (e.growth - Ball(1, e.growth.bits())).sign().value_or(0) == 0;
  return at_the_limit ? "exactly at the limit, and UNSTABLE: its swings grow by the same amount each frame"
                      : "UNSTABLE: it explodes";
}

std::string row(const char* what, const std::string& effective, const std::string& truth) {
  return "  " + padded(what, 26) + padded(effective, 22) + truth + "\n";
}

std::string optional_digits(const std::optional<Ball>& b) {
  return b ? digits_or_zero(*b) : "none: no oscillation";
}

std::string substeps(const SpringQuestion& q) {
  if (q.substeps == 1) return "";
  return ", " + std::to_string(q.substeps) + " substeps" + (q.held ? ", the force held over them" : "");
}

Json certain_json(const Ball& b) {
  return {{"decimal", digits_or_zero(b, kSpringDigitsInJson)},
          {"digits", kSpringDigitsInJson},
          {"radius", b.radius()}};
}

Json spring_json(const EffectiveSpring& e) {
  const auto optional = [](const std::optional<Ball>& b) { return b ? certain_json(*b) : Json(nullptr); };
  return {{"trace", certain_json(e.trace)},
          {"determinant", certain_json(e.determinant)},
          {"oscillates", e.oscillates},
          {"stable", e.stable ? Json(*e.stable) : Json(nullptr)},
          {"growth_per_second", certain_json(e.growth)},
          {"frequency", optional(e.frequency)},
          {"damping_ratio", optional(e.damping_ratio)}};
}

}  // namespace

std::string as_text(const SpringReport& r, const SpringReport& native, Style style) {
  const SpringQuestion& q = r.question;
  const std::string near = style == Style::language ? "~ " : "≈ ";
  std::string text = r.integrator + ", x'' = -k x - c v, k " + (q.rounded ? near : "= ") +
                     short_number(q.k, q.rounded) + " 1/s^2, c " +
                     (q.rounded && !q.c.is_zero() ? near : "= ") + short_number(q.c, q.rounded) +
                     " 1/s, dt = " + q.h.str() + " s" + substeps(q) + "\n";
  text += "It is " + stability_verdict(r.effective) +
          ".\n\nOne frame, exact\n  trace T       = " + print(r.trace, style) +
          "\n  determinant D = " + print(r.determinant, style) + "\n";
  text += "\n" + row("rounded", "this step", "the true spring");
  text += row("frequency, Hz", optional_digits(r.effective.frequency), optional_digits(r.truth.frequency));
  text += row("damping ratio", optional_digits(r.effective.damping_ratio),
              optional_digits(r.truth.damping_ratio));
  text +=
      row("amplitude after 1 s, of 1", digits_or_zero(r.effective.growth), digits_or_zero(r.truth.growth));
  text += row("T", digits_or_zero(r.effective.trace), digits_or_zero(r.truth.trace));
  text += row("D", digits_or_zero(r.effective.determinant), digits_or_zero(r.truth.determinant));
  if (r.truth.frequency &&
      (*r.truth.frequency * Ball(q.h * 2, r.truth.frequency->bits())).to_double() > 1.0000001)
    text += "  (the true spring swings faster than half the tick rate: frames show it slower than it is)\n";
  text +=
      "\nThe same spring as engines do it themselves, implicitly: v := (v - h k x)/(1 + h c + h^2 k), x := x "
      "+ h v" +
      std::string(q.substeps > 1 ? ", h = dt/" + std::to_string(q.substeps) : "") + "\n  " +
      stability_verdict(native.effective) +
      (native.effective.frequency
           ? "; frequency " + near + digits_or_zero(*native.effective.frequency) + " Hz, damping ratio " +
                 near + digits_or_zero(*native.effective.damping_ratio)
           : "; no oscillation") +
      ", amplitude after 1 s " + near + digits_or_zero(native.effective.growth) + "\n";
  if (r.kit) {
    text += "\nGive it instead, and every frame is on the true motion\n";
    for (const NumericCorrection& c : r.kit->corrections) {
      text += "  " + c.target + " := ";
      bool first = true;
      for (const auto& [value, letter] : c.terms) {
        std::string term = value.decimal.value_or(digits_or_zero(value.ball, 12));
        const bool minus = term.starts_with('-');
        if (minus) term.erase(0, 1);
        text += (first ? (minus ? "-" : "") : (minus ? " - " : " + ")) + term +
                (letter.empty() ? "" : " " + letter);
        first = false;
      }
      text += "\n";
    }
    text += "  (12 digits; the formulas and their proof: shortfall correct --force)\n";
  } else {
    text += "\nNo kit: " + r.no_kit + "\n";
  }
  return text;
}

Json as_json(const SpringReport& r, const SpringReport& native) {
  Json json{{"schema", "shortfall.spring/1"}, {"integrator", r.integrator}};
  json["k"] = r.question.rounded ? r.question.k.significant(50) : r.question.k.str();
  json["c"] = r.question.rounded ? r.question.c.significant(50) : r.question.c.str();
  json["rounded"] = r.question.rounded;
  json["dt"] = r.question.h.str();
  json["substeps"] = r.question.substeps;
  json["held"] = r.question.held;
  json["trace"] = print(r.trace);
  json["determinant"] = print(r.determinant);
  json["effective"] = spring_json(r.effective);
  json["true"] = spring_json(r.truth);
  json["native"] = {{"trace", print(native.trace)},
                    {"determinant", print(native.determinant)},
                    {"effective", spring_json(native.effective)}};
  json["kit"] = nullptr;
  if (r.kit) {
    json["kit"] = Json::array();
    for (const NumericCorrection& c : r.kit->corrections) {
      Json terms = Json::array();
      for (const auto& [value, letter] : c.terms)
        terms.push_back({{"of", letter.empty() ? Json(nullptr) : Json(letter)},
                         {"decimal", value.decimal ? Json(*value.decimal) : Json(nullptr)},
                         {"radius", value.ball.radius()}});
      json["kit"].push_back({{"target", c.target}, {"terms", terms}});
    }
  }
  json["kit_obstruction"] = r.no_kit.empty() ? Json(nullptr) : Json(r.no_kit);
  return json;
}

}  // namespace shortfall
