// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/result_json.hpp"

#include "analysis/program/print.hpp"

namespace shortfall {

using Json = nlohmann::ordered_json;

namespace {

Json head(const char* schema, const Derivation& d) {
  Json json{{"schema", schema},
            {"integrator", d.integrator},
            {"force", d.degree == 0 ? "constant" : "poly:" + std::to_string(d.degree)}};
  if (d.substeps != 1) json["substeps"] = d.substeps;
  return json;
}

Json corrections(const CorrectionOption& option) {
  Json list = Json::array();
  for (const Correction& c : option.corrections)
    list.push_back({{"kind", kind_name(c.kind)},
                    {"target", c.target},
                    {"add", print(c.add)},
                    {"series", c.series},
                    {"exact", c.exact},
                    {"order", nullptr},
                    {"reason", c.reason}});
  return list;
}

void add_kit(Json& json, const CorrectionKit* kit) {
  if (!kit) return;
  const CorrectionOption* best = kit->best();
  json["corrections"] = best ? corrections(*best) : Json::array();
  json["obstruction"] = !best && kit->needed ? Json(kit->options.front().obstruction) : Json(nullptr);
  Json options = Json::array();
  for (const CorrectionOption& o : kit->options) {
    Json option{{"name", o.name}, {"exists", o.exists}, {"corrections", corrections(o)}};
    option["obstruction"] = o.exists ? Json(nullptr) : Json(o.obstruction);
    option["proof"] = o.proof;
    options.push_back(std::move(option));
  }
  json["options"] = std::move(options);
}

}  // namespace

Json as_json(const Derivation& d, const CorrectionKit* kit) {
  Json json = head("shortfall.derive/1", d);
  json["position"] = print(d.position);
  json["velocity"] = print(d.velocity);
  json["exact"] = {{"position", print(d.exact_position)}, {"velocity", print(d.exact_velocity)}};
  json["shortfall"] = {{"position", print(d.shortfall_position)}, {"velocity", print(d.shortfall_velocity)}};
  json["valid_from"] = d.form.valid_from;
  add_kit(json, kit);
  json["proof"] = {
      {"kind", "evaluation"},
      {"proved", d.proved()},
      {"points", d.proof.points},
      {"recurrence_order", d.proof.recurrence},
      {"statement",
       "both sides satisfy one linear recurrence of this order and agree, as functions of all letters, at as "
       "many consecutive n"},
      {"random_check",
       {{"trials", d.check.trials},
        {"steps", d.check.steps},
        {"digits", d.check.digits},
        {"agrees", d.check.agrees}}}};
  Json steps = Json::array();
  for (const DerivationStep& s : d.steps)
    steps.push_back({{"latex", print(s.left, Style::latex) + " = " + print(s.right, Style::latex)},
                     {"text", print(s.left) + " = " + print(s.right)},
                     {"why", s.why},
                     {"proved", s.proved},
                     {"points", s.points}});
  json["steps"] = std::move(steps);
  json["printed_digits"] = d.digits == 0 ? Json(nullptr) : Json(d.digits);
  json["assumptions"] = d.assumptions;
  return json;
}

Json as_json(const CorrectionKit& kit, const Derivation& d) {
  Json json = head("shortfall.correct/1", d);
  json["shortfall"] = {{"position", print(d.shortfall_position)}, {"velocity", print(d.shortfall_velocity)}};
  json["needed"] = kit.needed;
  add_kit(json, &kit);
  return json;
}

}  // namespace shortfall
