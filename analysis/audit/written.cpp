// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/written.hpp"

#include <algorithm>
#include <cctype>

#include "analysis/algebra/error.hpp"
#include "analysis/audit/slip.hpp"
#include "analysis/program/parse.hpp"

namespace shortfall {

namespace {

/// The value of a text such as 1/4+sqrt(3)/6; none when it is none.
std::optional<KnownDigits> value_of(const std::string& text, const Program& program) {
  try {
    Names names;
    names.functions = Functions::of_programs;
    names.force = false;
    return known_value(parse_formula(text, "coefficient", names, Type{}), program);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// A decimal of which more digits are printed than are known otherwise: the one that a single slip makes of
/// it and that lies nearest to the middle of what is known.
std::optional<std::string> by_one_slip(const std::string& printed, const KnownDigits& value) {
  const Rational middle = value.ball().midpoint();
  std::optional<std::string> best;
  Rational distance;
  const auto offer = [&](const std::string& text) {
    const Rational r = Rational::parse(text);
    if (!value.ball().contains(r)) return;
    if (best && (r - middle).abs() >= distance) return;
    best = text;
    distance = (r - middle).abs();
  };
  for (const std::string& text : before_a_slip(printed)) offer(text);
  return best;
}

}  // namespace

std::string written(const AuditedTableau& t, const Cell& cell, const Rational& value) {
  return written_like(value, t.texts.at(cell));
}

std::string written(const AuditedTableau& t, const Cell& cell, const Fraction& value) {
  if (value.is_constant()) return written_like(value.constant(), t.texts.at(cell));
  const KnownDigits near = t.near(value);
  const auto is_it = [&](const std::string& text) {
    const auto other = value_of(text, t.program);
    return other && is_nothing(*other - near);
  };
  for (const std::string& text : before_a_slip(t.texts.at(cell)))
    if (is_it(text)) return text;
  // Perhaps it is what stands in another place.
  for (const Cell& other : cells(t.texts))
    if (is_nothing(t.digits.at(other) - near)) return t.texts.at(other);
  return t.formula(value);
}

std::string written(const AuditedTableau& t, const Cell& cell, const KnownDigits& value) {
  return written_like(value, t.texts.at(cell));
}

std::string written_like(const KnownDigits& value, const std::string& printed) {
  const Rational middle = value.ball().midpoint();
  const int known = value.digits();
  const std::size_t slash = printed.find('/');
  std::vector<std::string> forms;
  const auto nearest = [](const Rational& r) { return (r + Rational(1, 2)).floor(); };
  const auto offer = [&](const Rational& above, const Rational& below) {
    if (above.is_zero() || below.sign() <= 0 || !value.ball().contains(above / below)) return;
    forms.push_back(above.str() + "/" + below.str());
  };
  if (slash != std::string::npos) {
    try {
      const Rational above = Rational::parse(printed.substr(0, slash)),
                     below = Rational::parse(printed.substr(slash + 1));
      if (above.is_integer() && below.is_integer()) {
        offer(nearest(middle * below), below);
        if (!middle.is_zero()) {
          const Rational needed = nearest(above / middle);
          offer(needed.sign() > 0 ? above : -above, needed.abs());
        }
      }
    } catch (const Error&) {  // an expression
    }
  }
  const std::size_t point = printed.find('.');
  const int places = point == std::string::npos ? known : static_cast<int>(printed.size() - point - 1);
  forms.push_back(middle.decimal(std::min(places, known)));
  if (slash == std::string::npos && point != std::string::npos && known < places &&
      printed.find_first_not_of("-.0123456789") == std::string::npos)
    if (const auto text = by_one_slip(printed, value)) forms.push_back(*text);
  const Rational simple = simplest_between(middle - Rational(1) / Rational(10).pow(known),
                                           middle + Rational(1) / Rational(10).pow(known));
  // A fraction with far fewer digits than are known is no accident.
  if (3 * static_cast<int>(simple.denominator().digits()) < known)
    forms.push_back(written_like(simple, printed));
  return *std::ranges::min_element(forms, {}, [&](const std::string& f) { return slip(printed, f).cost; });
}

}  // namespace shortfall
