// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/tableau_claims.hpp"

#include <algorithm>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/audit/structure.hpp"
#include "analysis/audit/tableau_stability.hpp"
#include "analysis/motion/agreement.hpp"
#include "analysis/series/differential.hpp"

namespace shortfall {

namespace {

using Verdict = AuditClaim::Verdict;

constexpr int kShownDigits = 6;
constexpr int kStructureOrder =
    8;  // at least: trees that show a tableau not to be symmetric have few nodes more than its order
constexpr int kHighestStructureOrder = 11;

/// How many digits of a nothing are certain; 0 when it is exact.
int certain(const KnownDigits& k) { return k.ball().is_exact() ? 0 : k.digits(); }
int certain(const Rational&) { return 0; }
int certain(const Fraction&) { return 0; }

void keep_lowest(int& digits, int other) {
  if (other > 0) digits = digits == 0 ? other : std::min(digits, other);
}

template <class K>
class Findings {
 public:
  Findings(const AuditedTableau& t, const Method<K>& m, const AuditLimits& limits)
      : t_(t), m_(m), limits_(limits) {}

  TableauFindings operator()() {
    result_.digits = printed_digits(t_.program);
    row_sums();
    orders();
    stage_order();
    structure();
    stability();
    return std::move(result_);
  }

 private:
  struct FoundOrder {
    int order = 0;
    bool at_least = false;
    int digits = 0;
    std::vector<std::string> failing;
    std::size_t count = 0;  ///< conditions of the next order that fail
  };

  AuditClaim& claim(const std::string& words, Verdict verdict, const std::string& found, Place place) {
    result_.claims.push_back({words, verdict, found, {}, 0, true, true, place});
    return result_.claims.back();
  }

  void row_sums() {
    if (t_.nystroem || !t_.c_given) return;
    Demands demands;
    const Conditions conditions(demands, t_.stages(), false, limits_.most_bytes);
    const std::vector<K> defects = conditions.defects(m_);
    AuditClaim& c = claim("c = A 1", Verdict::holds, "c = A 1", {});
    c.stated = false;
    for (std::size_t i = 0; i < defects.size(); ++i) {
      keep_lowest(c.digits, certain(defects[i]));
      if (is_nothing(defects[i])) continue;
      c.verdict = Verdict::refuted;
      c.reasons.push_back("row " + std::to_string(i + 1) + " of A sums to " +
                          number_text(t_, defects[i] + m_.c[i]) + ", c[" + std::to_string(i + 1) + "] is " +
                          number_text(t_, m_.c[i]));
    }
    if (c.verdict == Verdict::refuted) {
      c.found = "c differs from A 1";
      c.digits = 0;
      sums_fail_ = true;
    }
  }

  /// The condition of a tree, as a reader wants it.
  std::string failing(const TreeTable& trees, TreeId tree, const K& weight, const K& exact) const {
    const std::string of =
        t_.nystroem ? std::string(trees.function(tree) == 0 ? "velocity, " : "position, ") : "";
    const K defect = weight - exact;
    return of + differential(trees, tree) + ": weight " + number_text(t_, weight) + ", wanted " +
           (Rational(1) / trees.density(tree)).str() + "; off by " + number_text(t_, defect);
  }

  FoundOrder order_of(const std::vector<K>& weights, const std::vector<K>& position, int enough,
                      bool with_time = false) const {
    FoundOrder found;
    const Signature signature = t_.nystroem ? Signature::mechanical(false, true)
                                : with_time ? Signature::first_order_with_time()
                                            : Signature::first_order();
    for (int n = 1; n <= enough; ++n) {
      if (limits_.progress) limits_.progress("conditions of order " + std::to_string(n), n, enough);
      if (TreeTable::bytes_needed(signature, n) * (1 + static_cast<double>(t_.stages()) / 2) >
          limits_.most_bytes) {
        found.at_least = true;
        return found;
      }
      const TreeTable trees(signature, n, limits_.most_bytes);
      const auto map = result_weights(m_, trees, stage_derivatives(m_, trees), weights, position);
      for (TreeId tree = trees.begin(n); tree < trees.end(n); ++tree) {
        const bool counts = trees.function(tree) == 0 || (t_.nystroem && !trees.is_node(tree));
        if (!counts) continue;
        const K exact(Rational(1) / trees.density(tree)), defect = map[tree] - exact;
        if (is_nothing(defect)) {
          keep_lowest(found.digits, certain(defect));
          continue;
        }
        if (++found.count <= kMostReasons) found.failing.push_back(failing(trees, tree, map[tree], exact));
      }
      if (found.count > 0) return found;
      found.order = n;
    }
    found.at_least = true;
    return found;
  }

  void order_claim(const std::string& word, const std::optional<Stated<int>>& stated,
                   const FoundOrder& found) {
    if (!stated) {
      result_.facts.push_back(word + " " + std::to_string(found.order) + (found.at_least ? " or more" : "") +
                              (found.digits > 0 ? " (to " + std::to_string(found.digits) + " digits)" : ""));
      return;
    }
    const bool unknown = found.at_least && found.order < stated->value;
    AuditClaim& c =
        claim(word + " " + std::to_string(stated->value),
              unknown                        ? Verdict::undecided
              : found.order == stated->value ? Verdict::holds
                                             : Verdict::refuted,
              unknown ? "the conditions up to order " + std::to_string(found.order) +
                            " hold; the trees of the next order need more than the memory allowed"
                      : word + " " + std::to_string(found.order) + (found.at_least ? " or more" : ""),
              stated->place);
    c.digits = found.digits;
    if (c.verdict != Verdict::refuted || found.order > stated->value) return;
    c.reasons = found.failing;
    if (found.count > c.reasons.size())
      c.reasons.push_back("and " + std::to_string(found.count - c.reasons.size()) + " more of order " +
                          std::to_string(found.order + 1));
  }

  void orders() {
    const int most = static_cast<int>(std::min<std::size_t>(2 * t_.stages() + 1, kHighestClaimedOrder + 1));
    const auto enough = [&](const std::optional<Stated<int>>& c) {
      return c ? c->value + 1 : std::min(most, 13);
    };
    const FoundOrder order = order_of(m_.b, m_.b_position, enough(t_.claims.order));
    order_claim("order", t_.claims.order, order);
    result_.order = order.order;
    result_.order_at_least = order.at_least;
    if (sums_fail_) {
      const FoundOrder timed = order_of(m_.b, m_.b_position, order.order + 1, true);
      result_.facts.push_back("order " + std::to_string(timed.order) +
                              " for y' = f(y, t), where the times c count");
    }
    if (m_.embedded.empty()) return;
    const FoundOrder embedded = order_of(m_.embedded, m_.embedded_position, enough(t_.claims.embedded_order));
    order_claim("embedded order", t_.claims.embedded_order, embedded);
    result_.embedded_order = embedded.order;
  }

  void stage_order() {
    if (t_.nystroem) return;
    int q = 0, digits = 0;
    std::string reason;
    const int most = static_cast<int>(2 * t_.stages());
    for (int k = 1; k <= most && reason.empty(); ++k) {
      std::vector<K> row = m_.b, powers;
      K sum = K(0) - K(Rational(1, k));
      std::vector<K> rows(t_.stages(), K(0));
      for (std::size_t j = 0; j < t_.stages(); ++j) {
        K below(1);
        for (int n = 1; n < k; ++n) below *= m_.c[j];
        sum += m_.b[j] * below;
        rows[j] -= below * m_.c[j] / K(k);
        powers.push_back(std::move(below));
      }
      for (std::size_t i = 0; i < t_.stages(); ++i)
        for (std::size_t j = 0; j < t_.stages(); ++j) rows[i] += m_.a[i][j] * powers[j];
      const std::string power = k == 1 ? "1" : k == 2 ? "c" : "c^" + std::to_string(k - 1);
      const auto look = [&](const K& defect, const std::string& what) {
        if (!is_nothing(defect) && reason.empty())
          reason = what + " " + power + " is off by " + number_text(t_, defect);
        keep_lowest(digits, certain(defect));
      };
      look(sum, "b");
      for (std::size_t i = 0; i < t_.stages(); ++i)
        look(rows[i], "row " + std::to_string(i + 1) + " of A times");
      if (reason.empty()) q = k;
    }
    const auto& stated = t_.claims.stage_order;
    if (!stated) {
      result_.facts.push_back("stage order " + std::to_string(q));
      return;
    }
    AuditClaim& c = claim("stage order " + std::to_string(stated->value),
                          q == stated->value ? Verdict::holds : Verdict::refuted,
                          "stage order " + std::to_string(q), stated->place);
    if (q < stated->value) c.reasons.push_back(reason);
    if (q == stated->value) c.digits = digits;
  }

  /// Whether the equations for the entries hold, which is enough.
  bool equations_hold(bool symplectic, int& digits, std::string& where) const {
    Demands demands;
    demands.row_sums = false;
    demands.symplectic = symplectic;
    demands.symmetric = !symplectic;
    const Conditions conditions(demands, t_.stages(), t_.nystroem, limits_.most_bytes);
    const std::vector<K> defects = conditions.defects(m_);
    for (std::size_t k = 0; k < defects.size(); ++k) {
      if (is_nothing(defects[k])) {
        keep_lowest(digits, certain(defects[k]));
        continue;
      }
      const Condition& q = conditions.list()[k];
      where = std::string(symplectic ? "b_i a_ij + b_j a_ji - b_i b_j" : "the equation of symmetry") +
              " at i = " + std::to_string(q.i + 1) +
              ", j = " + std::to_string(std::min(q.j, t_.stages() - 1) + 1) + " is " +
              number_text(t_, defects[k]);
      return false;
    }
    return true;
  }

  int structure_order() const {
    return std::clamp(result_.order + 2, kStructureOrder, kHighestStructureOrder);
  }

  /// Trees show that it is not so, whatever stages a tableau has too many.
  std::optional<std::string> shown_not(bool symplectic) const {
    return symplectic ? not_symplectic(m_, structure_order()) : not_symmetric(m_, structure_order());
  }

  void structure(const std::string& word, bool symplectic, const std::optional<Stated<bool>>& stated) {
    int digits = 0;
    std::string where;
    const bool holds = equations_hold(symplectic, digits, where);
    if (!stated) {
      if (holds)
        result_.facts.push_back(word + (digits > 0 ? " (to " + std::to_string(digits) + " digits)" : ""));
      return;
    }
    const std::string claimed = (stated->value ? "" : "not ") + word;
    if (holds) {
      claim(claimed, stated->value ? Verdict::holds : Verdict::refuted, word, stated->place).digits = digits;
      return;
    }
    const auto shown = shown_not(symplectic);
    const bool decided = shown.has_value();
    AuditClaim& c = claim(claimed,
                          !decided        ? Verdict::undecided
                          : stated->value ? Verdict::refuted
                                          : Verdict::holds,
                          decided ? "not " + word
                                  : "the equations for the entries fail, but trees up to order " +
                                        std::to_string(structure_order()) + " show nothing",
                          stated->place);
    if (stated->value) {
      c.reasons.push_back(where);
      if (shown) c.reasons.push_back(*shown);
    }
    if (decided) c.digits = t_.numbers == AuditedTableau::Numbers::digits ? result_.digits : 0;
  }

  void structure() {
    structure("symplectic", true, t_.claims.symplectic);
    structure("symmetric", false, t_.claims.symmetric);
  }

  void stability() {
    const auto& a = t_.claims.a_stable;
    const auto& l = t_.claims.l_stable;
    if (!a && !l) return;
    std::optional<TableauStability> s;
    std::string why = "a Nystroem tableau has no stability function for y' = lambda y";
    try {
      s = tableau_stability(t_);
    } catch (const Error& e) {
      why = e.what();
    }
    const auto put = [&](const std::string& word, const std::optional<Stated<bool>>& stated, bool found) {
      if (!stated) return;
      const std::string claimed = (stated->value ? "" : "not ") + word;
      if (!s) {
        claim(claimed, Verdict::undecided, why, stated->place);
        return;
      }
      AuditClaim& c = claim(claimed, found == stated->value ? Verdict::holds : Verdict::refuted,
                            (found ? "" : "not ") + word, stated->place);
      c.digits = s->digits;
      if (stated->value && !found) c.reasons.push_back(s->why);
    };
    put("A-stable", a, s && s->a_stable);
    put("L-stable", l, s && s->l_stable);
  }

  const AuditedTableau& t_;
  const Method<K>& m_;
  const AuditLimits& limits_;
  TableauFindings result_;
  bool sums_fail_ = false;
};

}  // namespace

std::string number_text(const AuditedTableau&, const Rational& value) {
  return value.digits() <= 24 ? value.str() : "≈ " + value.significant(kShownDigits);
}
std::string number_text(const AuditedTableau& t, const Fraction& value) {
  const std::string text = t.formula(value);
  return text.size() <= 48 ? text : "≈ " + t.near(value).ball().midpoint().significant(kShownDigits);
}
std::string number_text(const AuditedTableau&, const KnownDigits& value) {
  if (value.ball().is_exact()) return value.ball().midpoint().str();
  return "≈ " + value.ball().midpoint().significant(kShownDigits);
}

TableauFindings findings(const AuditedTableau& t, const AuditLimits& limits) {
  return with_numbers(t, [&]<class K>(const Method<K>& m) { return Findings<K>(t, m, limits)(); });
}

Demands demands_of(const AuditedTableau& t) {
  const TableauClaims& c = t.claims;
  const auto is_true = [](const std::optional<Stated<bool>>& b) { return b && b->value; };
  return {c.order ? c.order->value : 0,
          c.embedded_order ? c.embedded_order->value : 0,
          c.stage_order && !t.nystroem ? c.stage_order->value : 0,
          t.c_given && !t.nystroem,
          is_true(c.symplectic),
          is_true(c.symmetric)};
}

}  // namespace shortfall
