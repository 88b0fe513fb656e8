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

/// What the first obstructions are, in words; the later ones have no names.
std::string name_of(int n, const std::vector<FieldTerm>& residual) {
  const auto is = [&](std::initializer_list<const char*> differentials) {
    return residual.size() == differentials.size() && std::ranges::all_of(residual, [&](const FieldTerm& t) {
             return t.coefficient == residual[0].coefficient &&
                    std::ranges::find(differentials, t.differential) != differentials.end();
           });
  };
  if (n == 2 && is({"a_x v", "a"}))
    return "the volume of phase space grows or shrinks with every step (under a spring, the energy), and no "
           "change of variables alters that";
  if (n == 2 && is({"a_v a"})) return "the force is given a velocity of another moment than its own";
  if (n == 3 && is({"a_x a", "a_x v"}))
    return "the commutators [A,[A,B]] and [[A,B],B] of drift A and kick B: a launch moves one into the "
           "other, "
           "and their sum stays";
  return "a combination of error coefficients that no launch changes";
}

template <class K>
class Processor {
 public:
  Processor(const SeriesSource& source, const ProcessingQuestion& question, Processing& result)
      : source_(source), question_(question), result_(result) {}

  /// Goes on to an order, from the beginning; false when it cannot.
  bool run(const TreeTable& table) {
    table_ = &table;
    result_.proved = source_.digits() == 0;
    force_ = the_equation<K>(table);
    generators_.clear();
    const OneStep<K> step = source_.step<K>(table, &force_);
    field_ = step.field;
    result_.plain_order = plain_order();
    start_order_ = table.order();
    for (TreeId t = table.size(); t-- > 0;)
      if (!source_.zero(Fraction(step.start[t]))) start_order_ = table.order(t);
    result_.plain_order = std::min(result_.plain_order, start_order_);
    for (int n = 2; n <= table.order(); ++n) {
      if (!remove_order(n)) return false;
      result_.effective_order = n;
    }
    return true;
  }

  /// What the integrator's own start gets wrong stays.
  void heed_start() {
    if (start_order_ >= result_.effective_order) return;
    result_.notes.push_back("the integrator's own start is of order " + std::to_string(start_order_) +
                            " only: started better, its effective order would be " +
                            std::to_string(result_.effective_order));
    result_.effective_order = start_order_;
    result_.complete = false;
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
    const Conjugation system(
        *table_, n, question_.correct_force ? forces_of_position(*table_, n) : std::vector<TreeId>{});
    std::vector<K> right;
    for (TreeId t : system.equations())
      right.push_back(source_.zero(Fraction(field_[t])) ? K(0) : K(0) - field_[t]);
    TreeSeries<K> c(table_->size(), K(0));
    const LinearSolution<K> found = system.template solved<K>(right);
    if (!found.solution) {
      obstruct(n, system, found.certificate, right);
      return false;
    }
    const std::vector<K>& solution = *found.solution;
    note_choices(n, found.free_unknowns.size());
    const std::size_t unknowns = system.unknowns().size();
    for (std::size_t i = 0; i < unknowns; ++i) c[system.unknowns()[i]] = solution[i];
    bool forced = false;
    for (std::size_t i = 0; i < system.free().size(); ++i)
      if (!vanishes(solution[unknowns + i])) {
        force_[system.free()[i]] += solution[unknowns + i];
        forced = true;
      }
    if (forced) {
      field_ = source_.step<K>(*table_, &force_).field;
      for (const TreeSeries<K>& earlier : generators_) field_ = conjugated(*table_, earlier, field_);
    }
    generators_.push_back(c);
    field_ = conjugated(*table_, c, field_);
    for (TreeId t : system.equations())
      if (!source_.zero(Fraction(field_[t])))
        throw Error("a launch that was solved for does not remove the errors of its order");
    return true;
  }

  /// Of order 2 the solution is unique up to a shift of time, which commutes with the flow that is aimed at.
  /// Where more is left open, another choice might go further, and where it stops is no proof.
  void note_choices(int n, std::size_t free) {
    if (free > (n == 2 ? 1u : 0u)) result_.proved = false;
  }

  void obstruct(int n, const Conjugation& system, const std::vector<K>& certificate,
                const std::vector<K>& right) {
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
    result_.obstructed_at = n;
    result_.obstruction = name_of(n, result_.residual);
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
  int start_order_ = 0;
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
    processor.heed_start();
    processor.put_result();
  });
  return result;
}

}  // namespace shortfall
