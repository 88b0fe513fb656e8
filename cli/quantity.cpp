// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/quantity.hpp"

#include <cmath>
#include <utility>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/algebra/unit.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall::cli {

namespace {

/// Names of the units that a length or a time can have.
std::vector<std::string> known_units(Unit unit) {
  std::vector<std::string> names = unit_names(unit == Unit::length ? kPhysicalLength : kPhysicalTime);
  if (unit == Unit::time)
    for (std::string& rate : unit_names(kPhysicalRate)) names.push_back(std::move(rate));
  return names;
}

}  // namespace

Rational quantity(std::string_view text, Unit unit, const std::string& what) {
  const auto complain = [&](const std::string& why) {
    return BadInput(what + " '" + std::string(text.substr(0, 60)) + "': " + why);
  };
  // The number ends where its last digit or point is; an e with an exponent belongs to it.
  const std::size_t end = text.find_last_of("0123456789.");
  if (end == std::string_view::npos) throw complain("this is not a number");
  const std::string_view digits = text.substr(0, end + 1);
  std::string_view suffix = text.substr(end + 1);
  while (suffix.starts_with(' ')) suffix.remove_prefix(1);
  Rational value;
  try {
    value = Rational::parse(digits);
  } catch (const BadInput& e) {
    throw complain(e.what());
  }
  if (suffix.empty()) return value;
  if (suffix == "f" || suffix == "d") {
    const double rounded = suffix == "f" ? value.to_float() : value.to_double();
    if (!std::isfinite(rounded)) throw complain("it overflows its format");
    return Rational::from_double(rounded);
  }
  const PhysicalUnit* known = find_unit(suffix);
  if (known && known->dimension == (unit == Unit::length ? kPhysicalLength : kPhysicalTime) &&
      unit != Unit::none)
    return value * known->scale;
  if (known && known->dimension == kPhysicalRate && unit == Unit::time) {
    if (value.is_zero()) throw complain("0 " + std::string(suffix) + " is no step");
    return Rational(1) / (value * known->scale);
  }
  if (unit == Unit::none) throw complain("it takes no unit, found '" + std::string(suffix) + "'");
  const std::vector<std::string> names = known_units(unit);
  throw complain("unknown unit '" + std::string(suffix) + "'" + did_you_mean(std::string(suffix), names) +
                 "; the units are " + comma_list(names));
}

Rational positive_quantity(std::string_view text, Unit unit, const std::string& what) {
  Rational value = quantity(text, unit, what);
  if (value.sign() <= 0)
    throw BadInput(what + " '" + std::string(text.substr(0, 60)) + "': it must be greater than 0");
  return value;
}

bool has_suffix(std::string_view text, char suffix) {
  return text.size() > 1 && text.back() == suffix && text.find_last_of("0123456789.") == text.size() - 2;
}

StoredQuantity stored_quantity(std::string_view text, Unit unit, const std::string& what) {
  if (!has_suffix(text, 'f') && !has_suffix(text, 'd')) return {quantity(text, unit, what), std::nullopt};
  return {quantity(text.substr(0, text.size() - 1), unit, what), quantity(text, unit, what)};
}

std::vector<Rational> sweep(std::string_view text, Unit unit, const std::string& what) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    std::size_t end = text.find(':', begin);
    if (end == std::string_view::npos) end = text.size();
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  if (parts.size() == 1) return {positive_quantity(text, unit, what)};
  if (parts.size() != 4 || (parts[2] != "lin" && parts[2] != "log"))
    throw BadInput(what + " '" + std::string(text.substr(0, 60)) +
                   "': a sweep is written FROM:TO:lin:COUNT or FROM:TO:log:COUNT");
  const Rational from = positive_quantity(parts[0], unit, what);
  const Rational to = positive_quantity(parts[1], unit, what);
  std::int64_t count = 0;
  if (!quantity(parts[3], Unit::none, what).fits_int64(count) || count < 2 || count > 100'000)
    throw BadInput(what + ": a sweep has from 2 to 100000 points, not '" +
                   std::string(parts[3].substr(0, 60)) + "'");
  std::vector<Rational> points;
  for (std::int64_t i = 0; i < count; ++i) {
    const Rational share(i, count - 1);
    if (parts[2] == "lin")
      points.push_back(from + (to - from) * share);
    else if (i == 0 || i == count - 1)
      points.push_back(i == 0 ? from : to);
    else
      points.push_back(
          Rational::parse(Rational::from_double(from.to_double() * std::pow(to.to_double() / from.to_double(),
                                                                            share.to_double()))
                              .significant(12)));
  }
  return points;
}

}  // namespace shortfall::cli
