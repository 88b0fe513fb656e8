// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/order.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/general_text.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/series/differential.hpp"
#include "analysis/series/separable_order.hpp"

namespace shortfall {

namespace {

Signature linear_forces() {
  Signature s = Signature::mechanical(true, true);
  s.functions[0].most = 1;
  return s;
}

Signature forces_of_time() {
  Signature s = Signature::mechanical(false, true);
  std::erase_if(s.functions[0].reads, [](const Signature::Slot& slot) { return slot.component == 0; });
  return s;
}

/// With a tableau every rooted tree of y' = f(y) is one of a(x, v) as well, and the other way round: the
/// conditions are the same, and there are fewer of them.
Signature signature_for(const SeriesSource& source, const ForceClass& forces) {
  if (source.has_tableau() && forces.key == "general") return Signature::first_order_with_time();
  if (source.has_tableau() && forces.key == "autonomous") return Signature::first_order();
  return forces.signature;
}

}  // namespace

std::string too_many_trees(const Signature& signature, int order, const OrderLimits& limits) {
  const double bytes = TreeTable::bytes_needed(signature, order);
  const std::string head = "order " + std::to_string(order) + " has ";
  if (bytes > limits.most_bytes)
    return head + "trees of " + general_text(bytes / 1e6, 3) + " MB; " +
           general_text(limits.most_bytes / 1e6, 3) + " MB are allowed";
  Rational trees;
  for (std::size_t f = 0; f < signature.functions.size(); ++f)
    for (const Rational& count : tree_counts(signature, static_cast<int>(f), order)) trees += count;
  if (trees <= Rational(limits.most_trees)) return {};
  return head + trees.str() + " trees; at most " + std::to_string(limits.most_trees) + " are looked at";
}

template <class K>
std::vector<ErrorTerm> terms_of_order(const SeriesSource& source, const TreeTable& table, int order,
                                      const TreeSeries<K>& series) {
  std::vector<ErrorTerm> errors;
  for (TreeId t = table.begin(order); t < table.end(order); ++t) {
    if (vanishes(series[t])) continue;
    const Fraction coefficient = Fraction(series[t]) / Fraction(table.symmetry(t));
    if (source.zero(Fraction(series[t]))) continue;
    errors.push_back({tree_text(table, t), differential(table, t),
                      table.signature().components[table.component(t)], order, coefficient});
  }
  return errors;
}

template std::vector<ErrorTerm> terms_of_order(const SeriesSource&, const TreeTable&, int,
                                               const TreeSeries<Rational>&);
template std::vector<ErrorTerm> terms_of_order(const SeriesSource&, const TreeTable&, int,
                                               const TreeSeries<Fraction>&);

const std::vector<ForceClass>& force_classes() {
  static const std::vector<ForceClass> classes{
      {"general", "a(x, v, t)", "every smooth force", Signature::mechanical(true, true)},
      {"velocity_independent", "a(x, t)", "forces that do not read the velocity",
       Signature::mechanical(false, true)},
      {"autonomous", "a(x, v)", "forces that do not read the time", Signature::mechanical(true, false)},
      {"position_only", "a(x)", "forces of the position alone", Signature::mechanical(false, false)},
      {"linear", "-K x - C v + g + b t", "linear forces", linear_forces()},
      {"time_only", "a(t)", "forces of the time alone", forces_of_time()}};
  return classes;
}

const ForceClass& force_class(const std::string& word) {
  std::string notation;
  for (char c : word)
    if (c != ' ') notation += c == '-' && word.find('(') == std::string::npos ? '_' : c;
  std::vector<std::string> words;
  for (const ForceClass& c : force_classes()) {
    std::string theirs = c.force;
    std::erase(theirs, ' ');
    if (c.key == notation || theirs == notation) return c;
    words.push_back(c.key);
    words.push_back(theirs);
  }
  throw BadInput("no class of forces is called '" + word.substr(0, 60) + "'" + did_you_mean(word, words) +
                 "; there are general, velocity_independent, autonomous, position_only, linear, time_only, "
                 "or a(x, v, t), a(x, t), a(x, v), a(x), a(t)");
}

const OrderOfClass* Order::find(const std::string& key) const {
  for (const OrderOfClass& c : classes)
    if (c.forces->key == key) return &c;
  return nullptr;
}

const OrderOfClass& Order::of(const std::string& key) const {
  if (const OrderOfClass* c = find(key)) return *c;
  throw BadInput("no class of forces is called '" + key + "'");
}

OrderOfClass order_of_class(const SeriesSource& source, const ForceClass& forces, const OrderLimits& limits) {
  const Signature signature = signature_for(source, forces);
  OrderOfClass result;
  result.forces = &forces;
  result.at_least = true;
  for (int n = 1; n <= limits.highest; ++n) {
    result.too_many = too_many_trees(signature, n, limits);
    if (!result.too_many.empty()) break;
    if (limits.progress) limits.progress("order for " + forces.force, n, limits.highest);
    const TreeTable table(signature, n, limits.most_bytes);
    std::vector<ErrorTerm> errors, start;
    with_coefficients(source, [&]<class K>() {
      const OneStep<K> step = source.step<K>(table);
      const TreeSeries<K> exact = exact_flow<K>(table);
      TreeSeries<K> difference = step.map;
      for (TreeId t = table.begin(n); t < table.end(n); ++t) difference[t] -= exact[t];
      errors = terms_of_order(source, table, n, difference);
      start = terms_of_order(source, table, n, step.start);
    });
    if (!errors.empty()) {
      result.at_least = false;
      result.errors = std::move(errors);
      return result;
    }
    result.order = n;
    result.conditions = static_cast<std::size_t>(table.size());
    if (!start.empty()) {
      result.at_least = false;
      result.by_the_start = true;
      result.errors = std::move(start);
      return result;
    }
  }
  return result;
}

Order order(const SeriesSource& source, const OrderLimits& limits, const ForceClass* only) {
  Order result;
  result.integrator = source.program().name;
  result.digits = source.digits();
  result.notes = source.notes();
  for (const ForceClass& forces : force_classes())
    if (!only || only == &forces) result.classes.push_back(order_of_class(source, forces, limits));
  if (!only || only == &separable_forces()) {
    const SeparableOrder found = separable_order(source, limits);
    if (found.order) result.classes.push_back(*found.order);
    if (only && !found.order) throw Unable(found.why_not);
  }
  return result;
}

}  // namespace shortfall
