// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/frame_header.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "analysis/algebra/unit.hpp"

namespace shortfall {

namespace {

using Kind = FrameList::Kind;

/// How units are spelled in headers: in lower case, and which unit each is.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kSpellings{{{"s", "s"},
                                                                                    {"sec", "s"},
                                                                                    {"secs", "s"},
                                                                                    {"second", "s"},
                                                                                    {"seconds", "s"},
                                                                                    {"ms", "ms"},
                                                                                    {"msec", "ms"},
                                                                                    {"millisecond", "ms"},
                                                                                    {"milliseconds", "ms"},
                                                                                    {"us", "us"},
                                                                                    {"usec", "us"},
                                                                                    {"microsecond", "us"},
                                                                                    {"microseconds", "us"},
                                                                                    {"ns", "ns"},
                                                                                    {"nanosecond", "ns"},
                                                                                    {"nanoseconds", "ns"},
                                                                                    {"hz", "Hz"},
                                                                                    {"fps", "fps"}}};

FrameUnit frame_unit_of(const std::pair<std::string_view, std::string_view>& spelling) {
  const PhysicalUnit& unit = *find_unit(spelling.second);
  return {spelling.first, unit.scale, unit.dimension == kPhysicalRate};
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
  const auto found =
      std::ranges::find(kSpellings, wanted, [](const auto& spelling) { return spelling.first; });
  return found == kSpellings.end() ? std::nullopt : std::optional(frame_unit_of(*found));
}

std::optional<FrameColumn> frame_column(std::string_view header) {
  const std::string word = folded(header);
  if (word == "msbetweenpresents") return FrameColumn{Kind::step, frame_unit("ms")};  // PresentMon
  const auto kind_of = [](std::string_view name) -> std::optional<Kind> {
    const auto found = std::ranges::find(kNames, name, &Named::name);
    return found == kNames.end() ? std::nullopt : std::optional(found->kind);
  };
  if (const auto kind = kind_of(word)) return FrameColumn{*kind, std::nullopt};
  for (const auto& spelling : kSpellings) {
    if (!word.ends_with(spelling.first)) continue;
    const auto kind = kind_of(std::string_view(word).substr(0, word.size() - spelling.first.size()));
    const FrameUnit unit = frame_unit_of(spelling);
    if (kind && unit.rate == (*kind == Kind::rate)) return FrameColumn{*kind, unit};
  }
  return std::nullopt;
}

}  // namespace shortfall
