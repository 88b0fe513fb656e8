// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/print.hpp"
#include "cli/jump_render.hpp"

namespace shortfall::cli {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kDigits = 25;

Json exact(const Surd& value) {
  if (value.is_rational()) return value.rational_part().str();
  return {{"formula", value.str()}, {"decimal", value.significant(kDigits)}, {"digits", kDigits}};
}

Json exact(const std::optional<Surd>& value) { return value ? exact(*value) : Json(nullptr); }

/// A number where every reader of JSON keeps all its digits, otherwise text.
Json whole(const Rational& n) {
  constexpr std::int64_t kSafe = std::int64_t{1} << 53;
  std::int64_t value = 0;
  return n.fits_int64(value) && value < kSafe ? Json(value) : Json(n.str());
}

Json frame(const Frame& f) { return {{"n", whole(f.n)}, {"height", exact(f.height)}}; }

Json shortfall_of(const JumpShortfall& s) {
  return {{"total", exact(s.total)}, {"method", exact(s.method)}, {"sampling", exact(s.sampling)}};
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
  Json json{{"launch", f.launch.str()},
            {"n", whole(f.top.n)},
            {"height", exact(f.top.height)},
            {"shortfall", exact(Surd(jump.target) - f.top.height)}};
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
  json["launch_velocity"] = exact(jump.launch_velocity);
  json["target"] = jump.target.str();
  json["shortfall"] = shortfall_of(jump.shortfall);
  json["ideal_time"] = exact(jump.ideal_time);
  json["ideal_time_height"] = exact(jump.ideal_time_height);
  json["parabola_top"] = exact(jump.parabola_top);
  json["best_frame"] = frame(jump.best_frame);
  json["tie"] = jump.tie;
  json["lifts_off"] = jump.lifts_off;
  json["correction"] = correction(jump.correction, jump.g);
  json["corrected"] = nullptr;
  if (const auto& c = jump.corrected)
    json["corrected"] = {{"launch_velocity", exact(c->launch)},
                         {"best_frame", frame(c->best_frame)},
                         {"shortfall", shortfall_of(c->shortfall)},
                         {"exact_at_every_frame", c->exact_at_every_frame}};
  json["on_frame"] = on_frame(jump);
  json["lift_off_height"] = jump.lift_off.height ? Json(jump.lift_off.height->str()) : Json(nullptr);
  if (!jump.lift_off.height) json["lift_off_reason"] = jump.lift_off.reason;
  json["units"] = {{"length", "m"}, {"time", "s"}};
  json["sign"] = "shortfall is exact minus computed: positive means too low";
  return json;
}

}  // namespace

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

}  // namespace shortfall::cli
