// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/series_json.hpp"

#include "notebooks-export/modified_text.hpp"

namespace shortfall {

nlohmann::ordered_json number_json(const Fraction& f, const SeriesSource& source) {
  if (f.is_constant() && source.digits() == 0) return f.constant().str();
  return {{"formula", print(source.formula(f))},
          {"decimal", source.decimal(f, 20)},
          {"digits", source.digits() > 0 ? source.digits() : 20}};
}

namespace {

nlohmann::ordered_json terms_json(const std::vector<FieldTerm>& terms, const SeriesSource& source) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const FieldTerm& t : terms)
    json.push_back({{"component", t.component},
                    {"power", t.power},
                    {"tree", t.tree},
                    {"differential", t.differential},
                    {"coefficient", number_json(t.coefficient, source)}});
  return json;
}

}  // namespace

nlohmann::ordered_json as_json(const ModifiedEquation& m, const SeriesSource& source) {
  nlohmann::ordered_json json{
      {"schema", "shortfall.modified/1"},
      {"integrator", m.integrator},
      {"equation", m.forces ? "x'' = " + m.forces->force : std::string("y' = f(y)")},
      {"order", m.order},
      {"modifying", m.modifying},
      {"exact", m.digits == 0},
      {"digits", m.digits == 0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(m.digits)},
      {"trees", m.trees}};
  json["obstruction"] =
      m.obstruction.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(m.obstruction);
  json["terms"] = terms_json(m.terms, source);
  json["checksum"] =
      m.obstruction.empty() ? number_json(m.checksum, source) : nlohmann::ordered_json(nullptr);
  json["hamiltonian"] = nullptr;
  json["notes"] = m.notes;
  return json;
}

nlohmann::ordered_json as_json(const ModifiedHamiltonian& h, const SeriesSource& source) {
  if (!h.exists()) return {{"exists", false}, {"power", h.obstructed_at}, {"obstruction", h.obstruction}};
  nlohmann::ordered_json json{{"exists", true}, {"up_to_power", h.order - 1}};
  json["terms"] = nlohmann::ordered_json::array();
  for (const EnergyTerm& t : h.terms)
    json["terms"].push_back({{"power", t.power},
                             {"contraction", t.contraction},
                             {"coefficient", number_json(t.coefficient, source)}});
  json["text"] = "v^2/2 + V" + hamiltonian_sum(h, source, Style::language, {});
  json["one_dimensional"] = "v^2/2 + V" + one_dimensional_sum(h, source, Style::language, {});
  return json;
}

nlohmann::ordered_json as_json(const Processing& p, const std::vector<std::string>& twins,
                               const SeriesSource& source) {
  const auto or_null = [](const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
  };
  nlohmann::ordered_json json{{"forces", p.forces->key},
                              {"force_reads", p.forces->force},
                              {"order", p.plain_order},
                              {"effective_order", p.effective_order},
                              {"force", terms_json(p.force, source)},
                              {"launch", terms_json(p.launch, source)},
                              {"read_out", terms_json(p.read_out, source)},
                              {"is", twins}};
  json["obstruction"] = or_null(p.obstruction);
  json["obstructed_at"] =
      p.obstruction.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(p.obstructed_at);
  json["obstruction_proved"] = !p.obstruction.empty() && p.proved;
  json["certificate"] = terms_json(p.residual, source);
  json["certificate_value"] =
      p.obstruction.empty() ? nlohmann::ordered_json(nullptr) : number_json(p.residual_value, source);
  json["notes"] = p.notes;
  return json;
}

}  // namespace shortfall
