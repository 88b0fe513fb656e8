// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "analysis/program/print.hpp"
#include "cli/jump_amount.hpp"
#include "cli/jump_frames.hpp"

namespace shortfall::cli {

namespace {

constexpr std::size_t kWidth = 100;
constexpr std::size_t kIndent = 15;

class FramesPage {
 public:
  FramesPage(const ListedJump& listed, const JumpWords& words)
      : listed_(listed),
        jump_(listed.jump),
        amounts_(words.unit, jump_.target, words.ascii),
        style_(words.ascii ? Style::language : Style::unicode),
        about_(words.ascii ? "~ " : "≈ ") {}

  std::string text() {
    heading();
    answer();
    if (jump_.lifts_off) parts();
    why();
    launch();
    repairs();
    text_ += fmt::format(
        "\nShortfall = exact - computed: + is too low, - too high. {}marks a rounded number; the others are "
        "exact.\n",
        about_);
    return text_;
  }

 private:
  void part(const std::string& left, const std::string& right) {
    text_ += fmt::format("  {:<27} {}\n", left, right);
  }

  /// A row with a heading, broken between words.
  void row(const std::string& left, const std::string& right) {
    std::string line = fmt::format("  {:<{}}", left, kIndent - 2);
    std::size_t width = kIndent;
    for (std::size_t begin = 0; begin < right.size();) {
      std::size_t end = right.find(' ', begin);
      if (end == std::string::npos) end = right.size();
      const std::string word = right.substr(begin, end - begin);
      const auto letters = static_cast<std::size_t>(
          std::ranges::count_if(word, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
      if (width + letters > kWidth && width > kIndent) {
        text_ += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
        line = std::string(kIndent, ' ');
        width = kIndent;
      }
      line += word + " ";
      width += letters + 1;
      begin = end + 1;
    }
    text_ += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }

  std::string formula(const Expr& e) const { return print(e, style_); }
  static std::string frames(std::size_t n) { return fmt::format("{} frame{}", n, n == 1 ? "" : "s"); }

  /// "16.7 ms", or rounded to five digits.
  std::string length(const Rational& seconds) const {
    const Rational ms = seconds * 1000;
    const std::string exact = exact_text(ms, 4);
    return (exact.find('/') == std::string::npos && exact.size() <= 12 ? exact : about_ + ms.significant(5)) +
           " ms";
  }
  std::string time(const Rational& seconds) const {
    const std::string exact = exact_text(seconds, 7);
    return (exact.find('/') == std::string::npos && exact.size() <= 12 ? "= " + exact
                                                                       : about_ + seconds.significant(6)) +
           " s";
  }

  void heading() {
    const FrameList& list = listed_.list;
    text_ = jump_.integrator;
    if (jump_.substeps > 1) text_ += fmt::format(", {} substeps a frame", jump_.substeps);
    text_ += fmt::format(", frames of {}, g = {} downwards\n", list.file, amounts_.acceleration(jump_.g));
    const auto [least, most] = std::ranges::minmax(list.steps);
    const std::string lengths =
        jump_.equal_steps ? "of " + length(least) : "of " + length(least) + " to " + length(most);
    std::string source = list.kind == FrameList::Kind::stamp ? ", from time stamps" : "";
    if (!list.column.empty()) source += fmt::format(", column '{}'", list.column);
    text_ += fmt::format("{} {}{}{}\n", frames(list.steps.size()), lengths, source,
                         listed_.repeat ? ", repeated" : "");
    if (!list.unit_is_given && least > 1)
      text_ +=
          "The file names no unit, so these are seconds; for milliseconds begin it with the line: dt [ms]\n";
    text_ += "\n";
  }

  void answer() {
    const std::string target = amounts_.height_exactly(jump_.target);
    const std::size_t flown = jump_.frames.size() - 1;
    if (!jump_.lifts_off) {
      text_ += fmt::format("A jump to {} does not leave the ground: its highest frame is frame 0, at 0.\n",
                           target);
    } else {
      const int sign = jump_.shortfall.total.sign();
      std::int64_t n = 0;
      jump_.best_frame.n.fits_int64(n);
      const std::string frame = fmt::format("its highest frame, {}, t {}, is at {}", n,
                                            time(jump_.frames[static_cast<std::size_t>(n)].t),
                                            amounts_.height(jump_.best_frame.height));
      const std::string by = amounts_.difference(jump_.shortfall.total.abs());
      if (sign > 0) text_ += fmt::format("A jump to {} falls {} short: {}.\n", target, by, frame);
      if (sign < 0) text_ += fmt::format("A jump to {} goes {} too high: {}.\n", target, by, frame);
      if (sign == 0) text_ += fmt::format("A jump to {} arrives there: {}.\n", target, frame);
      if (jump_.tie) text_ += fmt::format("Frame {} is exactly as high; the earlier one counts.\n", n + 1);
    }
    if (jump_.end == FrameJump::End::falling)
      text_ += fmt::format("The list is over after {}, with the body falling at {}{}.\n", frames(flown),
                           amounts_.height(jump_.frames.back().height),
                           jump_.top_is_certain ? ": no later frame is higher (proved)"
                                                : "; that no later frame is higher is not proved");
  }

  void parts() {
    const int sign = jump_.shortfall.method.sign();
    std::string method = sign < 0 ? "gained by the integrator" : "lost by the integrator";
    if (jump_.steps.law && !jump_.shortfall.method.is_zero())
      method += fmt::format(", {} with a = {}g", formula(shortfall_formula(*jump_.steps.law)),
                            style_ == Style::unicode ? "−" : "-");
    if (sign == 0) method = "the integrator is exact here";
    part(amounts_.signed_difference(jump_.shortfall.method), method);
    if (jump_.longest_cost && !jump_.longest_cost->is_zero() && !jump_.equal_steps)
      part("  " + amounts_.signed_difference(*jump_.longest_cost),
           fmt::format("of it in the longest frame, {}, of {}", jump_.longest,
                       length(jump_.frames[jump_.longest].h)));
    part(amounts_.signed_difference(jump_.shortfall.sampling),
         "sampling: the exact motion is at its top between frames");
  }

  void why() {
    text_ += "\nWhy\n";
    if (const auto& law = jump_.steps.law) {
      row("one step",
          fmt::format("x += {},   v += {}", formula(position_change(*law)), formula(velocity_change(*law))));
      row("shortfall",
          fmt::format("{} = {}   after steps {}, ..., {}", formula(name("x(t)") - name("x_n")),
                      formula(shortfall_formula(*law)), formula(name("h_1")), formula(name("h_n"))));
      row("proof",
          style_ == Style::unicode
              ? "by induction: one step, run in letters from this xₙ and its vₙ, gives xₙ₊₁ and vₙ₊₁"
              : "by induction: one step, run in letters from this x_n and its v_n, gives x_(n+1) and "
                "v_(n+1)");
    } else {
      row("no law", jump_.steps.reason);
      for (std::size_t n = 0; n < jump_.unrolled.size(); ++n)
        row(fmt::format("frame {}", n + 1), "falls short by " + formula(jump_.unrolled[n]));
    }
    if (jump_.lift_off.height && !jump_.lift_off.height->is_zero())
      row("lift-off",
          fmt::format("frame 1, of {}, is above the ground if and only if H > {}", length(jump_.frames[1].h),
                      amounts_.difference(Surd(*jump_.lift_off.height))));
  }

  std::string needs(const Surd& added) const {
    return added.sign() < 0 ? amounts_.speed(-added) + " less" : amounts_.speed(added) + " more";
  }

  void ending(const LaunchCounterExample& c, const LaunchCounterExample::Ending& e) {
    std::string last;
    for (const Rational& h : e.steps) last += (last.empty() ? "" : ", ") + length(h);
    const std::string before = c.beginning == 0   ? ""
                               : c.beginning == 1 ? "frame 1, then "
                                                  : fmt::format("frames 1 to {}, then ", c.beginning);
    row("", fmt::format("{}{}: needs {}", before, last, needs(e.needed)));
  }

  void launch() {
    text_ += "\nThe launch\n";
    row("uncorrected", "sqrt(2 g H) " + amounts_.speed(jump_.launch_velocity));
    if (jump_.exactness.exact == true) {
      row("correction", "none needed: every frame of every list is on the exact parabola (proved)");
      return;
    }
    if (jump_.hindsight && jump_.counter_example)
      row("in hindsight",
          fmt::format("{}, and frame {} is exact", needs(*jump_.hindsight), jump_.best_frame.n.str()));
    if (!jump_.counter_example) {
      row("beforehand",
          jump_.lifts_off ? "not known whether one launch serves every list" : "no frame to correct");
      return;
    }
    row("beforehand", "no launch repairs it, for what it needs depends on frames that are still to come:");
    ending(*jump_.counter_example, jump_.counter_example->one);
    ending(*jump_.counter_example, jump_.counter_example->other);
    if (jump_.equal_steps)
      row("", "Only while all frames are as long as these is a launch right: see --dt without --dt-file");
  }

  /// The first few, those that games use before the others: "velocity-verlet, midpoint and 27 more".
  std::string integrators(std::optional<bool> exact) const {
    constexpr std::size_t kShown = 4;
    static const std::vector<std::string> usual{
        "velocity-verlet", "position-verlet", "midpoint",       "rk4", "half-gravity", "symplectic-euler",
        "explicit-euler",  "leapfrog",        "stoermer-verlet"};
    std::vector<std::string> names;
    for (const ListExactness& e : listed_.catalogue)
      if (e.exact == exact) names.push_back(e.integrator);
    const auto place = [](const std::string& n) { return std::ranges::find(usual, n) - usual.begin(); };
    std::ranges::stable_sort(names, {}, place);
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) text += (i ? ", " : "") + names[i];
    if (names.size() > kShown) text += " and " + std::to_string(names.size() - kShown) + " more";
    return text;
  }

  void repairs() {
    if (jump_.exactness.exact == true) return;
    text_ += "\nWhat does\n";
    if (const auto& t = jump_.term) {
      row("a term",
          fmt::format("x += {} at the end of each frame: exact for every list (proved); highest frame {} at "
                      "{}, shortfall {}, all of it sampling",
                      formula(t->added), t->best_frame.n.str(), amounts_.height(t->best_frame.height),
                      amounts_.signed_difference(t->shortfall.total)));
    } else if (jump_.steps.law) {
      row("no term", jump_.no_term);
    }
    row("another step", "exact for every list (proved): " + integrators(true));
    row("", "not exact (proved): " + integrators(false));
    if (const std::string open = integrators(std::nullopt); !open.empty())
      row("", "not decided: " + open + " (--json lists all)");
    if (const auto& a = jump_.accumulator) {
      const Expr launch = name("sqrt(2 g H)") + replace(a->correction.formula, "h", name("dt"));
      row("a fixed step",
          fmt::format(
              "dt = {} s from an accumulator, launched with {}: every fixed step is exact (proved), "
              "and drawn less than dt late; highest frame {}, {} fixed {}, at {}, shortfall {}, all of "
              "it sampling",
              exact_text(a->dt), formula(launch), a->frame, a->steps.str(),
              a->steps == Rational(1) ? "step" : "steps", amounts_.height(a->height),
              amounts_.signed_difference(a->shortfall)));
    }
  }

  const ListedJump& listed_;
  const FrameJump& jump_;
  Amounts amounts_;
  Style style_;
  std::string about_;
  std::string text_;
};

}  // namespace

std::string frames_text(const ListedJump& jump, const JumpWords& words) {
  return FramesPage(jump, words).text();
}

}  // namespace shortfall::cli
