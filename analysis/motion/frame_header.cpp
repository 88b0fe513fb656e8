// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/frame_header.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace shortfall {

namespace {

using Kind = FrameList::Kind;

const std::vector<FrameUnit>& units() {
  static const std::vector<FrameUnit> all{{"s", 1},
                                          {"sec", 1},
                                          {"secs", 1},
                                          {"second", 1},
                                          {"seconds", 1},
                                          {"ms", Rational(1, 1000)},
                                          {"msec", Rational(1, 1000)},
                                          {"millisecond", Rational(1, 1000)},
                                          {"milliseconds", Rational(1, 1000)},
                                          {"us", Rational(1, 1'000'000)},
                                          {"usec", Rational(1, 1'000'000)},
                                          {"microsecond", Rational(1, 1'000'000)},
                                          {"microseconds", Rational(1, 1'000'000)},
                                          {"ns", Rational(1, 1'000'000'000)},
                                          {"nanosecond", Rational(1, 1'000'000'000)},
                                          {"nanoseconds", Rational(1, 1'000'000'000)},
                                          {"hz", 1, true},
                                          {"fps", 1, true}};
  return all;
}

struct Named {
  std::string_view name;
  Kind kind;
};

/// Letters only, in lower case.
constexpr std::array<Named, 27> kNames{{{"dt", Kind::step},           {"h", Kind::step},
                                        {"delta", Kind::step},        {"deltat", Kind::step},
                                        {"deltatime", Kind::step},    {"timedelta", Kind::step},
                                        {"step", Kind::step},         {"steplength", Kind::step},
                                        {"timestep", Kind::step},     {"duration", Kind::step},
                                        {"interval", Kind::step},     {"frametime", Kind::step},
                                        {"framedelta", Kind::step},   {"frameduration", Kind::step},
                                        {"framelength", Kind::step},  {"t", Kind::stamp},
                                        {"time", Kind::stamp},        {"timestamp", Kind::stamp},
                                        {"clock", Kind::stamp},       {"elapsed", Kind::stamp},
                                        {"elapsedtime", Kind::stamp}, {"timein", Kind::stamp},
                                        {"fps", Kind::rate},          {"rate", Kind::rate},
                                        {"framerate", Kind::rate},    {"framespersecond", Kind::rate},
                                        {"frequency", Kind::rate}}};

/// Letters and digits in lower case; both micro signs are a u.
std::string folded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = text.substr(i);
    if (rest.starts_with("\xC2\xB5") || rest.starts_with("\xCE\xBC")) {
      result += 'u';
      ++i;
    } else if (std::isalnum(static_cast<unsigned char>(text[i]))) {
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
    } else if (static_cast<unsigned char>(text[i]) >= 0x80) {
      result += text[i];  // so that an unknown sign is not overlooked
    }
  }
  return result;
}

}  // namespace

std::optional<FrameUnit> frame_unit(std::string_view name) {
  const std::string wanted = folded(name);
  for (const FrameUnit& unit : units())
    if (unit.name == wanted) return unit;
  return std::nullopt;
}

std::optional<FrameColumn> frame_column(std::string_view header) {
  const std::string word = folded(header);
  if (word == "msbetweenpresents") return FrameColumn{Kind::step, frame_unit("ms")};  // PresentMon
  const auto kind_of = [](std::string_view name) -> std::optional<Kind> {
    const auto found = std::ranges::find(kNames, name, &Named::name);
    return found == kNames.end() ? std::nullopt : std::optional(found->kind);
  };
  if (const auto kind = kind_of(word)) return FrameColumn{*kind, std::nullopt};
  for (const FrameUnit& unit : units()) {
    if (!word.ends_with(unit.name)) continue;
    const auto kind = kind_of(std::string_view(word).substr(0, word.size() - unit.name.size()));
    if (kind && unit.rate == (*kind == Kind::rate)) return FrameColumn{*kind, unit};
  }
  return std::nullopt;
}

}  // namespace shortfall
