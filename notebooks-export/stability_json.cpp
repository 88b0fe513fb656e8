// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/stability_json.hpp"

#include "analysis/stability/isolation.hpp"
#include "analysis/stability/radicals.hpp"
#include "notebooks-export/stability_words.hpp"

namespace shortfall {

using Json = nlohmann::ordered_json;

namespace {

Json number_json(const RealRoot& r) {
  Json json;
  const auto formula = radical_formula(r);
  json["formula"] = formula ? Json(print(*formula)) : Json(nullptr);
  json["decimal"] = r.significant(kStabilityDigits);
  json["digits"] = kStabilityDigits;
  json["polynomial"] = print(polynomial_formula(r.polynomial(), "x"));
  if (r.is_rational()) {
    json["interval"] = {r.low().str(), r.low().str()};
    return json;
  }
  const Isolation between = isolation(r);
  json["interval"] = {between.low, between.high};
  return json;
}

Json growth_json(const PowerGrowth& growth) {
  using Kind = PowerGrowth::Kind;
  Json json;
  json["growth"] = growth.kind == Kind::exponential ? "exponential"
                   : growth.bounded()               ? "bounded"
                   : growth.degree == 1             ? "linear"
                                                    : "polynomial";
  json["degree"] = growth.degree;
  Json eigenvalues = Json::array();
  for (const CircleEigenvalues& e : growth.circle) {
    const char* value = e.kind == CircleEigenvalues::Kind::plus_one    ? "1"
                        : e.kind == CircleEigenvalues::Kind::minus_one ? "-1"
                                                                       : "pairs";
    Json one{{"value", value},
             {"count", e.count},
             {"multiplicity", e.multiplicity},
             {"largest_jordan_block", e.largest_block}};
    if (e.cosine) one["cosine"] = e.cosine->str();
    eigenvalues.push_back(std::move(one));
  }
  json["on_unit_circle"] = std::move(eigenvalues);
  return json;
}

Json edge_json(const std::optional<WindowEdge>& edge, bool included, bool with_growth) {
  if (!edge) return nullptr;
  Json json = number_json(edge->at);
  json["included"] = included;
  if (edge->pole)
    json["singular"] = true;
  else if (with_growth)
    json["at"] = growth_json(edge->growth);
  return json;
}

Json windows_json(const Windows& windows) {
  Json list = Json::array();
  for (const Window& w : windows.windows)
    list.push_back({{"from", edge_json(w.from, w.from_included, true)},
                    {"to", edge_json(w.to, w.to_included, true)},
                    {"decays", w.decays},
                    {"keeps", w.keeps}});
  return list;
}

/// None for no limit, 0 when no small value is stable.
Json limit_json(const Windows& windows) {
  if (!windows.from_zero()) return number_json(RealRoot(0));
  const WindowEdge* edge = windows.limit();
  return edge ? number_json(edge->at) : Json(nullptr);
}

const char* summary(const Windows& windows) {
  return windows.always()          ? "always"
         : windows.windows.empty() ? "never"
         : windows.from_zero()     ? "below limit"
                                   : "not for small steps";
}

Json at_limit_json(const Stability& s) {
  if (!s.limit()) return nullptr;
  if (!s.at_limit) return {{"growth", "singular"}};
  Json json = growth_json(*s.at_limit);
  if (s.limit_motion) {
    const LimitMotion& m = *s.limit_motion;
    json["position"] = print(m.position);
    json["velocity"] = print(m.velocity);
    json["position_bounded_if_zero"] = print(m.position_growth);
    json["velocity_bounded_if_zero"] = print(m.velocity_growth);
    json["valid_from"] = m.valid_from;
    json["proved"] = m.proved;
  }
  return json;
}

void add_amplification(Json& json, const Amplification& a) {
  const auto text = [&](const Fraction& f) {
    return print(stability_formula(f, a, StabilityLetters::factors));
  };
  json["trace"] = a.pair.empty() ? Json(nullptr) : Json(text(a.trace()));
  json["determinant"] = a.pair.empty() ? Json(nullptr) : Json(text(a.determinant()));
  json["characteristic"] = print(characteristic_formula(a, StabilityLetters::factors));
  json["zero_eigenvalues"] = a.zeros;
  json["spurious_eigenvalues"] = a.spurious_count();
}

Json drag_json(const Stability& s) {
  if (!s.drag) return nullptr;
  Json json;
  json["factor"] = s.drag->factor && s.substeps == 1
                       ? Json(print(stability_formula(*s.drag->factor, *s.damped, StabilityLetters::factors)))
                       : Json(nullptr);
  json["turns_round"] = Json::array();
  for (const Drag::Reversal& r : s.drag->reversals)
    json["turns_round"].push_back(
        {{"from", number_json(r.from)}, {"to", r.to ? number_json(*r.to) : Json(nullptr)}});
  json["stable"] = summary(s.drag->windows);
  json["limit"] = limit_json(s.drag->windows);
  json["windows"] = windows_json(s.drag->windows);
  return json;
}

Json algebraic_json(const Algebraic& a) {
  if (a.is_rational()) return a.rational().str();
  std::string decimal = algebraic_text(a, Style::language);
  return {{"formula", nullptr}, {"decimal", decimal.substr(decimal.find(' ') + 1)}, {"digits", 10}};
}

Json function_json(const Stability& s) {
  if (!s.function) return nullptr;
  const StabilityProperties& p = *s.properties;
  const auto far = s.function->size_at_infinity();
  return {{"formula", print(stability_function_formula(*s.function))},
          {"a_stable", p.a_stable},
          {"l_stable", p.l_stable},
          {"i_stable", p.imaginary_axis},
          {"poles_right", p.poles_right},
          {"size_at_infinity", far ? algebraic_json(*far) : Json(nullptr)},
          {"exceeds_1_at_imaginary", p.violated_at ? Json(p.violated_at->str()) : Json(nullptr)},
          {"real_axis",
           {{"stable", summary(p.real_axis)},
            {"limit", limit_json(p.real_axis)},
            {"windows", windows_json(p.real_axis)}}}};
}

}  // namespace

Json as_json(const Stability& s) {
  Json json{{"schema", "shortfall.stability/1"}, {"integrator", s.integrator}, {"substeps", s.substeps}};
  Json parameters = Json::object();
  for (const auto& [name, value] : s.parameters) parameters[name] = value.str();
  json["parameters"] = std::move(parameters);
  json["defaults"] = s.assumed;
  json["dt"] = s.dt ? Json(s.dt->str()) : Json(nullptr);
  json["rounded"] = s.rounded;
  json["formulas_of"] = s.of_substep ? "substep" : "frame";
  json["eigenvalues_of"] = s.substeps > 1 ? "substep" : "frame";
  add_amplification(json, s.undamped);
  json["stable"] = summary(s.windows);
  json["limit"] = limit_json(s.windows);
  json["at_limit"] = at_limit_json(s);
  json["windows"] = windows_json(s.windows);
  json["runaway"] = {{"stable", summary(s.runaway)}, {"windows", windows_json(s.runaway)}};
  json["drag"] = drag_json(s);
  if (s.damped) {
    Json damped;
    add_amplification(damped, *s.damped);
    json["damped"] = std::move(damped);
  }
  json["stability_function"] = function_json(s);
  json["proof"] = {
      {"kind", "exact"}, {"critical_values", s.windows.points}, {"rational_samples", s.windows.cells}};
  return json;
}

}  // namespace shortfall
