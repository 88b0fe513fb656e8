// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/jump_amount.hpp"

#include <optional>

#include "analysis/algebra/unit.hpp"

namespace shortfall::cli {

namespace {

constexpr int kShownDigits = 10;

std::optional<std::string> finite_decimal(const Rational& value, int places, std::size_t digits) {
  Rational scaled = value;
  for (int k = 0; k <= places; ++k, scaled *= 10)
    if (scaled.is_integer())
      return scaled.digits() <= digits ? std::optional(value.decimal(k)) : std::nullopt;
  return std::nullopt;
}

}  // namespace

std::string exact_text(const Rational& value, int places) {
  return finite_decimal(value, places, 30).value_or(value.str());
}

Amounts::Unit Amounts::unit_named(const std::string& name) {
  const PhysicalUnit* known = find_unit(name);
  if (!known || known->dimension != kPhysicalLength) return {"m", 1};
  return {name, Rational(1) / known->scale};
}

Amounts::Amounts(const std::string& unit, const Rational& typical, bool ascii)
    : unit_(unit.empty() ? unit_named(typical < Rational(1, 100) ? "mm"
                                      : typical < 1              ? "cm"
                                                                 : "m")
                         : unit_named(unit)),
      length_(unit == "px" ? "px" : "m"),
      ascii_(ascii) {}

std::string Amounts::number(const Surd& value, bool with_sign) const {
  const std::string sign = with_sign && value.sign() > 0 ? "+" : "";
  if (value.is_rational())
    if (const auto decimal = finite_decimal(value.rational_part(), 15, kShownDigits + 2))
      return sign + *decimal;
  return (ascii_ ? "~ " : "≈ ") + sign + value.significant(kShownDigits);
}

Amounts::Unit Amounts::of_difference(const Surd& metres) const {
  if (length_ == "px") return unit_;
  const Surd size = metres.abs();
  return unit_named(size.is_zero()                   ? unit_.name
                    : size >= Surd(1)                ? "m"
                    : size >= Surd(Rational(1, 100)) ? "cm"
                                                     : "mm");
}

std::string Amounts::height(const Surd& metres) const {
  return number(metres * Surd(unit_.per_metre)) + " " + unit_.name;
}

std::string Amounts::difference(const Surd& metres) const {
  const Unit unit = of_difference(metres);
  return number(metres * Surd(unit.per_metre)) + " " + unit.name;
}

std::string Amounts::signed_difference(const Surd& metres) const {
  const Unit unit = of_difference(metres);
  return number(metres * Surd(unit.per_metre), true) + " " + unit.name;
}

std::string Amounts::speed(const Surd& value) const { return number(value) + " " + length_ + "/s"; }

std::string Amounts::time(const Surd& seconds) const { return number(seconds) + " s"; }

std::string Amounts::time_equals(const Surd& seconds) const {
  const std::string text = time(seconds);
  return (text.starts_with(ascii_ ? "~" : "≈") ? "" : "= ") + text;
}

std::string Amounts::acceleration(const Rational& value) const {
  return exact_text(value) + " " + length_ + (ascii_ ? "/s^2" : "/s²");
}

std::string Amounts::acceleration(const Surd& value) const {
  return number(value) + " " + length_ + (ascii_ ? "/s^2" : "/s²");
}

std::string Amounts::height_exactly(const Rational& metres) const {
  return exact_text(metres * unit_.per_metre, 15) + " " + unit_.name;
}

}  // namespace shortfall::cli
