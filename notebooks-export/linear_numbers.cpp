// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "notebooks-export/linear_text.hpp"

namespace shortfall {

namespace {

std::string shown(const CertainNumber& n) {
  return n.decimal ? *n.decimal : "0 to within " + n.ball.radius();
}

/// "v0 := 0.99 v0 - 0.02 a"
std::string line(const NumericCorrection& c) {
  std::string text = c.target + " := ";
  for (std::size_t i = 0; i < c.terms.size(); ++i) {
    const auto& [number, name] = c.terms[i];
    std::string value = shown(number);
    const bool minus = value.starts_with("-");
    if (i > 0) {
      text += minus ? " - " : " + ";
      if (minus) value.erase(0, 1);
    }
    text += value + (name.empty() ? "" : " " + name);
  }
  return c.terms.empty() ? text + "0" : text;
}

}  // namespace

std::string as_text(const KitNumbers& numbers, const LinearKit& kit, const Rational& h) {
  std::string text = "  At dt = " + h.str() + " s, every digit certain\n";
  for (const NumericCorrection& c : numbers.corrections) text += "    " + line(c) + "\n";
  if (numbers.solved) {
    text += kit.implicit->unknowns.size() == 1 ? "    a root of the equation above"
                                               : "    roots of the equations above";
    text += ": proved by an interval Newton step, and followed from small steps\n";
  }
  return text;
}

nlohmann::ordered_json as_json(const KitNumbers& numbers) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const NumericCorrection& c : numbers.corrections) {
    Json terms = Json::array();
    for (const auto& [number, name] : c.terms)
      terms.push_back({{"of", name.empty() ? Json(nullptr) : Json(name)},
                       {"decimal", number.decimal ? Json(*number.decimal) : Json(nullptr)},
                       {"radius", number.ball.radius()}});
    list.push_back({{"target", c.target}, {"terms", terms}});
  }
  return list;
}

}  // namespace shortfall
