// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/order_text.hpp"

#include <algorithm>
#include <cmath>

#include "notebooks-export/series_json.hpp"
#include "notebooks-export/series_text.hpp"

namespace shortfall {

namespace {

std::string number_text(const OrderOfClass& c) {
  return (c.at_least ? "at least " : "") + std::to_string(c.order);
}

/// "order 4 for every force a(x, t), 1 when the force reads the velocity".
std::string headline(const OrderReport& r) {
  if (r.order.classes.size() == 1) {
    const OrderOfClass& c = r.order.classes.front();
    return "order " + number_text(c) + " for " + c.forces->force;
  }
  const OrderOfClass& general = r.order.of("general");
  const OrderOfClass& without_velocity = r.order.of("velocity_independent");
  const OrderOfClass& position = r.order.of("position_only");
  std::string text = "order ";
  if (without_velocity.order > general.order) {
    text += number_text(without_velocity) + " for every force a(x, t); " + number_text(general) +
            " when the force reads the velocity";
  } else {
    text += number_text(general) + " for every force a(x, v, t)";
    if (position.order > general.order) text += "; " + number_text(position) + " for forces a(x)";
  }
  return text;
}

std::string order_exactness(const Order& order) {
  return order.digits == 0 ? "proved, all conditions hold exactly"
                           : "to " + std::to_string(order.digits) +
                                 " digits after the point, as the coefficients are printed";
}

/// The class whose first errors are shown: the widest among those of the highest order worth naming.
const OrderOfClass& shown(const OrderReport& r) {
  if (r.order.classes.size() == 1) return r.order.classes.front();
  const OrderOfClass& general = r.order.of("general");
  const OrderOfClass& without_velocity = r.order.of("velocity_independent");
  // Of a tableau with c = A 1 the conditions with time follow from those without.
  if (r.structure.row_sums.value_or(false)) return r.order.of("autonomous");
  return without_velocity.order > general.order ? without_velocity : general;
}

/// The root of the sum of squares, and the sum itself where it is rational.
struct Norm {
  Fraction squares;
  double value = 0;
};

Norm norm(const OrderOfClass& c, const SeriesSource& source) {
  Norm n;
  for (const ErrorTerm& e : c.errors) n.squares += e.coefficient * e.coefficient;
  n.value = std::sqrt(source.to_double(n.squares));
  return n;
}

std::string property(const std::string& word, const Property& p, int digits) {
  switch (p.verdict) {
    case Property::Verdict::proved:
      return "yes, proved: " + p.how;
    case Property::Verdict::refuted:
      return "no: " + p.how;
    case Property::Verdict::not_contradicted:
      break;
  }
  const std::string condition = p.how.empty() ? "" : p.how;
  if (p.up_to == 0) return "yes, to " + std::to_string(digits) + " digits: " + condition;
  return word + " as far as trees up to order " + std::to_string(p.up_to) + " tell" +
         (condition.empty() ? "" : ", " + condition);
}

/// What the letters in exact coefficients stand for.
std::string letters_text(const OrderOfClass& c, const SeriesSource& source, Style style) {
  std::string text;
  if (source.digits() > 0) return text;
  for (const ExtraLetters::Extra& e : source.extras()) {
    const auto root = std::ranges::find(source.program().roots, e.name, &Root::name);
    if (root == source.program().roots.end()) continue;
    if (std::ranges::none_of(
            c.errors, [&](const ErrorTerm& t) { return mentions(source.formula(t.coefficient), e.name); }))
      continue;
    text += "  where " + print(name(e.name), style) + (style == Style::language ? " ~ " : " ≈ ") +
            near(*root->value, 12).significant(10) + " solves " + print(root->left, style) + " = " +
            print(root->right, style) + "\n";
  }
  return text;
}

std::string energy_text(const OrderReport& r, const SeriesSource& source, Style style) {
  const EnergyChange& e = r.energy;
  if (e.order == 0) return "kept for a = -V'(x) as far as h^" + std::to_string(e.looked_at);
  constexpr std::size_t kLongest = 110;
  SumByPowers sum(source, style);
  std::size_t shown = 0;
  std::string text;
  for (; shown < e.terms.size() && (shown == 0 || text.size() < kLongest); ++shown) {
    sum.add(e.order, e.terms[shown].coefficient, e.terms[shown].contraction);
    text = sum.str();
  }
  text = text.starts_with(" + ") ? text.substr(3) : "-" + text.substr(3);
  if (shown < e.terms.size()) text += " + " + std::to_string(e.terms.size() - shown) + " more";
  return "changes in a step by " + text + " + ..., for a = -V'(x)";
}

constexpr std::size_t kShownErrors = 12;

std::string errors_text(const OrderOfClass& c, const SeriesSource& source, Style style) {
  if (c.errors.empty()) return "";
  std::string text = c.by_the_start ? "\nWhat the start gets wrong, for " : "\nFirst errors, for ";
  text += (c.errors.front().component == "y" ? "y' = f(y)" : c.forces->force) +
          " (a step minus the exact motion; a term times h^" + std::to_string(c.errors.front().order) + ")\n";
  std::size_t width = 0, weight = 0;
  std::vector<std::string> exact;
  const std::size_t count = std::min(kShownErrors, c.errors.size());
  for (std::size_t i = 0; i < count; ++i) {
    const ErrorTerm& e = c.errors[i];
    exact.push_back(source.digits() > 0 ? "" : print(source.formula(e.coefficient), style));
    width = std::max(width, e.differential.size());
    // Fractions and minus signs are longer in bytes than in columns.
    weight = std::max(weight, static_cast<std::size_t>(std::ranges::count_if(
                                  exact.back(), [](char ch) { return (ch & 0xC0) != 0x80; })));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const ErrorTerm& e = c.errors[i];
    const auto columns = static_cast<std::size_t>(
        std::ranges::count_if(exact[i], [](char ch) { return (ch & 0xC0) != 0x80; }));
    text += "  " + e.component + "  " + e.differential + std::string(width - e.differential.size() + 2, ' ') +
            (weight > 0 ? exact[i] + std::string(weight - columns + 2, ' ') : "") +
            (style == Style::language ? "~ " : "≈ ") + source.decimal(e.coefficient, 8) + "\n";
  }
  if (c.errors.size() > count)
    text += "  ... and " + std::to_string(c.errors.size() - count) + " more (--json lists all)\n";
  const Norm n = norm(c, source);
  text += "  norm (root of the sum of squares) ";
  constexpr std::size_t kLongestExact = 60;
  if (const std::string squares = print(source.formula(n.squares));
      source.digits() == 0 && squares.size() <= kLongestExact)
    text += "sqrt(" + (style == Style::language ? squares : print(source.formula(n.squares), style)) + ") ";
  text += (style == Style::language ? "~ " : "≈ ") + Rational::from_double(n.value).significant(6) + "\n";
  return text + letters_text(c, source, style);
}

void add_structure(const OrderReport& r, const SeriesSource& source, nlohmann::ordered_json& json) {
  const auto property_json = [](const Property& p) {
    const char* words[] = {"proved", "refuted", "not contradicted"};
    return nlohmann::ordered_json{{"holds", p.holds()},
                                  {"verdict", words[static_cast<int>(p.verdict)]},
                                  {"trees_up_to", p.up_to},
                                  {"how", p.how}};
  };
  json["symmetric"] = property_json(r.structure.symmetric);
  json["symplectic"] = property_json(r.structure.symplectic);
  const auto or_null = [](const auto& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  };
  json["stage_order"] = or_null(r.structure.stage_order);
  json["embedded_order"] = or_null(r.structure.embedded_order);
  json["row_sums"] = or_null(r.structure.row_sums);
  json["conjugate_symplectic"] = r.structure.conjugate_symplectic
                                     ? property_json(*r.structure.conjugate_symplectic)
                                     : nlohmann::ordered_json(nullptr);
  json["energy_preserving"] = property_json(r.structure.energy_preserving);
  json["energy_change"] = {{"order", r.energy.order > 0 ? nlohmann::ordered_json(r.energy.order)
                                                        : nlohmann::ordered_json(nullptr)},
                           {"looked_at", r.energy.looked_at},
                           {"terms", nlohmann::ordered_json::array()}};
  for (const EnergyChange::Term& t : r.energy.terms)
    json["energy_change"]["terms"].push_back(
        {{"contraction", t.contraction}, {"coefficient", number_json(t.coefficient, source)}});
}

}  // namespace

bool OrderReport::cut_short() const {
  return std::ranges::any_of(order.classes, [](const OrderOfClass& c) { return !c.too_many.empty(); });
}

std::string as_text(const OrderReport& r, const SeriesSource& source, Style style) {
  std::string text = r.order.integrator + ": " + headline(r) + "\n  " + order_exactness(r.order) + "\n";
  for (const std::string& note : r.order.notes) text += "  " + note + "\n";
  text += "\n  forces                  order        conditions up to it\n";
  for (const OrderOfClass& c : r.order.classes) {
    std::string row = "  " + c.forces->force;
    row.resize(26, ' ');
    row += number_text(c);
    row.resize(39, ' ');
    text += row + std::to_string(c.conditions) +
            (c.by_the_start ? "   (what the start gets wrong allows no more)" : "") +
            (c.too_many.empty() ? "" : "   (" + c.too_many + ")") + "\n";
  }
  if (r.order.classes.size() == 1) return text + errors_text(shown(r), source, style);
  const Structure& s = r.structure;
  text += "\n  symmetric     " + property("symmetric", s.symmetric, r.order.digits) + "\n";
  text += "  symplectic    " + property("symplectic", s.symplectic, r.order.digits) + "\n";
  if (s.conjugate_symplectic)
    text += "    conjugate   " +
            property("conjugate to a symplectic step", *s.conjugate_symplectic, r.order.digits) + "\n";
  text += "  energy        " + energy_text(r, source, style) + "\n";
  if (s.stage_order) text += "  stage order   " + std::to_string(*s.stage_order) + "\n";
  if (s.embedded_order) text += "  embedded      order " + std::to_string(*s.embedded_order) + "\n";
  if (s.row_sums)
    text += std::string("  c = A 1       ") + (*s.row_sums ? "yes" : "no: some c is not the sum of its row") +
            "\n";
  if (r.processing.forces)
    text += "  effective     " +
            std::string(r.processing.effective_order > r.processing.plain_order
                            ? "order " + std::to_string(r.processing.effective_order) +
                                  " for a(x, t), with a launch and a read-out: shortfall correct " +
                                  r.order.integrator + " --force general"
                            : "no launch raises the order for a(x, t)") +
            "\n";
  return text + errors_text(shown(r), source, style);
}

nlohmann::ordered_json as_json(const OrderReport& r, const SeriesSource& source) {
  nlohmann::ordered_json json{{"schema", "shortfall.order/1"},
                              {"integrator", r.order.integrator},
                              {"order", r.order.classes.front().order}};
  json["classes"] = nlohmann::ordered_json::object();
  for (const OrderOfClass& c : r.order.classes) json["classes"][c.forces->key] = c.order;
  json["at_least"] = nlohmann::ordered_json::array();
  for (const OrderOfClass& c : r.order.classes)
    if (c.at_least) json["at_least"].push_back(c.forces->key);
  json["too_many_trees"] = nlohmann::ordered_json::object();
  for (const OrderOfClass& c : r.order.classes)
    if (!c.too_many.empty()) json["too_many_trees"][c.forces->key] = c.too_many;
  json["proved"] = r.order.digits == 0;
  json["digits"] =
      r.order.digits == 0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(r.order.digits);
  if (r.order.classes.size() == 1) json["class"] = r.order.classes.front().forces->key;
  json["effective_order"] = r.processing.forces ? nlohmann::ordered_json(r.processing.effective_order)
                                                : nlohmann::ordered_json(nullptr);
  if (r.order.classes.size() > 1) add_structure(r, source, json);
  const OrderOfClass& c = shown(r);
  json["error_forces"] = c.forces->key;
  json["error_of_start"] = c.by_the_start;
  json["error_terms"] = nlohmann::ordered_json::array();
  for (const ErrorTerm& e : c.errors)
    json["error_terms"].push_back({{"component", e.component},
                                   {"order", e.order},
                                   {"tree", e.tree},
                                   {"differential", e.differential},
                                   {"coefficient", number_json(e.coefficient, source)},
                                   {"decimal", source.decimal(e.coefficient, 20)}});
  const Norm n = norm(c, source);
  json["error_norm"] = {{"squared", number_json(n.squares, source)},
                        {"decimal", Rational::from_double(n.value).significant(12)}};
  json["notes"] = r.order.notes;
  return json;
}

}  // namespace shortfall
