// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/program/print.hpp"
#include "cli/jump_render.hpp"

namespace shortfall::cli {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kDigits = 25;

constexpr std::size_t kLongest = 10'000;  // digits of a fraction

/// A number that is known to many digits, but is no fraction or root that would be worth writing.
Json rounded(const Surd& value) {
  return {{"formula", nullptr}, {"decimal", value.significant(kDigits)}, {"digits", kDigits}};
}

Json exact(const Surd& value) {
  if (std::max(value.rational_part().digits(), value.root_part().digits()) > kLongest) return rounded(value);
  return surd_json(value);
}

/// As exact as the jump is: where a function was rounded, nothing is.
Json number(const Jump& jump, const Surd& value) {
  return jump.rounded.empty() ? exact(value) : rounded(value);
}

Json number(const Jump& jump, const std::optional<Surd>& value) {
  return value ? number(jump, *value) : Json(nullptr);
}

Json frame(const Jump& jump, const Frame& f) {
  return {{"n", whole_json(f.n)}, {"height", number(jump, f.height)}};
}

Json shortfall_of(const Jump& jump, const JumpShortfall& s) {
  const auto part = [&](const Surd& value) {
    return jump.drag.is_zero() ? number(jump, value) : rounded(value);
  };
  return {{"total", number(jump, s.total)},
          {"method", part(s.method)},
          {"sampling", part(s.sampling)},
          {"damping", part(s.damping)}};
}

Json limit(const std::optional<LimitMet>& met) {
  if (!met) return nullptr;
  return {{"frame", met->frame},
          {"limit", met->text},
          {"best_frame",
           {{"n", met->best_frame},
            {"height", {{"format", "binary64"}, {"decimal", shortest(met->best_height)}}}}}};
}

Json binary32(float value) {
  return {{"format", "binary32"}, {"decimal", shortest(value)}, {"hex", hexadecimal(value)}};
}

Json correction(const LaunchCorrection& c, const Rational& g) {
  Json json;
  json["launch"] = c.exists ? Json(c.value(g).str()) : Json(nullptr);
  json["formula"] = c.exists ? Json(print(c.formula)) : Json(nullptr);
  json["exact"] = c.exists;
  json["reason"] =
      c.exists ? Json("every frame is on the exact parabola (proved for every n)") : Json(c.reason);
  return json;
}

Json on_frame(const Jump& jump) {
  if (!jump.on_frame)
    return {{"launch", nullptr}, {"n", nullptr}, {"height", nullptr}, {"reason", jump.no_on_frame}};
  const OnFrame& f = *jump.on_frame;
  Json json{{"launch", number(jump, Surd(f.launch))},
            {"n", whole_json(f.top.n)},
            {"height", number(jump, f.top.height)},
            {"shortfall", number(jump, Surd(jump.target) - f.top.height)},
            {"limit", limit(jump.on_frame_limit)}};
  if (const auto& b = jump.binary32)
    json["binary32"] = {{"launch", binary32(b->launch)},
                        {"dt", binary32(b->dt)},
                        {"g", binary32(b->g)},
                        {"target", binary32(b->target)},
                        {"n", b->n},
                        {"height", binary32(b->top)},
                        {"miss_ulp", b->miss.str()},
                        {"shortfall", b->shortfall.str()},
                        {"launches_tried", b->launches}};
  else
    json["binary32"] = {{"launch", nullptr}, {"reason", jump.no_binary32}};
  return json;
}

Json body(const Jump& jump) {
  Json json{{"integrator", jump.integrator},
            {"substeps", jump.substeps},
            {"dt", jump.dt.str()},
            {"g", jump.g.str()}};
  json["parameters"] = Json::object();
  for (const auto& [name, value] : jump.parameters) json["parameters"][name] = value.str();
  json["launch_by"] = jump.by == LaunchBy::impulse ? "impulse"
                      : jump.by == LaunchBy::force ? "force"
                                                   : "velocity";
  if (jump.by == LaunchBy::force)
    json["force"] = {{"frames", jump.force_frames},
                     {"acceleration", exact(jump.force_of(jump.launch_velocity))},
                     {"exact_motion", jump.exact_force_launch ? exact(jump.force_of(*jump.exact_force_launch))
                                                              : Json(nullptr)},
                     {"on_frame", jump.on_frame ? number(jump, jump.force_of(Surd(jump.on_frame->launch)))
                                                : Json(nullptr)}};
  const bool drag = !jump.drag.is_zero();
  json["drag"] = jump.drag.digits() > 40 ? rounded(jump.drag) : Json(jump.drag.str());
  json["launch_velocity"] = exact(jump.launch_velocity);
  json["target"] = jump.target.str();
  json["shortfall"] = shortfall_of(jump, jump.shortfall);
  json["ideal_time"] = drag ? rounded(jump.ideal_time) : exact(jump.ideal_time);
  json["exact_top"] = drag ? rounded(jump.exact_top) : exact(jump.exact_top);
  json["ideal_time_height"] = number(jump, jump.ideal_time_height);
  json["parabola_top"] = number(jump, jump.parabola_top);
  json["best_frame"] = frame(jump, jump.best_frame);
  json["limit"] = limit(jump.limit);
  if (!jump.limit_unknown.empty()) json["limit_unknown"] = jump.limit_unknown;
  json["tie"] = jump.tie;
  json["lifts_off"] = jump.lifts_off;
  json["correction"] = correction(jump.correction, jump.g);
  json["launch_for_top"] = number(jump, jump.launch_for_top);
  json["corrected"] = nullptr;
  if (const auto& c = jump.corrected)
    json["corrected"] = {{"launch_velocity", exact(c->launch)},
                         {"best_frame", frame(jump, c->best_frame)},
                         {"shortfall", shortfall_of(jump, c->shortfall)},
                         {"exact_at_every_frame", c->exact_at_every_frame}};
  json["on_frame"] = on_frame(jump);
  json["lift_off_height"] = jump.lift_off.height ? number(jump, Surd(*jump.lift_off.height)) : Json(nullptr);
  if (!jump.lift_off.height) json["lift_off_reason"] = jump.lift_off.reason;
  if (!jump.rounded.empty()) json["rounded_to_100_digits"] = jump.rounded;
  json["units"] = {{"length", "m"}, {"time", "s"}};
  json["sign"] = "shortfall is exact minus computed: positive means too low";
  return json;
}

}  // namespace

Json surd_json(const Surd& value) {
  if (value.is_rational()) return value.rational_part().str();
  return {{"formula", value.str()}, {"decimal", value.significant(kDigits)}, {"digits", kDigits}};
}

Json whole_json(const Rational& n) {
  constexpr std::int64_t kSafe = std::int64_t{1} << 53;
  std::int64_t value = 0;
  return n.fits_int64(value) && value < kSafe ? Json(value) : Json(n.str());
}

Json jump_json(const Jump& jump) {
  Json json{{"schema", "shortfall.jump/1"}};
  json.update(body(jump));
  return json;
}

Json jump_json(const std::vector<Jump>& jumps) {
  if (jumps.size() == 1) return jump_json(jumps.front());
  Json json{{"schema", "shortfall.jump/1"}, {"jumps", Json::array()}};
  for (const Jump& j : jumps) json["jumps"].push_back(body(j));
  return json;
}

Json engines_json(const std::vector<EngineJump>& jumps) {
  Json json{{"schema", "shortfall.jump/1"}, {"engines", Json::array()}};
  for (const EngineJump& e : jumps) {
    const EngineJump::UsualFix& fix = e.usual_fix;
    json["engines"].push_back({{"integrator", e.undamped.integrator},
                               {"undamped", body(e.undamped)},
                               {"usual_fix",
                                {{"add", "1/2*g*h"},
                                 {"launch_velocity", exact(fix.launch)},
                                 {"best_frame", frame(e.undamped, fix.best_frame)},
                                 {"shortfall", number(e.undamped, fix.shortfall)}}},
                               {"default_damping", e.damped ? body(*e.damped) : Json(nullptr)}});
  }
  return json;
}

}  // namespace shortfall::cli
