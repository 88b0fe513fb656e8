// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/portrait_text.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/program/print.hpp"
#include "notebooks-export/double_text.hpp"
#include "notebooks-export/text_table.hpp"

namespace shortfall {

namespace {

using Json = nlohmann::ordered_json;

/// As it is read back to the last bit.
std::string all_digits(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(17);
  out << value;
  return out.str();
}

double at_the_end(const std::vector<double>& values) { return values.back() - values.front(); }

std::string table(const Portrait& p) {
  const bool modified = p.hamiltonian.exists();
  std::vector<std::vector<std::string>> rows{
      {"  from x, v", "energy", "changes by at most", "at the end by"}};
  if (modified) rows[0].insert(rows[0].end(), {"modified energy", "changes by at most"});
  for (std::size_t i = 0; i < p.orbits.size(); ++i) {
    const PortraitOrbit& o = p.orbits[i];
    const PortraitQuestion::Start& start = p.question.starts[i];
    rows.push_back({"  " + start.x.str() + ", " + start.v.str(), double_text(o.energy.front(), 6),
                    double_text(PortraitOrbit::largest_change(o.energy), 3),
                    double_text(at_the_end(o.energy), 3)});
    if (modified)
      rows.back().insert(rows.back().end(), {double_text(o.modified.front(), 6),
                                             double_text(PortraitOrbit::largest_change(o.modified), 3)});
  }
  return aligned_table(rows);
}

/// What makes `shortfall modified` answer the same.
std::string options(const PortraitQuestion& q) {
  std::string text = " --order " + std::to_string(q.order) + " --hamiltonian";
  if (q.substeps > 1) text += " --substeps " + std::to_string(q.substeps);
  for (const auto& [name, value] : q.parameters) text += " --param " + name + "=" + value.str();
  return text;
}

/// Whether a cut modified energy changes no less than the energy, along some motion.
bool series_fails(const Portrait& p) {
  for (const PortraitOrbit& o : p.orbits) {
    const double energy = PortraitOrbit::largest_change(o.energy);
    if (energy > 1e-12 && PortraitOrbit::largest_change(o.modified) >= energy) return true;
  }
  return false;
}

}  // namespace

std::string as_text(const Portrait& p) {
  const PortraitQuestion& q = p.question;
  std::string text = p.integrator + " in the potential V = " + print(q.potential) +
                     ", mass 1, dt = " + q.h.str() + " s, " + std::to_string(q.steps) +
                     " frames in binary64\n";
  for (const std::string& note : p.notes) text += "  " + note + "\n";
  text += table(p);
  for (std::size_t i = 0; i < p.orbits.size(); ++i)
    if (p.orbits[i].lost)
      text += "  from " + q.starts[i].x.str() + ", " + q.starts[i].v.str() +
              (p.orbits[i].no_number ? " it ends: V has no value where the step asks for it, in frame "
                                     : " it runs away: out of all bounds in frame ") +
              std::to_string(*p.orbits[i].lost) + "\n";
  if (p.hamiltonian.exists())
    text +=
        "  What the step conserves instead of the energy, up to every power of h, is the modified energy, "
        "here cut\n"
        "  before h^" +
        std::to_string(q.order) + "; its formula: shortfall modified " + p.integrator + options(q) + "\n" +
        (series_fails(p)
             ? "  At this step the cut series does not hold: it changes as much as the energy itself.\n"
             : "");
  else
    text += "  No other energy is conserved order by order: at h^" +
            std::to_string(p.hamiltonian.obstructed_at) + ", " + p.hamiltonian.obstruction + "\n";
  return text + "  (all numbers rounded)\n";
}

std::string as_csv(const Portrait& p) {
  std::string text = "motion,frame,t,x,v,energy,modified_energy\n";
  for (std::size_t i = 0; i < p.orbits.size(); ++i) {
    const PortraitOrbit& o = p.orbits[i];
    for (std::size_t n = 0; n < o.x.size(); ++n)
      text += std::to_string(i + 1) + "," + std::to_string(n) + "," +
              all_digits((Rational(static_cast<long>(n)) * p.question.h).to_double()) + "," +
              all_digits(o.x[n]) + "," + all_digits(o.v[n]) + "," + all_digits(o.energy[n]) + "," +
              (p.hamiltonian.exists() ? all_digits(o.modified[n]) : "") + "\n";
  }
  return text;
}

nlohmann::ordered_json as_json(const Portrait& p) {
  const PortraitQuestion& q = p.question;
  const bool modified = p.hamiltonian.exists();
  Json json{{"schema", "shortfall.portrait/1"},
            {"integrator", p.integrator},
            {"potential", print(q.potential)},
            {"dt", q.h.str()},
            {"substeps", q.substeps},
            {"steps", q.steps},
            {"notes", p.notes}};
  json["modified_energy"] = modified ? Json{{"cut_before_power_of_h", q.order}}
                                     : Json{{"obstruction", p.hamiltonian.obstruction},
                                            {"at_power_of_h", p.hamiltonian.obstructed_at}};
  json["motions"] = Json::array();
  for (std::size_t i = 0; i < p.orbits.size(); ++i) {
    const PortraitOrbit& o = p.orbits[i];
    Json motion{{"from", {{"x", q.starts[i].x.str()}, {"v", q.starts[i].v.str()}}},
                {"ends_in_frame", o.lost ? Json(*o.lost) : Json(nullptr)},
                {"ends_without_value", o.no_number},
                {"largest_change_of_energy", PortraitOrbit::largest_change(o.energy)},
                {"change_of_energy_at_the_end", at_the_end(o.energy)}};
    motion["largest_change_of_modified_energy"] =
        modified ? Json(PortraitOrbit::largest_change(o.modified)) : Json(nullptr);
    motion["x"] = o.x;
    motion["v"] = o.v;
    motion["energy"] = o.energy;
    if (modified) motion["modified_energy"] = o.modified;
    json["motions"].push_back(std::move(motion));
  }
  return json;
}

}  // namespace shortfall
