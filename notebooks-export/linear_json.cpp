// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "notebooks-export/linear_implicit.hpp"
#include "notebooks-export/linear_text.hpp"

namespace shortfall {

using Json = nlohmann::ordered_json;

namespace {

Json definitions(const std::vector<Definition>& list) {
  Json json = Json::object();
  for (const Definition& d : list) json[d.name] = print(d.value);
  return json;
}

Json head(const char* schema, const LinearDerivation& d) {
  Json json{{"schema", schema}, {"integrator", d.integrator}, {"force", d.force.text}};
  if (d.substeps != 1) json["substeps"] = d.substeps;
  return json;
}

Json corrections(const LinearKit& kit) {
  static const char* const kinds[] = {"parameter", "launch", "read-out"};
  Json list = Json::array();
  for (const LinearCorrection& c : kit.corrections)
    list.push_back({{"kind", kinds[static_cast<int>(c.kind)]},
                    {"target", c.target},
                    {"replace", print(c.spelled)},
                    {"exact", true},
                    {"order", nullptr},
                    {"reason", c.reason}});
  return list;
}

void add_kit(Json& json, const LinearKit& kit) {
  json["corrections"] = corrections(kit);
  json["correction_definitions"] = definitions(kit.definitions);
  if (!kit.step_definitions.empty()) json["step_definitions"] = definitions(kit.step_definitions);
  json["equations"] = kit.implicit ? implicit_json(kit) : Json(nullptr);
  json["notes"] = kit.notes;
  json["obstruction"] = kit.exists ? Json(nullptr) : Json(kit.obstruction);
}

}  // namespace

Json as_json(const LinearDerivation& d, const LinearKit& kit) {
  Json json = head("shortfall.derive/1", d);
  const Wording w = d.wording();
  json["position"] = d.position ? Json(print(d.position)) : Json(nullptr);
  json["velocity"] = d.velocity ? Json(print(d.velocity)) : Json(nullptr);
  json["definitions"] = definitions(d.definitions);
  json["condition"] = d.condition;
  Json cases = Json::array();
  for (const RootCase& c : d.cases)
    cases.push_back(
        {{"condition", c.condition}, {"position", print(c.position)}, {"velocity", print(c.velocity)}});
  json["cases"] = cases;
  Json polynomial = Json::array();
  for (const Fraction& f : d.form.oscillation.polynomial) polynomial.push_back(print(formula(f, w)));
  json["recurrence"] = {{"polynomial", polynomial}};
  for (const auto& [key, values] :
       {std::pair{"position", &d.form.oscillation.position}, {"velocity", &d.form.oscillation.velocity}}) {
    Json columns = Json::object();
    for (std::size_t c = 0; c < values->size(); ++c)
      for (const Fraction& f : (*values)[c])
        columns[column_name(static_cast<int>(c), d.force.degree)].push_back(print(formula(f, w)));
    json["recurrence"][key] = columns;
  }
  json["trace"] = d.trace ? Json(print(formula(*d.trace, w))) : Json(nullptr);
  json["determinant"] = d.determinant ? Json(print(formula(*d.determinant, w))) : Json(nullptr);
  json["exact"] = {{"position", print(d.exact.position)},
                   {"velocity", print(d.exact.velocity)},
                   {"definitions", definitions(d.exact.definitions)},
                   {"condition", d.exact.condition}};
  Json others = Json::array();
  for (const FlowCase& other : d.exact.others)
    others.push_back({{"condition", other.condition},
                      {"position", print(other.position)},
                      {"velocity", print(other.velocity)},
                      {"definitions", definitions(other.definitions)}});
  json["exact"]["cases"] = others;
  json["conserved"] = nullptr;
  if (kit.conserved)
    json["conserved"] = {{"x^2", print(formula(kit.conserved->xx, w))},
                         {"x*v", print(formula(kit.conserved->xv, w))},
                         {"v^2", "1"},
                         {"from", d.amplified_from},
                         {"factor", print(formula(kit.conserved->factor, w))}};
  add_kit(json, kit);
  json["valid_from"] = d.form.valid_from;
  json["proof"] = {{"kind", "recurrence"},
                   {"proved", d.proved()},
                   {"points", d.proof.points},
                   {"recurrence_order", d.proof.recurrence},
                   {"random_check",
                    {{"trials", d.check.trials},
                     {"steps", d.check.steps},
                     {"digits", d.check.digits},
                     {"agrees", d.check.agrees}}}};
  json["printed_digits"] = d.digits == 0 ? Json(nullptr) : Json(d.digits);
  json["assumptions"] = d.assumptions;
  return json;
}

Json as_json(const LinearKit& kit, const LinearDerivation& d) {
  Json json = head("shortfall.correct/1", d);
  add_kit(json, kit);
  json["proof"] = kit.proof;
  return json;
}

}  // namespace shortfall
