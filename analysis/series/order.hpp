// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/program/progress.hpp"
#include "analysis/series/step_series.hpp"

namespace shortfall {

/// A class of forces, as a signature: what is known of the force before it is chosen.
struct ForceClass {
  std::string key;    ///< "velocity_independent"
  std::string force;  ///< "a(x, t)"
  std::string words;  ///< "that does not read the velocity"
  Signature signature;
};

/// general, velocity-independent, autonomous, of the position alone, linear, of the time alone.
const std::vector<ForceClass>& force_classes();
/// By its key or its notation: "velocity_independent", "a(x, t)", "a(x,t)".
///
/// throws  BadInput  for another word, with a suggestion
const ForceClass& force_class(const std::string& word);

/// A tree whose coefficient is not that of the exact flow.
struct ErrorTerm {
  std::string tree;
  std::string differential;
  std::string component;  ///< whose error it is: "x", "v" or "y"
  int order;              ///< h^order
  Fraction coefficient;   ///< computed minus exact, in front of the differential
};

struct OrderOfClass {
  const ForceClass* forces = nullptr;
  /// Local errors of x and v are O(h^(order+1)), and so few h's are lost at the start.
  int order = 0;
  bool at_least = false;          ///< every condition that was looked at holds; there may be more
  std::string too_many = {};      ///< why no more could be looked at: a clause; empty when all asked for were
  bool by_the_start = false;      ///< the step itself may be of a higher order, the start is not
  std::size_t conditions = 0;     ///< trees up to the order, all of which hold
  std::vector<ErrorTerm> errors;  ///< of the order above; of what the start puts when by_the_start
};

/// How many terms of the exact series a step gets right, for each class of forces.
struct Order {
  std::string integrator;
  /// As in force_classes(), and separable_forces() where the step is made of kicks and drifts or a tableau.
  std::vector<OrderOfClass> classes;
  int digits = 0;  ///< 0: proved; otherwise coefficients are zero to so many digits
  std::vector<std::string> notes;

  const OrderOfClass& of(const std::string& key) const;
  /// Null when it was not looked at.
  const OrderOfClass* find(const std::string& key) const;
};

struct OrderLimits {
  int highest = 12;           ///< order up to which conditions are looked at
  double most_bytes = 200e6;  ///< for the trees
  TreeId most_trees = 30'000;
  Progress progress = {};
};

/// Why the trees up to an order are too many: a clause; empty when they fit.
std::string too_many_trees(const Signature& signature, int order, const OrderLimits& limits);

/// throws  Unable, Undefined  when the step has no series: see one_step.hpp
OrderOfClass order_of_class(const SeriesSource& source, const ForceClass& forces,
                            const OrderLimits& limits = {});
/// param   only  the class to look at; null for all
Order order(const SeriesSource& source, const OrderLimits& limits = {}, const ForceClass* only = nullptr);

/// The terms of one order of a difference of series that are not zero, as far as the coefficients are known.
template <class K>
std::vector<ErrorTerm> terms_of_order(const SeriesSource& source, const TreeTable& table, int order,
                                      const TreeSeries<K>& series);

}  // namespace shortfall
