// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/numeric_text.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "analysis/motion/formula_text.hpp"

namespace shortfall {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShortFraction = 60;  // digits of a fraction that is still read

std::string whole(const Rational& n) {
  std::string text = n.str();
  // 10^18 is read more easily than nineteen digits.
  const std::size_t last = text.find_last_not_of('0');
  if (text.size() > 7 && last == 0) return text.substr(0, 1) + "e" + std::to_string(text.size() - 1);
  return text;
}

std::string line(const std::string& what, const CertainNumber& n, int digits, const std::string& unit) {
  const std::string head = "  " + what + " = ";
  const std::string rounded = "rounded to " + std::to_string(digits) + " digits";
  if (n.exact) {
    const std::string fraction = n.exact->str();
    const std::string decimal = n.exact->significant(digits);
    if (fraction.find('/') == std::string::npos && fraction.size() < kShortFraction)
      return head + fraction + " " + unit + "   exact\n";
    if (fraction.size() < kShortFraction)
      return head + decimal + " " + unit + "   = " + fraction + " exactly\n";
    return head + decimal + " " + unit + "   " + rounded + ", known exactly\n";
  }
  if (n.decimal) return head + *n.decimal + " " + unit + "   +- " + n.ball.radius() + "\n";
  return head + "0 to within " + n.ball.radius() + " " + unit + ": not told from 0 with " +
         std::to_string(n.ball.bits()) + " bits\n";
}

Json as_json(const CertainNumber& n, int digits) {
  if (n.exact) return n.exact->str();
  Json json{{"decimal", n.decimal ? Json(*n.decimal) : Json(nullptr)},
            {"digits", n.decimal ? digits : 0},
            {"radius", n.ball.radius()}};
  json["sign"] = n.ball.sign() ? Json(*n.ball.sign()) : Json(nullptr);
  return json;
}

}  // namespace

std::string as_text(const NumericMotion& m, const NumericQuestion& q, const std::string& integrator,
                    Style style) {
  std::string text = integrator + ", x'' = " + print(m.acceleration, style) + ", from x0 = " + q.x0.str() +
                     " m, v0 = " + q.v0.str() + " m/s\n";
  if (q.force.k && q.force.k->sign() < 0)
    text += "k < 0: unstable physics, the true motion itself runs away.\n";
  if (q.force.c && q.force.c->sign() < 0)
    text += "c < 0: a damper that drives, the true motion itself runs away.\n";
  text += whole(q.steps) + " steps of dt = " + q.h.str() + " s";
  if (q.substeps > 1) text += ", each in " + std::to_string(q.substeps) + " substeps";
  text += ": t = " + whole(m.time) + " s\n\nComputed, in exact arithmetic\n";
  text += line("x_n ", m.position, q.digits, "m") + line("v_n ", m.velocity, q.digits, "m/s");
  text += "True motion\n" + line("x(t)", m.exact_position, q.digits, "m") +
          line("v(t)", m.exact_velocity, q.digits, "m/s");
  text += "Shortfall, exact minus computed: + is too low, - too high\n";
  text += line("x(t) - x_n", m.position_shortfall, q.digits, "m") +
          line("v(t) - v_n", m.velocity_shortfall, q.digits, "m/s");
  bool rounded = false;
  for (const CertainNumber* n : {&m.position, &m.velocity, &m.exact_position, &m.exact_velocity})
    rounded = rounded || !n->exact;
  if (rounded)
    text +=
        "\nEvery digit is certain: " + std::to_string(q.digits) +
        " significant digits, the last one rounded to nearest; +- is the radius of the ball that holds the\n"
        "number. The step is a " +
        std::to_string(m.states) + " x " + std::to_string(m.states) +
        " matrix of exact numbers; its power n by repeated squaring, in balls of " + std::to_string(m.bits) +
        " bits.\n";
  for (const std::string& assumption : m.assumed) text += "Assumed: " + assumption + ".\n";
  return text;
}

nlohmann::ordered_json as_json(const NumericMotion& m, const NumericQuestion& q,
                               const std::string& integrator) {
  Json json{{"schema", "shortfall.derive/1"}, {"integrator", integrator}, {"force", q.force.text}};
  if (q.substeps != 1) json["substeps"] = q.substeps;
  json["dt"] = q.h.str();
  json["steps"] = q.steps.str();
  json["time"] = m.time.str();
  json["x0"] = q.x0.str();
  json["v0"] = q.v0.str();
  json["acceleration"] = print(m.acceleration);
  json["position"] = as_json(m.position, q.digits);
  json["velocity"] = as_json(m.velocity, q.digits);
  json["exact"] = {{"position", as_json(m.exact_position, q.digits)},
                   {"velocity", as_json(m.exact_velocity, q.digits)}};
  json["shortfall"] = {{"position", as_json(m.position_shortfall, q.digits)},
                       {"velocity", as_json(m.velocity_shortfall, q.digits)}};
  json["assumptions"] = m.assumed;
  json["bits"] = m.bits;
  return json;
}

}  // namespace shortfall
