// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/linear_implicit.hpp"

#include <nlohmann/json.hpp>

#include "analysis/correction/kit_letters.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kLongEquation = 16;  // terms: beyond, R(u) says the same and is read more easily

const std::string& unknown_name(const LinearKit& kit, std::size_t i) {
  return kit.letters[kit.implicit->unknowns[i]];
}

Expr truth(const LinearKit& kit, std::size_t i) {
  return name(kit.letters[kit.implicit->unknowns[i] == kStiffness ? kTrueStiffness : kTrueDamping]);
}

/// k_new and c_new, or h^2 k_new and h c_new.
std::string list_of_unknowns(const LinearKit& kit, Style style, bool scaled = false) {
  std::string text;
  for (std::size_t i = 0; i < kit.implicit->unknowns.size(); ++i) {
    const Expr own = name(unknown_name(kit, i));
    const Expr h = kit.implicit->unknowns[i] == kStiffness ? power(name("h"), 2) : name("h");
    text += (i ? " and " : "") + print(scaled ? h * own : own, style);
  }
  return text;
}

Expr difference(const LinearKit& kit, std::size_t i) {
  return formula(kit.implicit->leading[i], kit.wording());
}

std::string range_text(const BranchRange& r, const ImplicitParameters& p) {
  const bool spring = p.unknowns[0] == kStiffness;
  if (r.all)
    return spring ? "    it exists for every w h from 0 to pi: up to there the trace of the step falls "
                    "strictly to -2\n"
                  : "    it exists for every c h > 0: what the step leaves of the velocity falls strictly to "
                    "0\n";
  const bool exact = r.end->is_rational();
  return std::string("    it exists as long as ") + (spring ? "cos(w h)" : "exp(-c h)") + " >= " + *r.least +
         (exact ? "" : " (rounded)") + ": the step's own value falls strictly until\n    " +
         (spring ? "  h^2 k_new" : "  h c_new") +
         (exact ? " = " + r.end->rational().str() : " ≈ " + r.end->significant(20)) + " and no further\n";
}

}  // namespace

std::string implicit_text(const LinearKit& kit, NamedFormulas& formulas) {
  const Style style = formulas.style();
  const ImplicitParameters& p = *kit.implicit;
  std::string text = "  " + list_of_unknowns(kit, style);
  const bool one = p.unknowns.size() == 1;
  if (!p.radicals.empty()) {
    text += std::string(one ? " is" : " are") + " given above, by square roots\n";
  } else if (p.stability_function) {
    const std::string u = one && p.unknowns[0] == kDamping ? "-c h" : "lambda h";
    text += std::string(one ? " is" : " are") + " found from R(u) = exp(" + u +
            "), R(u) = " + formulas.print(*p.stability_function) + ", the root u near " + u + ":\n";
    if (one && p.unknowns[0] == kDamping)
      text += "    c_new = -u/h\n";
    else
      text += one ? "    k_new = |u|^2/h^2, lambda = i w\n"
                  : "    with a root u1, u2 for each root of lambda^2 + c lambda + k = 0:\n"
                    "    k_new = u1 u2/h^2, c_new = -(u1 + u2)/h\n";
  } else {
    text += std::string(one ? " is the root" : " are the solution") +
            (p.leading.empty() ? " that is regular at h = 0, of\n"
                               : std::string(" near the true value") + (one ? "" : "s") + " of\n");
  }
  for (const Polynomial& equation : p.equations) {
    if (!p.radicals.empty()) break;
    if (p.stability_function && equation.terms().size() > kLongEquation) continue;
    text += std::string(p.stability_function ? "    so that " : "    ") +
            formulas.print(formula(Fraction(equation), kit.wording())) + " = 0\n";
  }
  text += "    it exists and is unique for small h: the derivative of the equation";
  if (!one)
    text = text.substr(0, text.rfind("it exists")) +
           "they exist and are unique for small h: the determinant of the derivatives of both equations";
  text += " by " + list_of_unknowns(kit, style, true) + " is " +
          formulas.print(formula(p.jacobian, kit.wording())) +
          " in the\n    limit, not 0 (implicit function theorem)\n";
  for (std::size_t i = 0; i < p.leading.size(); ++i)
    text += "    " + print(name(unknown_name(kit, i)), style) + " = " +
            (p.leading[i].is_zero()
                 ? print(truth(kit, i), style) + " up to h^8\n"
                 : formulas.print(joined(truth(kit, i), difference(kit, i))) + " + higher powers of h\n");
  if (p.range) text += range_text(*p.range, p);
  return text;
}

nlohmann::ordered_json implicit_json(const LinearKit& kit) {
  using Json = nlohmann::ordered_json;
  const ImplicitParameters& p = *kit.implicit;
  Json json{{"unknowns", Json::array()}, {"zero", Json::array()}};
  for (std::size_t i = 0; i < p.unknowns.size(); ++i) json["unknowns"].push_back(unknown_name(kit, i));
  for (const Polynomial& equation : p.equations)
    json["zero"].push_back(print(formula(Fraction(equation), kit.wording())));
  json["branch"] = "the solution that tends to the true values for h -> 0";
  json["jacobian"] = print(formula(p.jacobian, kit.wording()));
  Json leading = Json::object();
  for (std::size_t i = 0; i < p.leading.size(); ++i)
    leading[unknown_name(kit, i)] = print(formula(p.leading[i], kit.wording()));
  json["leading_difference"] = leading;
  json["stability_function"] = p.stability_function ? Json(print(*p.stability_function)) : Json(nullptr);
  json["range"] = nullptr;
  if (p.range)
    json["range"] = {{"all", p.range->all},
                     {"least", p.range->least ? Json(*p.range->least) : Json(nullptr)},
                     {"end", p.range->end ? Json(p.range->end->significant(20)) : Json(nullptr)}};
  return json;
}

}  // namespace shortfall
