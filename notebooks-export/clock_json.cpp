// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "notebooks-export/clock_text.hpp"

namespace shortfall {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDecimals = 17;

Json text(const std::optional<Rational>& value) { return value ? Json(value->str()) : Json(nullptr); }

const char* name_of(CompensatedClock::Kind kind) {
  constexpr std::array<const char*, 4> kNames{"closed form, proved", "stepped through", "bounded, proved",
                                              "unknown"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* name_of(ClockAlternative::Kind kind) {
  constexpr std::array<const char*, 5> kNames{"steps counted, divided by the rate",
                                              "steps counted, times the stored dt", "Kahan's sum",
                                              "a wider format", "a dyadic step"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* name_of(AccumulatorPath::End end) {
  constexpr std::array<const char*, 3> kNames{"frozen", "infinite", "not followed"};
  return kNames[static_cast<std::size_t>(end)];
}

Json as_json(const CompensatedClock& sum) {
  return {{"known", name_of(sum.kind)},
          {"value", text(sum.value)},
          {"bound", text(sum.bound)},
          {"closed_form_until", sum.closed_until.str()},
          {"frozen_after", text(sum.frozen_after)}};
}

Json as_json(const ClockAlternative& a) {
  Json json{{"kind", name_of(a.kind)}, {"value", text(a.value)}, {"error", text(a.shortfall)}};
  if (a.rate) json["rate"] = a.rate->str();
  if (a.arithmetic) json["format"] = a.arithmetic->format_name;
  if (a.step) json["dt"] = a.step->str();
  if (a.exact_additions) json["exact_additions"] = a.exact_additions->str();
  if (a.sum) json["sum"] = as_json(*a.sum);
  return json;
}

Json as_json(const ClockSpeed& s, const BinaryFormat& format) {
  const ClockRange r = range(s, format);
  return {{"sums_from", r.from.str()},
          {"sums_to", r.to.str()},
          {"spacing_exponent", s.exact ? Json(nullptr) : Json(s.unit)},
          {"before", s.before.str()},
          {"additions", s.additions.str()},
          {"increment", s.increment.str()},
          {"ppm_fast", s.parts_per_million().significant(kDecimals)},
          {"lost_per_hour", s.lost_per_hour().significant(kDecimals)}};
}

}  // namespace

Json as_json(const ClockReport& r) {
  const ClockQuestion& q = r.question;
  Json json{{"schema", "shortfall.clock/1"},
            {"format", q.format_name},
            {"rounding", name_of(q.rounding)},
            {"fused", q.fused},
            {"compensated", q.compensated},
            {"unit", q.velocity ? "m" : "s"},
            {"dt", {{"meant", q.dt.str()}, {"stored", r.stored_dt.str()}}},
            {"start", {{"meant", q.start.str()}, {"stored", r.stored_start.str()}}}};
  if (q.velocity) json["velocity"] = {{"meant", q.velocity->str()}, {"stored", r.stored_velocity->str()}};
  json["increment"] = r.increment.str();
  json["steps"] = q.additions.str();
  json["value"] = text(r.value);
  json["value_decimal"] = r.value ? Json(r.value->significant(kDecimals)) : Json(nullptr);
  json["exact"] = r.meant.str();
  json["sign"] = "exact minus computed";
  json["error"] = text(r.shortfall);
  json["error_decimal"] = r.shortfall ? Json(r.shortfall->significant(kDecimals)) : Json(nullptr);
  json["representation"] = r.representation.str();
  json["rounding_error"] = text(r.rounding_part);
  if (r.kahan) json["kahan"] = as_json(*r.kahan);
  Json plain{{"value", text(r.run.value)}, {"ends", name_of(r.path.end)}};
  json["plain"] = std::move(plain);
  json["freezes_at"] =
      r.freezes ? Json{{"value", r.freezes->value.str()}, {"additions", r.freezes->additions.str()}}
                : Json(nullptr);
  json["exact_additions"] = r.path.exact_additions().str();
  json["speeds"] = Json::array();
  for (const ClockSpeed& s : r.speeds) json["speeds"].push_back(as_json(s, q.format));
  json["instead"] = Json::array();
  for (const ClockAlternative& a : r.instead) json["instead"].push_back(as_json(a));
  return json;
}

std::string as_csv(const ClockReport& r) {
  std::string csv =
      "sums_from,sums_to,first_addition,last_addition,increment,increment_decimal,exact,ppm_fast,lost_"
      "seconds_per_"
      "hour\n";
  for (const ClockSpeed& s : r.speeds) {
    const ClockRange size = range(s, r.question.format);
    const std::array<std::string, 9> cells{size.from.significant(kDecimals),
                                           size.to.significant(kDecimals),
                                           (s.before + Rational(1)).str(),
                                           (s.before + s.additions).str(),
                                           s.increment.str(),
                                           s.increment.significant(kDecimals),
                                           s.exact ? "1" : "0",
                                           s.parts_per_million().significant(kDecimals),
                                           s.lost_per_hour().significant(kDecimals)};
    for (const std::string& c : cells) csv += (&c == &cells.front() ? "" : ",") + c;
    csv += "\n";
  }
  return csv;
}

ClockRange range(const ClockSpeed& s, const BinaryFormat& format) {
  const Rational size = power_of_two(s.unit + format.precision);
  const bool negative = s.to.sign() < 0 || (s.to.is_zero() && s.from.sign() < 0);
  if (s.exact) return {s.from, s.to};
  const Rational low = s.unit == format.least_unit ? Rational() : size / Rational(2);
  return negative ? ClockRange{-low, -size} : ClockRange{low, size};
}

std::string power_of_two_text(const Rational& value) {
  if (value.is_zero()) return "";
  const Rational size = value.abs();
  const long k = leading_bit(size);
  if (power_of_two(k) != size) return "";
  return (value.sign() < 0 ? "-2^" : "2^") + std::to_string(k);
}

}  // namespace shortfall
