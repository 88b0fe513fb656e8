// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/derivation_steps.hpp"

#include <algorithm>

#include "analysis/motion/faulhaber.hpp"
#include "analysis/motion/line_check.hpp"

namespace shortfall {

namespace {

class Writer {
 public:
  Writer(const Derivation& d, bool has_finish, const Progress& progress)
      : d_(d),
        has_finish_(has_finish),
        quantities_(story(d.map)),
        points_(d.proof.recurrence + 2),
        check_(d.map, quantities_, d.degree, points_ + d.map.force.states + 2, progress),
        in_n_{d.map.letters, "n", false},
        in_k_{d.map.letters, "k", false},
        in_t_{d.map.letters, "n", true} {}

  std::vector<DerivationStep> written() {
    for (std::size_t q = 0; q < quantities_.size(); ++q) {
      closed_.push_back(closed(quantities_[q]));
      settled_.push_back(settled(static_cast<int>(q)));
      tell(static_cast<int>(q));
    }
    if (has_finish_) tell_read_out();
    tell_exact();
    return std::move(steps_);
  }

 private:
  int columns() const { return 2 + d_.degree + 1; }
  int source(int column) const { return column < 2 ? column : d_.map.force.force_column(column - 2); }

  void add(Expr left, Expr right, std::string why, const std::string& index, int from) {
    const bool proved = check_.agree(left, right, index, from, from + points_ - 1);
    steps_.push_back({std::move(left), std::move(right), std::move(why), points_, proved});
  }

  Motion closed(const Quantity& q) const {
    Motion motion(columns());
    for (int s = 0; s < d_.map.force.states; ++s)
      if (!q.definition[s].is_zero())
        for (int c = 0; c < columns(); ++c) motion[c] += Sequence(q.definition[s]) * d_.form.states[s][c];
    return motion;
  }

  LinearForm at(const Motion& motion, int n) const {
    LinearForm value;
    for (int c = 0; c < columns(); ++c) value.at(source(c)) = motion[c].at(n);
    return value;
  }

  /// The first step from which on the closed form of a quantity holds.
  int settled(int q) const {
    for (int n = d_.map.force.states; n > 0; --n)
      if (!(at(closed_[q], n - 1) == check_.quantity(q, n - 1))) return n;
    return 0;
  }

  Expr as_formula(const LinearForm& value, const Wording& w) const {
    Motion motion;
    for (int c = 0; c < columns(); ++c) motion.emplace_back(value[source(c)]);
    return formula(motion, d_.degree, w);
  }

  /// weights * quantities + drive at step k, quantities by name.
  Expr increase(const Quantity& q) const {
    Expr total = number(0);
    for (const auto& [other, weight] : q.weights)
      total = joined(total, formula(weight, name(quantities_[other].name + "_k"), in_k_));
    for (int d = 0; d <= d_.degree; ++d) {
      const Expr part = formula(q.drive[source(2 + d)], name(column_name(2 + d, d_.degree)), in_k_);
      total = joined(total, part);
    }
    return total;
  }

  void tell(int index) {
    const Quantity& q = quantities_[index];
    const Expr next = name(q.name + "_{k+1}");
    const Expr now = name(q.name + "_k");
    const Expr after_n = name(q.name + "_n");
    const Expr gathered = formula(closed_[index], d_.degree, in_t_);
    const bool is_difference =
        q.definition.columns() > 1 && std::ranges::find(d_.map.states, q.name) == d_.map.states.end();
    if (is_difference) {
      Expr definition = number(0);
      for (int s = 0; s < d_.map.force.states; ++s)
        definition = joined(definition, formula(q.definition[s], name(d_.map.states[s] + "_k"), in_k_));
      add(now, definition, "call the increase of the last step " + q.name, "k", 0);
    }
    if (!q.solvable) {
      add(after_n, gathered, "by the eigenvalues of the step, which are known exactly", "n", settled_[index]);
      return;
    }
    const Expr change = increase(q);
    if (q.self.is_zero()) {
      add(next, change, "one step, written out: " + q.name + " is carried along and made anew in each step",
          "k", 0);
      add(after_n, gathered, "so it is known at every step" + from_text(settled_[index]), "n",
          settled_[index]);
    } else if (q.self == Fraction(1)) {
      tell_sum(index, next, now, after_n, change, gathered);
    } else {
      add(next, joined(formula(q.self, now, in_k_), change), "one step, written out", "k", 0);
      add(after_n, gathered,
          "a geometric sum: each step multiplies by the same factor" + from_text(settled_[index]), "n",
          settled_[index]);
    }
  }

  static std::string from_text(int n) { return n == 0 ? "" : " from n = " + std::to_string(n) + " on"; }

  void tell_sum(int index, const Expr& next, const Expr& now, const Expr& after_n, const Expr& change,
                const Expr& gathered) {
    const Quantity& q = quantities_[index];
    add(next, joined(now, change), "one step, written out", "k", 0);
    int begin = 0;
    for (const auto& [other, weight] : q.weights) begin = std::max(begin, settled_[other]);
    const Expr first = as_formula(check_.quantity(index, begin), in_n_);
    if (is_number(change, 0)) {
      add(after_n, gathered, "nothing changes it", "n", begin);
      return;
    }
    const Expr from = number(begin);
    const Expr to = name("n") - number(1);
    add(after_n, joined(first, sum("k", from, to, change)),
        "unroll: each step adds to the one before" + from_text(begin), "n", begin);

    Motion summand(columns());
    for (const auto& [other, weight] : q.weights)
      for (int c = 0; c < columns(); ++c) summand[c] += Sequence(weight) * closed_[other][c];
    for (int c = 2; c < columns(); ++c) summand[c] += Sequence(q.drive[source(c)]);
    const bool polynomial = std::ranges::all_of(summand, [](const Sequence& s) { return s.is_polynomial(); });
    if (!q.weights.empty())
      add(after_n, joined(first, sum("k", from, to, formula(summand, d_.degree, in_k_))),
          "put in what is known", "n", begin);
    if (!polynomial) {
      add(after_n, gathered,
          "Faulhaber's sums for the powers of k, geometric sums for the rest" + from_text(begin), "n",
          settled_[index]);
      return;
    }
    int highest = 0;
    Expr pulled = first;
    Expr added_up = first;
    for (int c = 0; c < columns(); ++c) {
      const Fraction p = summand[c].polynomial();
      const int degree = p.numerator().degree(kCount);
      for (int m = degree; m >= 0; --m) {
        const Fraction constant(p.numerator().coefficient(kCount, m), p.denominator());
        if (constant.is_zero()) continue;
        highest = std::max(highest, m);
        append_product(pulled, constant, c, sum("k", from, to, m == 0 ? number(1) : power(name("k"), m)));
        append_product(added_up, constant, c, power_sum(m, begin));
      }
    }
    add(after_n, pulled, "the constants come out of the sums", "n", begin);
    add(after_n, added_up, sum_text(highest), "n", begin);
    if (print_differs(added_up, gathered)) add(after_n, gathered, "gather n h = t", "n", begin);
  }

  /// total + constant * letter * factor, the constant's terms in parentheses when there are several.
  void append_product(Expr& total, const Fraction& constant, int column, const Expr& factor) const {
    const Expr letter = name(column_name(column, d_.degree));
    const bool single = constant.is_polynomial() && constant.numerator().terms().size() == 1;
    const bool negative = single && constant.numerator().terms().front().coefficient.sign() < 0;
    Expr product =
        single ? formula(negative ? -constant : constant, letter, in_n_) : formula(constant, in_n_) * letter;
    product = chained(product, factor);
    total = is_number(total, 0) ? (negative ? negate(product) : product)
            : negative          ? total - product
                                : total + product;
  }

  /// begin^m + ... + (n-1)^m as a person writes it.
  static Expr power_sum(int m, int begin) {
    Expr n = name("n");
    if (begin == 0 && m == 0) return n;
    if (begin == 0 && m == 1) return n * (n - number(1)) / number(2);
    if (begin == 0 && m == 2) return n * (n - number(1)) * (number(2) * n - number(1)) / number(6);
    const auto sums = power_sums(m);
    Rational offset;
    Rational power_of_begin = 1;
    Expr total = number(0);
    for (const Rational& c : sums[m]) {
      offset += c * power_of_begin;
      power_of_begin *= begin;
    }
    for (int j = m + 1; j >= 1; --j) {
      const Rational& c = sums[m][j];
      if (c.is_zero()) continue;
      const Expr term = number(c.abs()) * power(n, j);
      total = c.sign() < 0 ? total - term : total + term;
    }
    return offset.sign() > 0 ? total - number(offset) : total + number(-offset);
  }

  static std::string sum_text(int highest) {
    if (highest == 0) return "a sum of n equal terms";
    if (highest == 1) return "Gauss: 0 + 1 + ... + (n-1) = n (n-1)/2";
    if (highest == 2) return "Gauss for k, Faulhaber for k^2: 0 + 1 + 4 + ... + (n-1)^2 = n (n-1) (2n-1)/6";
    return "Gauss and Faulhaber: the sum of k^m is a polynomial in n of degree m + 1, with Bernoulli's "
           "numbers";
  }

  static bool print_differs(const Expr& a, const Expr& b) { return !same(a, b); }

  void tell_read_out() {
    const int from = d_.form.valid_from;
    for (const auto& [left, result] : {std::pair{"x_out", &d_.position}, {"v_out", &d_.velocity}}) {
      if (reported_name(std::string(1, left[0])) != left) continue;
      add(name(left), *result, "finish: what is reported after the last step", "n", from);
    }
  }

  /// What the reported vector is called: carried and reported ones differ when there is a finish.
  std::string reported_name(const std::string& stem) const {
    const LinearForm& row = stem == "x" ? d_.map.position : d_.map.velocity;
    const bool plain = row == LinearForm::column(stem == "x" ? 0 : 1);
    return stem + (plain ? "_n" : "_out");
  }

  void tell_exact() {
    add(name("x(t)"), d_.exact_position, "the true motion: integrate the force twice", "n", 0);
    add(name("v(t)"), d_.exact_velocity, "and once for the velocity", "n", 0);
    add(name("x(t)") - name(reported_name("x")), d_.shortfall_position,
        "subtract: the shortfall of the position, at t = n h", "n", d_.form.valid_from);
    add(name("v(t)") - name(reported_name("v")), d_.shortfall_velocity, "and of the velocity", "n",
        d_.form.valid_from);
  }

  const Derivation& d_;
  bool has_finish_;
  std::vector<Quantity> quantities_;
  int points_;
  LineCheck check_;
  Wording in_n_;
  Wording in_k_;
  Wording in_t_;
  std::vector<Motion> closed_;
  std::vector<int> settled_;
  std::vector<DerivationStep> steps_;
};

}  // namespace

std::vector<DerivationStep> derivation_steps(const Derivation& derivation, bool has_finish,
                                             const Progress& progress) {
  return Writer(derivation, has_finish, progress).written();
}

}  // namespace shortfall
