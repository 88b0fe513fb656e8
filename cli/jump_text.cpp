// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <charconv>

#include "analysis/program/print.hpp"
#include "cli/jump_amount.hpp"
#include "cli/jump_render.hpp"

namespace shortfall::cli {

namespace {

class JumpPage {
 public:
  JumpPage(const Jump& jump, const JumpWords& words)
      : jump_(jump),
        amounts_(words.unit, jump.target, words.ascii),
        style_(words.ascii ? Style::language : Style::unicode) {}

  std::string text() {
    heading();
    answer();
    if (jump_.lifts_off) parts();
    limit();
    peaks();
    correction();
    on_frame();
    force();
    text_ += fmt::format(
        "\nShortfall = exact - computed: + is too low, - too high. {} marks a rounded number; the others are "
        "exact.\n",
        style_ == Style::unicode ? "≈" : "~");
    for (const std::string& what : jump_.rounded)
      text_ += what + " was rounded to 100 digits, and so is everything that follows from it.\n";
    if (!jump_.drag.is_zero()) text_ += "Exponentials of the exact motion were computed to 100 digits.\n";
    return text_;
  }

 private:
  void line(const std::string& left, const std::string& right) {
    text_ += fmt::format("  {:<27} {}\n", left, right);
  }

  /// A formula of g and h for people, who call h dt here.
  std::string formula(const Expr& e) const { return print(replace(e, "h", name("dt")), style_); }

  void heading() {
    text_ = jump_.integrator;
    if (jump_.substeps > 1) text_ += fmt::format(", {} substeps a frame", jump_.substeps);
    for (const auto& [name, value] : jump_.parameters)
      text_ += fmt::format(", {} = {}", name, exact_text(value));
    if (jump_.by == LaunchBy::impulse) text_ += ", launched by an impulse";
    if (jump_.by == LaunchBy::force)
      text_ += ", launched by a force that is held over " + force_frames_text(jump_.force_frames);
    text_ += fmt::format(", dt = {} s, g = {} downwards\n\n", exact_text(jump_.dt),
                         amounts_.acceleration(jump_.g));
  }

  void answer() {
    const std::string target = amounts_.height_exactly(jump_.target);
    if (!jump_.lifts_off) {
      text_ += fmt::format("A jump to {} does not leave the ground: its highest frame is frame 0, at 0.\n",
                           target);
      return;
    }
    const int sign = jump_.shortfall.total.sign();
    const std::string frame = fmt::format("its highest frame, {}, is at {}", jump_.best_frame.n.str(),
                                          amounts_.height(jump_.best_frame.height));
    const std::string by = amounts_.difference(jump_.shortfall.total.abs());
    if (sign > 0) text_ += fmt::format("A jump to {} falls {} short: {}.\n", target, by, frame);
    if (sign < 0) text_ += fmt::format("A jump to {} goes {} too high: {}.\n", target, by, frame);
    if (sign == 0) text_ += fmt::format("A jump to {} arrives there: {}.\n", target, frame);
    if (jump_.tie)
      text_ += fmt::format("Frame {} is exactly as high; the earlier one counts.\n",
                           (jump_.best_frame.n + 1).str());
  }

  void parts() {
    const Rational t = jump_.best_frame.n * jump_.dt;
    std::string method = "lost by the integrator";
    if (jump_.shortfall.method.sign() < 0) method = "gained by the integrator";
    if (jump_.correction.exists && !jump_.correction.per_gravity.is_zero())
      method += fmt::format(", {} at t {}", formula(jump_.correction.formula * name("t")),
                            amounts_.time_equals(Surd(t)));
    if (jump_.shortfall.method.is_zero()) method = "the integrator is exact here";
    if (jump_.by == LaunchBy::force)
      method += jump_.force_frames == 1 ? ", the force's own frame included"
                                        : ", and while the force acts: the exact motion is launched at once";
    if (!jump_.drag.is_zero())
      line(amounts_.signed_difference(jump_.shortfall.damping),
           fmt::format("damping: the exact motion, which loses {} per second of its speed to drag, is at its "
                       "top at {}",
                       rate(jump_.drag), amounts_.height(jump_.exact_top)));
    line(amounts_.signed_difference(jump_.shortfall.method), method);
    line(amounts_.signed_difference(jump_.shortfall.sampling),
         "sampling: the exact motion is at its top between frames");
  }

  /// After a sign such as >: "1.96 mm (rounded)", and not "> ≈ 1.96 mm".
  static std::string bound(const std::string& amount) {
    const std::size_t blank = amount.find(' ');
    const bool rounded = amount.starts_with("~") || amount.starts_with("≈");
    return rounded ? amount.substr(blank + 1) + " (rounded)" : amount;
  }

  /// A rate: a short fraction, or rounded.
  std::string rate(const Rational& value) const {
    const std::string text = exact_text(value);
    return text.size() <= 12 ? text : (style_ == Style::unicode ? "≈ " : "~ ") + value.significant(6);
  }

  void limit() {
    if (const auto& met = jump_.limit)
      text_ += fmt::format(
          "\n'{}' acts in frame {}: stepped in binary64 with it, the highest frame is {}, at {}.\nAll else "
          "holds "
          "without it.\n",
          met->text, met->frame, met->best_frame,
          amounts_.height(Surd(Rational::from_double(met->best_height))));
    if (!jump_.limit_unknown.empty()) text_ += "\n" + jump_.limit_unknown + ".\n";
  }

  void peak(const std::string& what, const Surd& height) {
    const std::string high =
        height.is_rational() ? amounts_.height_exactly(height.rational_part()) : amounts_.height(height);
    line(what, fmt::format("{:<22} {}", high, amounts_.signed_difference(Surd(jump_.target) - height)));
  }

  void peaks() {
    text_ += fmt::format("\nFour meanings of peak         height                 shortfall\n");
    peak("the target H", Surd(jump_.target));
    if (jump_.ideal_time_height)
      peak("at u/g " + amounts_.time_equals(jump_.ideal_time), *jump_.ideal_time_height);
    if (!jump_.drag.is_zero()) peak("the exact motion's top", jump_.exact_top);
    if (jump_.parabola_top) peak("the top of the parabola", *jump_.parabola_top);
    peak(fmt::format("the highest frame, {}", jump_.best_frame.n.str()), jump_.best_frame.height);
    if (!jump_.ideal_time_height) line("between frames", "not defined: the flight is no parabola");
    text_ += "\nLift-off\n";
    if (!jump_.lift_off.height)
      line("not known", jump_.lift_off.reason);
    else if (jump_.lift_off.height->is_zero())
      text_ += "  Every jump leaves the ground, however low.\n";
    else
      text_ += fmt::format("  A jump leaves the ground if and only if H > {}.\n",
                           bound(amounts_.difference(Surd(*jump_.lift_off.height))));
  }

  void correction() {
    text_ += fmt::format("\nCorrection of the launch\n");
    line("uncorrected, sqrt(2 g H)", amounts_.speed(jump_.launch_velocity));
    if (!jump_.correction.exists) {
      line("does not exist", jump_.correction.reason);
      if (jump_.launch_for_top)
        line("for this H: launch", amounts_.speed(*jump_.launch_for_top) +
                                       ", which puts the top of the parabola through the frames at H");
      return;
    }
    const std::string proved = "every frame is on the exact parabola (proved)";
    if (jump_.correction.per_gravity.is_zero()) {
      line("nothing to correct", proved);
      return;
    }
    const Jump::Corrected& c = *jump_.corrected;
    line("add " + formula(jump_.correction.formula), amounts_.speed(Surd(jump_.correction.value(jump_.g))));
    line("corrected", fmt::format("{}: {}", amounts_.speed(c.launch), proved));
    line("highest frame, " + c.best_frame.n.str(),
         fmt::format("{}, shortfall {}, all of it sampling", amounts_.height(c.best_frame.height),
                     amounts_.signed_difference(c.shortfall.total)));
  }

  void on_frame() {
    text_ += "\nOn a frame: nothing is lost between frames either\n";
    if (!jump_.on_frame) {
      line("does not exist", jump_.no_on_frame);
      return;
    }
    const OnFrame& f = *jump_.on_frame;
    const bool exact = jump_.rounded.empty();
    const std::string fraction =
        exact && f.launch.digits() <= 12 ? fmt::format(" = {} exactly", f.launch.str()) : "";
    line("launch", amounts_.speed(Surd(f.launch)) + fraction);
    line("highest frame, " + f.top.n.str(),
         fmt::format("{}{}, shortfall {}",
                     exact                      ? ""
                     : style_ == Style::unicode ? "≈ "
                                                : "~ ",
                     amounts_.height_exactly(jump_.target), exact ? "0" : "below 1e-90 m"));
    if (!jump_.binary32) {
      line("in binary32", jump_.no_binary32);
      return;
    }
    const Binary32Launch& b = *jump_.binary32;
    line("launch in binary32", fmt::format("{} = {}", shortest(b.launch), hexadecimal(b.launch)));
    const Rational size = b.miss.abs();
    std::string miss = "H to the last bit";
    if (!size.is_zero())
      miss = fmt::format("{} unit{} in the last place too {}",
                         size.is_integer() ? size.str() : size.significant(6), size.is_one() ? "" : "s",
                         b.miss.sign() > 0 ? "high" : "low");
    line(fmt::format("highest frame, {}", b.n), fmt::format("{} m: {}", shortest(b.top), miss));
    if (const auto& met = jump_.on_frame_limit)
      line("but",
           fmt::format("'{}' acts in frame {}: this launch does not get there", met->text, met->frame));
  }

  void force() {
    if (jump_.by != LaunchBy::force) return;
    const std::string time = fmt::format("{} s", exact_text(jump_.dt * jump_.force_frames));
    text_ += fmt::format("\nThe force over the mass, besides gravity, held for {}\n", time);
    line("sqrt(2 g H)/" + time, amounts_.acceleration(jump_.force_of(jump_.launch_velocity)));
    if (jump_.exact_force_launch)
      line("exact motion", amounts_.acceleration(jump_.force_of(*jump_.exact_force_launch)) +
                               ", which takes it to H: g T/2 + sqrt((g T/2)^2 + 2 g H) over T");
    if (jump_.on_frame)
      line("on a frame", fmt::format("{}, which takes frame {} to H",
                                     amounts_.acceleration(jump_.force_of(Surd(jump_.on_frame->launch))),
                                     jump_.on_frame->top.n.str()));
  }

  const Jump& jump_;
  Amounts amounts_;
  Style style_;
  std::string text_;
};

}  // namespace

std::string force_frames_text(int count) {
  return count == 1 ? "frame 1" : "frames 1 to " + std::to_string(count);
}

std::string shortest(std::floating_point auto value) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}
template std::string shortest(float);
template std::string shortest(double);

std::string hexadecimal(float value) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::hex).ptr;
  const std::string digits(text, end);
  return digits.starts_with('-') ? "-0x" + digits.substr(1) : "0x" + digits;
}

std::string jump_text(const Jump& jump, const JumpWords& words) { return JumpPage(jump, words).text(); }

std::string jump_table(const std::vector<Jump>& jumps, const JumpWords& words) {
  const Jump& first = jumps.front();
  std::string text = first.integrator;
  if (first.substeps > 1) text += fmt::format(", {} substeps a frame", first.substeps);
  const Amounts general(words.unit, first.target, words.ascii);
  text += fmt::format(", dt = {} s, g = {} downwards\n\n{:<20} {:>7}  {:<24} {:<24} {}\n",
                      exact_text(first.dt), general.acceleration(first.g), "target", "frame", "highest frame",
                      "shortfall", "of it sampling");
  for (const Jump& j : jumps) {
    const Amounts amounts(words.unit == "px" ? words.unit : "", j.target, words.ascii);  // a sweep is wide
    text +=
        fmt::format("{:<20} {:>7}  {:<24} {:<24} {}\n", amounts.height(Surd(j.target)), j.best_frame.n.str(),
                    amounts.height(j.best_frame.height), amounts.signed_difference(j.shortfall.total),
                    amounts.signed_difference(j.shortfall.sampling));
  }
  return text + fmt::format(
                    "\nShortfall = exact - computed: + is too low, - too high. {} marks a rounded number; "
                    "the others are exact.\n",
                    words.ascii ? "~" : "≈");
}

}  // namespace shortfall::cli
