// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/identification.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/experiments.hpp"
#include "analysis/identify/match.hpp"
#include "analysis/identify/segments.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kNearest = 3;
constexpr std::size_t kFewestRows = 4;

class Identifying {
 public:
  Identifying(const Log& log, const IdentifyOptions& options)
      : log_(log), options_(options), candidates_(options.only.empty() ? known_candidates() : options.only) {
    known_.up = options.up.value_or(std::ranges::find(log.axes, 1) != log.axes.end() ? 1 : log.axes.back());
    if (options.g) known_.g = options.g->to_double();
    result_.candidates = candidates_.size();
  }

  Identification result() {
    result_.bits = log_.position_rounding.exact() && log_.velocity_rounding.exact();
    result_.last = log_.rows.size();
    check_motion();
    if (!log_.equal_steps) {
      result_.kind = Identification::Kind::unequal_steps;
      result_.advice =
          "the frames are not equally long: no map of one fixed step made this. Record with a fixed step, or "
          "see what "
          "frames of unequal length do: shortfall jump --dt-file";
      return result_;
    }
    trim(log_, result_.first, result_.last, result_.breaks);
    if (result_.last - result_.first < kFewestRows)
      throw Undefined("the body moves for fewer than " + std::to_string(kFewestRows) +
                      " rows: there is nothing to tell maps apart by");
    find_step();
    explain(result_.first, result_.last);
    if (matches_.empty()) explain_with_switches();
    if (matches_.empty()) explain_a_part();
    conclude();
    return result_;
  }

 private:
  void check_motion() const {
    for (const Log::Row& row : log_.rows)
      for (const int axis : log_.axes)
        if (row.x[static_cast<std::size_t>(axis)] != log_.rows.front().x[static_cast<std::size_t>(axis)])
          return;
    throw Undefined("the body does not move: every map leaves it where it is");
  }

  void set_step(Rational dt, const char* source) {
    result_.dt = std::move(dt);
    result_.dt_source = source;
  }

  void find_step() {
    if (options_.dt) return set_step(*options_.dt, "given");
    if (log_.dt) return set_step(*log_.dt, "time stamps");
    if (log_.velocities)
      if (const auto dt = step_by_velocities()) return set_step(*dt, "velocities");
    if (known_.g) {
      const Observations o = observations(log_, 1, result_.first, result_.last);
      if (const auto q = needed(o); q && !q->spring) {
        const auto f = fit(candidates_.front(), o, {});
        const double a = f ? std::fabs(f->a[static_cast<std::size_t>(known_.up)].value) : 0;
        if (a > 0) return set_step(rate_of(std::sqrt(a / *known_.g)), "gravity");
      }
    }
    set_step(1, "one frame");
  }

  /// A whole number of hertz where that is near.
  static Rational rate_of(double dt) {
    const double rate = std::round(1 / dt);
    if (rate >= 1 && rate <= 1e15 && std::fabs(rate * dt - 1) < 0.01)
      return {1, static_cast<std::int64_t>(rate)};
    return simplest(dt, 1e-3 * dt);
  }

  std::optional<Rational> step_by_velocities() const {
    double above = 0, below = 0;
    for (std::size_t r = result_.first + 1; r < result_.last; ++r)
      for (const int axis : log_.axes) {
        const auto i = static_cast<std::size_t>(axis);
        const double mean = (log_.rows[r].v[i] + log_.rows[r - 1].v[i]) / 2;
        above += (log_.rows[r].x[i] - log_.rows[r - 1].x[i]) * mean;
        below += mean * mean * static_cast<double>(log_.rows[r].frame - log_.rows[r - 1].frame);
      }
    if (!(below > 0) || !(above > 0)) return std::nullopt;
    return rate_of(above / below);
  }

  Observations rows(std::size_t first, std::size_t last) const {
    return observations(log_, result_.dt.to_double(), first, last);
  }

  /// Tries every candidate on these rows, with as few parameters as will do.
  void explain(std::size_t first, std::size_t last) {
    Observations o = rows(first, last);
    const std::optional<FitQuestion> enough = needed(o);
    std::vector<FitQuestion> questions;
    FitQuestion q = enough.value_or(FitQuestion{});
    if (!enough) {
      questions.push_back({});  // methods that carry more than two vectors may still do it
    } else {
      questions.push_back(q);
      // A damping that the rounding hides from the positions may show in the velocities.
      FitQuestion more;
      more.damping = true;
      more.rate = 0.01;
      if (!q.damping && !o.exact()) questions.push_back(more);
      FitQuestion undamped = q;
      undamped.damping = false;
      if (q.spring) questions.insert(questions.begin(), undamped);
    }
    try_all(o, questions);
    if (!matches_.empty() || !o.velocities) return;
    // The launch may have been given after the first row was written: by a velocity that was set, or an
    // impulse.
    const Observations later = rows(first + 1, last);
    if (later.rows() < kFewestRows || !needed(later)) return;
    Observations set = o;
    set.first_velocity = false;
    try_all(set, questions);
    for (FitQuestion& question : questions) question.launch = Launch::impulse;
    try_all(o, questions);
    if (!matches_.empty()) {
      result_.breaks.push_back(
          {Break::Kind::first_frame, first, "the launch is not in this row: it came after it"});
      return;
    }
    for (FitQuestion& question : questions) question.launch = Launch::velocity;
    try_all(later, questions);
    if (!matches_.empty()) {
      result_.breaks.push_back({Break::Kind::first_frame, first + 1,
                                "the first frame is another: a limit, or a launch of its own"});
      result_.first = first + 1;
    }
  }

  void try_all(const Observations& o, const std::vector<FitQuestion>& questions) {
    for (const Candidate& c : candidates_) {
      std::optional<Match> best;
      for (const FitQuestion& q : questions) {
        std::optional<Match> found = match(c, o, q, known_);
        if (!found) continue;
        if (!best || (found->reproduces() && (!best->reproduces() || (found->exact && !best->exact))) ||
            (!best->reproduces() && found->ulp < best->ulp))
          best = std::move(found);
        if (best->exact || (best->reproduces() && !o.exact())) break;
      }
      if (best) (best->reproduces() ? matches_ : others_).push_back(std::move(*best));
    }
    keep_exact();
  }

  /// Where bits are recorded and some map makes all of them, those that make others are refuted.
  void keep_exact() {
    if (std::ranges::any_of(matches_, &Match::exact)) {
      for (const Match& m : matches_)
        if (!m.exact) others_.push_back(m);
      std::erase_if(matches_, [](const Match& m) { return !m.exact; });
    }
  }

  /// A map with a limit, or with a damping that acts only above some speed, is affine only as long as that
  /// does not change: its numbers are those of the beginning, and with them it must make all rows.
  void explain_with_switches() {
    const std::size_t end = longest(log_, result_.dt.to_double(), result_.first, result_.last);
    if (end < result_.first + 8 || end >= result_.last) return;
    const Observations beginning = rows(result_.first, end), whole = rows(result_.first, result_.last);
    const std::optional<FitQuestion> q = needed(beginning);
    if (!q) return;
    for (const Candidate& c : candidates_) {
      if (c.tape->limits.empty() && c.tape->whens.empty()) continue;
      std::optional<Match> m = match(c, beginning, *q, known_);
      if (!m || !m->reproduces() || !c.tape->solves.empty()) continue;
      const Comparison run = compare(c, whole, m->flight);
      m->exact = run.exact;
      m->ulp = run.ulp;
      (m->reproduces() ? matches_ : others_).push_back(std::move(*m));
    }
    keep_exact();
  }

  void explain_a_part() {
    const double dt = result_.dt.to_double();
    for (const std::size_t skipped : {0U, 1U, 2U}) {
      const std::size_t first = result_.first + skipped;
      if (first + 8 > result_.last) break;
      const std::size_t end = longest(log_, dt, first, result_.last);
      if (end < first + 8 || end - first < (result_.last - first) / 8) continue;
      // Any smooth motion has a short beginning that a map makes: what ends it must be known, or it is most
      // of the log.
      if (2 * (end - first) < result_.last - first &&
          (end >= result_.last || break_at(log_, first, end).kind == Break::Kind::unexplained))
        continue;
      others_.clear();
      explain(first, end);
      if (matches_.empty()) continue;
      if (skipped > 0) {
        result_.breaks.push_back(
            {Break::Kind::first_frame, first, "the rows before belong to something else"});
        result_.first = first;
      }
      if (end < result_.last) result_.breaks.push_back(break_at(log_, result_.first, end));
      result_.last = end;
      return;
    }
  }

  /// Velocities that stay the same while the positions go on in unequal steps: a slower simulation was looked
  /// at.
  bool resampled() const {
    if (!log_.velocities) return false;
    std::size_t repeated = 0, moved = 0;
    for (std::size_t r = result_.first + 1; r < result_.last; ++r) {
      if (log_.rows[r].x == log_.rows[r - 1].x) continue;
      ++moved;
      repeated += log_.rows[r].v == log_.rows[r - 1].v;
    }
    return 10 * repeated > moved && repeated < moved;
  }

  /// A damped spring that no arithmetic of a map makes bit by bit, and implicit Euler makes nearly: where it
  /// is about as near as any.
  std::vector<Match> joints() const {
    constexpr double kAboutAsNear = 3;
    if (!result_.bits || !log_.velocities || matches_.empty() || std::ranges::any_of(matches_, &Match::exact))
      return {};
    const double best = std::ranges::min_element(matches_, {}, &Match::ulp)->ulp;
    std::vector<Match> result;
    for (const auto* list : {&matches_, &others_})
      for (const Match& m : *list)
        if (m.candidate.name() == "implicit-euler" && m.fit.k.value > 4 * m.fit.k.spread &&
            m.fit.k.value > 0 && (m.reproduces() || m.ulp <= kAboutAsNear * best))
          result.push_back(m);
    return result;
  }

  void conclude() {
    const std::vector<Match> as_joint = joints();
    const bool joint = !as_joint.empty();
    if (joint) matches_ = as_joint;
    std::ranges::stable_sort(others_, {}, &Match::ulp);
    if (others_.size() > kNearest) others_.resize(kNearest);
    result_.nearest = others_;
    std::ranges::stable_sort(matches_, [this](const Match& a, const Match& b) { return rank(a) < rank(b); });
    result_.matches = std::move(matches_);
    if (result_.matches.empty()) {
      result_.kind = resampled() ? Identification::Kind::resampled : Identification::Kind::none;
      result_.advice = resampled()
                           ? "the velocities stay the same from row to row while the positions go on: a body "
                             "that is stepped more "
                             "slowly was looked at more often. Record once in each step of the engine"
                           : "no map of the family with one fixed step, a constant force, a damping and a "
                             "spring made this: a joint, "
                             "a force of another kind, steps that change, or positions smoothed for drawing";
      return;
    }
    result_.kind = Identification::Kind::map;
    if (joint) {
      result_.kind = Identification::Kind::joint;
      result_.advice =
          "no map makes the last bits of this log. A spring that an engine solves as a joint is implicit "
          "Euler, and so "
          "near is this: the integrator itself shows in a motion without a joint";
    }
    std::vector<Candidate> found;
    for (const Match& m : result_.matches) found.push_back(m.candidate);
    const std::vector<int> numbers = groups(found);
    for (std::size_t i = 0; i < found.size(); ++i) result_.matches[i].group = numbers[i];
    result_.groups = group_count(numbers);
    result_.identifiable = result_.groups == 1 && result_.kind == Identification::Kind::map;
    if (result_.groups == 1 || result_.kind != Identification::Kind::map) return;
    if (const Experiment* e = best_experiment(found))
      result_.advice = "record " + e->text + ": it tells them apart into " +
                       std::to_string(group_count(groups(found, *e))) + " groups";
  }

  /// How many digits the fractions take that somebody would have typed for damping, spring and acceleration:
  /// of maps that do the same, the one with the simplest numbers is the likeliest.
  double typed_digits(const Match& m) const {
    constexpr double kNoFraction = 9;
    const auto digits = [](const std::optional<Rational>& value) {
      return value ? std::log10(value->denominator().to_double()) : kNoFraction;
    };
    double sum = digits(m.c) + digits(m.k);
    for (const int axis : log_.axes) sum += digits(m.a[static_cast<std::size_t>(axis)]);
    return std::round(sum);
  }

  /// Exact ones first, or else, where bits are recorded, the smaller difference; then simpler numbers,
  /// engines, fewer substeps or what is more probable.
  std::array<double, 4> rank(const Match& m) const {
    const bool engine = family(*m.candidate.program) == "engines";
    const double difference = m.exact ? -1 : result_.bits ? std::round(m.ulp * 100) : 0;
    return {difference, typed_digits(m), engine ? 0.0 : 1.0,
            m.exact ? static_cast<double>(m.candidate.substep_count()) : -m.fit.log_likelihood};
  }

  const Log& log_;
  const IdentifyOptions& options_;
  const std::vector<Candidate>& candidates_;
  Known known_;
  Identification result_;
  std::vector<Match> matches_, others_;
};

}  // namespace

Identification identify(const Log& log, const IdentifyOptions& options) {
  return Identifying(log, options).result();
}

}  // namespace shortfall
