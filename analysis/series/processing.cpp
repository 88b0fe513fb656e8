// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/processing.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/series/conjugation.hpp"
#include "analysis/series/differential.hpp"

namespace shortfall {

namespace {

/// Trees with the force at the root that read the position only, and contain no velocity: what an engine can
/// evaluate as a force.
bool is_of_position(const TreeTable& table, TreeId t) {
  if (table.function(t) != 0) return false;
  for (TreeId c : table.children(t)) {
    if (table.function(c) != 1 || table.is_node(c)) return false;
    if (!is_of_position(table, table.right(c))) return false;
  }
  return true;
}

std::vector<TreeId> forces_of_position(const TreeTable& table, int order) {
  std::vector<TreeId> result;
  for (TreeId t = table.begin(order); t < table.end(order); ++t)
    if (!table.is_node(t) && is_of_position(table, t)) result.push_back(t);
  return result;
}

template <class K>
class Processor {
 public:
  Processor(const SeriesSource& source, const ProcessingQuestion& question, Processing& result)
      : source_(source), question_(question), result_(result) {}

  /// Goes on to an order, from the beginning; false when it cannot.
  bool run(const TreeTable& table) {
    table_ = &table;
    force_ = the_equation<K>(table);
    generators_.clear();
    field_ = source_.step<K>(table, &force_).field;
    result_.plain_order = plain_order();
    for (int n = 2; n <= table.order(); ++n) {
      if (!remove_order(n)) return false;
      result_.effective_order = n;
    }
    return true;
  }

  void put_result() {
    const int order = std::max(result_.effective_order, 1);
    // What a launch gets wrong by h^order changes the error no more than the order allows.
    put(launch(), order - 1, result_.launch, 0);
    put(inverse(*table_, launch()), order - 1, result_.read_out, 0);
    TreeSeries<K> force = force_;
    for (TreeId t = 0; t < table_->size(); ++t)
      if (table_->is_node(t)) force[t] = K(0);
    put(force, order, result_.force, 1);
    for (const TreeSeries<K>& c : generators_) put(c, order, result_.generators, 0);
  }

 private:
  int plain_order() const {
    for (TreeId t = 0; t < table_->size(); ++t) {
      const K expected(table_->is_node(t) ? 1 : 0);
      if (!source_.zero(Fraction(field_[t] - expected))) return table_->order(t) - 1;
    }
    return table_->order();
  }

  bool remove_order(int n) {
    const Conjugation system(*table_, n,
                             question_.correct_force ? forces_of_position(*table_, n) : std::vector<TreeId>{});
    std::vector<K> right;
    bool nothing = true;
    for (TreeId t : system.equations()) {
      right.push_back(source_.zero(Fraction(field_[t])) ? K(0) : K(0) - field_[t]);
      nothing = nothing && vanishes(right.back());
    }
    TreeSeries<K> c(table_->size(), K(0));
    if (!nothing) {
      const LinearSolution<K> found = system.template solved<K>(right);
      if (!found.solution) {
        obstruct(n, system, found.certificate, right);
        return false;
      }
      const std::vector<K>& solution = *found.solution;
      const std::size_t unknowns = system.unknowns().size();
      for (std::size_t i = 0; i < unknowns; ++i) c[system.unknowns()[i]] = solution[i];
      bool forced = false;
      for (std::size_t i = 0; i < system.free().size(); ++i)
        if (!vanishes(solution[unknowns + i])) {
          // The equations have [c, F] + free = -L: the free part is taken off the force's tree.
          force_[system.free()[i]] += K(0) - (K(0) - solution[unknowns + i]);
          forced = true;
        }
      if (forced) {
        field_ = source_.step<K>(*table_, &force_).field;
        for (const TreeSeries<K>& earlier : generators_) field_ = conjugated(*table_, earlier, field_);
      }
    }
    generators_.push_back(c);
    field_ = conjugated(*table_, c, field_);
    for (TreeId t : system.equations())
      if (!source_.zero(Fraction(field_[t])))
        throw Error("a launch that was solved for does not remove the errors of its order");
    return true;
  }

  void obstruct(int n, const Conjugation& system, const std::vector<K>& certificate, const std::vector<K>& right) {
    Fraction value;
    TreeSeries<K> weights(table_->size(), K(0));
    for (std::size_t i = 0; i < certificate.size(); ++i) {
      if (vanishes(certificate[i])) continue;
      weights[system.equations()[i]] = certificate[i];
      value -= Fraction(certificate[i]) * Fraction(right[i]);
    }
    for (TreeId t : system.equations())
      if (!vanishes(weights[t])) {
        FieldTerm term = described(t, Fraction(weights[t]), 0);
        result_.residual.push_back(std::move(term));
      }
    result_.residual_value = value;
    result_.obstruction = "no launch removes the errors of order h^" + std::to_string(n) + " (per step)";
  }

  TreeSeries<K> launch() const {
    TreeSeries<K> map(table_->size(), K(0));
    for (const TreeSeries<K>& c : generators_) map = composition(*table_, exponential(*table_, c), map);
    return map;
  }

  FieldTerm described(TreeId t, const Fraction& coefficient, int less) const {
    return {table_->signature().components[table_->component(t)],
            table_->order(t) - less,
            tree_text(*table_, t),
            differential(*table_, t),
            differential(*table_, t, true),
            coefficient};
  }

  void put(const TreeSeries<K>& series, int order, std::vector<FieldTerm>& terms, int less) const {
    for (TreeId t = 0; t < table_->size(); ++t) {
      if (table_->order(t) > order || source_.zero(Fraction(series[t]))) continue;
      terms.push_back(described(t, Fraction(series[t]) / Fraction(table_->symmetry(t)), less));
    }
  }

  const SeriesSource& source_;
  const ProcessingQuestion& question_;
  Processing& result_;
  const TreeTable* table_ = nullptr;
  TreeSeries<K> force_, field_;
  std::vector<TreeSeries<K>> generators_;
};

}  // namespace

Processing processing(const SeriesSource& source, const ProcessingQuestion& question) {
  Processing result;
  result.integrator = source.program().name;
  result.forces = question.forces;
  result.digits = source.digits();
  result.notes = source.notes();
  const int order = question.order > 0 ? question.order : question.highest;
  const TreeTable table(question.forces->signature, order, question.limits.most_bytes);
  with_coefficients(source, [&]<class K>() {
    Processor<K> processor(source, question, result);
    result.effective_order = 1;
    result.complete = processor.run(table);
    if (result.plain_order == 0) throw Undefined("the step is not consistent: it is of no order");
    processor.put_result();
  });
  return result;
}

}  // namespace shortfall
