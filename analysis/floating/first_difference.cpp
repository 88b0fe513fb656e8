// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/first_difference.hpp"

#include <utility>
#include <vector>

#include "analysis/program/tape_source.hpp"

namespace shortfall {

namespace {

bool equal(const FloatNumber& a, const FloatNumber& b) {
  return a.kind == b.kind && (a.kind == FloatNumber::Kind::not_a_number || a.value == b.value);
}

class Comparison {
 public:
  Comparison(const FloatFormat& format, const FloatQuestion& question, const FloatQuestion& stored)
      : run_(float_run(format, question)), exact_(exact_run(stored)) {}

  FirstDifference operator()(std::int64_t most) {
    both([](FloatRun& run, const Seen& seen) { run.begin(seen); });
    for (std::int64_t n = 0;; ++n) {
      if (n > 0) both([](FloatRun& run, const Seen& seen) { run.step(seen); });
      found_.compared = n;
      if (reported_differs()) {
        if (n > 0) found_.reported = n;
        return std::move(found_);
      }
      if (n == most) return std::move(found_);
    }
  }

 private:
  /// Lets both do the same, and compares what they make on the way.
  template <class Work>
  void both(const Work& work) {
    made_.clear();
    work(*run_, [this](const Statement* s, const FloatNumber& value) { made_.emplace_back(s, value); });
    std::size_t next = 0;
    work(*exact_, [&](const Statement*, const FloatNumber& value) {
      if (next >= made_.size()) return;  // they went different ways: that is seen in the state
      if (!found_.rounding && !equal(made_[next].second, value)) note(made_[next].first);
      ++next;
    });
  }

  void note(const Statement* s) {
    FirstDifference::Rounding r;
    r.step = found_.compared + (begun_ ? 1 : 0);
    r.read_out = reading_;
    if (reading_) r.step = found_.compared;
    if (s) {
      r.line = s->place.line;
      r.statement = print(*s);
    }
    found_.rounding = r;
  }

  bool reported_differs() {
    begun_ = reading_ = true;
    std::pair<FloatNumber, FloatNumber> a, b;
    both([&](FloatRun& run, const Seen& seen) { (&run == run_.get() ? a : b) = run.state(seen); });
    reading_ = false;
    return !equal(a.first, b.first) || !equal(a.second, b.second);
  }

  std::unique_ptr<FloatRun> run_, exact_;
  FirstDifference found_;
  std::vector<std::pair<const Statement*, FloatNumber>> made_;
  bool begun_ = false;    ///< `start` has been run
  bool reading_ = false;  ///< `finish` is being run
};

}  // namespace

FirstDifference first_difference(const FloatFormat& format, const FloatQuestion& question,
                                 const FloatQuestion& stored, std::int64_t most) {
  return Comparison(format, question, stored)(most);
}

}  // namespace shortfall
