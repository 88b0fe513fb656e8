// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/cycle_text.hpp"

#include <cmath>
#include <numbers>

#include "notebooks-export/double_text.hpp"

namespace shortfall {

namespace {

/// Turns a second, exactly: whole numbers over the time of a period.
Rational frequency(const Cycle& c, const FloatQuestion& q) {
  return Rational(c.turns) / (Rational(c.period) * q.h);
}

/// What the spring does, in Hz; 0 where there is none, or one with damping.
double true_frequency(const FloatQuestion& q) {
  if (!q.force.spring || q.force.damper) return 0;
  return std::sqrt(q.force.k->to_double()) / (2 * std::numbers::pi);
}

}  // namespace

std::string as_text(const CycleSearch& search, const FloatFormat& format, const FloatQuestion& q) {
  std::string text =
      q.program.name + ", force " + q.force.text + ", dt = " + q.h.str() + " s, in " + format.words() + "\n";
  if (search.not_finite_at)
    return text + "  no cycle: it is no longer a finite number from step " +
           std::to_string(*search.not_finite_at) + " on\n";
  if (!search.found)
    return text + "  no cycle within " + std::to_string(search.looked_at) +
           " steps; look further with --most\n";
  const Cycle& c = *search.found;
  text += "  after " + std::to_string(c.tail) + " steps it repeats itself every " + std::to_string(c.period) +
          " steps (" + (Rational(c.period) * q.h).significant(9) + " s), for all time\n";
  if (c.turns > 0) {
    text += "  oscillations in one period: " + std::to_string(c.turns) + "; so its frequency is " +
            frequency(c, q).significant(12) + " Hz in the long run, exactly " + frequency(c, q).str() + "\n";
    if (const double truth = true_frequency(q); truth > 0)
      text += "    the spring's is " + double_text(truth, 12) + " Hz: the run gains " +
              double_text((frequency(c, q).to_double() / truth - 1) * 1e6, 6) + " millionths (rounded)\n";
  } else {
    text += c.period == 1 ? "  from then on position and velocity stay the same numbers\n"
                          : "  no oscillation in one period\n";
  }
  text += "  ever: |x| at most " + double_text(c.largest_x, 9) + " m, |v| at most " +
          double_text(c.largest_v, 9) + " m/s\n";
  text += "  ever: energy per mass from " + double_text(c.least_energy, 9) + " to " +
          double_text(c.largest_energy, 9) + " m^2/s^2 (rounded)\n";
  return text + "  found by running " + std::to_string(c.looked_at) + " steps, in constant memory\n";
}

nlohmann::ordered_json as_json(const CycleSearch& search, const FloatFormat& format, const FloatQuestion& q) {
  nlohmann::ordered_json json{{"format", format.name()}, {"found", search.found.has_value()}};
  json["not_finite_at"] =
      search.not_finite_at ? nlohmann::ordered_json(*search.not_finite_at) : nlohmann::ordered_json(nullptr);
  json["looked_at"] = search.looked_at;
  if (!search.found) return json;
  const Cycle& c = *search.found;
  json["tail"] = c.tail;
  json["period"] = c.period;
  json["turns"] = c.turns;
  json["frequency"] = frequency(c, q).str();
  json["true_frequency"] = true_frequency(q);
  json["largest_x"] = c.largest_x;
  json["largest_v"] = c.largest_v;
  json["energy"] = {{"least", c.least_energy}, {"largest", c.largest_energy}};
  return json;
}

}  // namespace shortfall
