// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "analysis/program/print.hpp"
#include "cli/jump_frames.hpp"

namespace shortfall::cli {

using Json = nlohmann::ordered_json;

namespace {

Json surd_or_null(const std::optional<Surd>& value) { return value ? surd_json(*value) : Json(nullptr); }

Json frame(const Frame& f) { return {{"n", whole_json(f.n)}, {"height", surd_json(f.height)}}; }

Json shortfall_of(const JumpShortfall& s) {
  return {
      {"total", surd_json(s.total)}, {"method", surd_json(s.method)}, {"sampling", surd_json(s.sampling)}};
}

Json law(const FrameJump& j) {
  if (!j.steps.law) {
    Json first = Json::array();
    for (const Expr& e : j.unrolled) first.push_back(print(e));
    return {{"exists", false}, {"reason", j.steps.reason}, {"shortfall_of_first_frames", first}};
  }
  return {
      {"exists", true},
      {"step", {{"x", print(position_change(*j.steps.law))}, {"v", print(velocity_change(*j.steps.law))}}},
      {"alpha", j.steps.law->alpha.str(j.steps.law->letters)},
      {"shortfall", print(shortfall_formula(*j.steps.law))},
      {"proof",
       "induction on n: the step, run in letters from the claimed x_n and v_n, gives the claimed "
       "x_(n+1) and v_(n+1)"}};
}

Json exactness(const ListExactness& e) {
  Json json{{"integrator", e.integrator}, {"exact", e.exact ? Json(*e.exact) : Json(nullptr)}};
  if (!e.shortfall.empty()) json["shortfall"] = e.shortfall;
  if (!e.reason.empty()) json["reason"] = e.reason;
  return json;
}

Json ending(const LaunchCounterExample::Ending& e) {
  Json steps = Json::array();
  for (const Rational& h : e.steps) steps.push_back(h.str());
  return {{"steps", steps}, {"t", e.t.str()}, {"needed", surd_json(e.needed)}};
}

Json launch(const FrameJump& j) {
  Json json{{"in_hindsight", surd_or_null(j.hindsight)}, {"counter_example", nullptr}};
  if (const auto& c = j.counter_example)
    json["counter_example"] = {
        {"common_frames", c->beginning}, {"one", ending(c->one)}, {"other", ending(c->other)}};
  return json;
}

Json repairs(const ListedJump& l) {
  const FrameJump& j = l.jump;
  Json json;
  json["term"] = nullptr;
  if (const auto& t = j.term)
    json["term"] = {{"target", "x"},
                    {"add", print(t->added)},
                    {"exact", true},
                    {"best_frame", frame(t->best_frame)},
                    {"shortfall", shortfall_of(t->shortfall)},
                    {"exact_at_every_frame", t->exact_at_every_frame}};
  else if (!j.no_term.empty())
    json["no_term_reason"] = j.no_term;
  json["steps"] = Json::array();
  for (const ListExactness& e : l.catalogue) json["steps"].push_back(exactness(e));
  json["accumulator"] = nullptr;
  if (const auto& a = j.accumulator)
    json["accumulator"] = {{"dt", a->dt.str()},
                           {"launch", a->correction.value(j.g).str()},
                           {"formula", print(a->correction.formula)},
                           {"frame", a->frame},
                           {"steps", whole_json(a->steps)},
                           {"height", surd_json(a->height)},
                           {"shortfall", surd_json(a->shortfall)}};
  return json;
}

Json frames(const ListedJump& l) {
  static constexpr const char* kKinds[] = {"steps", "time stamps", "rates"};
  const FrameJump& j = l.jump;
  Json json{{"file", l.list.file},
            {"kind", kKinds[static_cast<int>(l.list.kind)]},
            {"column", l.list.column},
            {"unit", l.list.unit},
            {"unit_is_given", l.list.unit_is_given},
            {"count", l.list.steps.size()},
            {"duration", l.list.duration().str()},
            {"equal", j.equal_steps},
            {"repeated", l.repeat},
            {"end", j.end == FrameJump::End::landed ? "landed" : "list over while falling"},
            {"top_is_certain", j.top_is_certain},
            {"longest", j.longest},
            {"longest_cost", surd_or_null(j.longest_cost)},
            {"law", law(j)},
            {"exact_for_every_list", exactness(j.exactness)},
            {"launch", launch(j)},
            {"repairs", repairs(l)},
            {"list", Json::array()}};
  for (std::size_t n = 0; n < j.frames.size(); ++n) {
    const JumpedFrame& f = j.frames[n];
    json["list"].push_back({{"n", n},
                            {"t", f.t.str()},
                            {"h", f.h.str()},
                            {"height", surd_json(f.height)},
                            {"exact", surd_json(f.exact)},
                            {"shortfall", surd_json(f.shortfall)}});
  }
  return json;
}

/// Why no launch is offered for a list of frames.
std::string no_launch(const FrameJump& j) {
  if (j.exactness.exact == true)
    return "every frame is on the exact parabola, for every list of frames (proved)";
  if (j.counter_example)
    return "what a launch would need depends on frames that are not known when the body is launched";
  return "not known";
}

}  // namespace

Json frames_json(const ListedJump& l) {
  const FrameJump& j = l.jump;
  Json json{{"schema", "shortfall.jump/1"},
            {"integrator", j.integrator},
            {"substeps", j.substeps},
            {"dt", nullptr},
            {"g", j.g.str()}};
  json["launch_velocity"] = surd_json(j.launch_velocity);
  json["target"] = j.target.str();
  json["shortfall"] = shortfall_of(j.shortfall);
  json["ideal_time"] = surd_json(j.ideal_time);
  json["ideal_time_height"] = nullptr;
  json["parabola_top"] = nullptr;
  json["best_frame"] = frame(j.best_frame);
  json["tie"] = j.tie;
  json["lifts_off"] = j.lifts_off;
  const bool exact_already = j.exactness.exact == true;
  json["correction"] = {{"launch", exact_already ? Json("0") : Json(nullptr)},
                        {"formula", exact_already ? Json("0") : Json(nullptr)},
                        {"exact", exact_already},
                        {"reason", no_launch(j)}};
  json["corrected"] = nullptr;
  json["on_frame"] = {{"launch", nullptr},
                      {"n", nullptr},
                      {"height", nullptr},
                      {"reason", "the frames to come are not known when the body is launched"}};
  json["lift_off_height"] = j.lift_off.height ? Json(j.lift_off.height->str()) : Json(nullptr);
  if (!j.lift_off.height) json["lift_off_reason"] = j.lift_off.reason;
  json["frames"] = frames(l);
  json["units"] = {{"length", "m"}, {"time", "s"}};
  json["sign"] = "shortfall is exact minus computed: positive means too low";
  return json;
}

std::string frames_csv(const FrameJump& jump) {
  std::string text = "n,t_s,h_s,height_m,exact_height_m,shortfall_m\n";
  for (std::size_t n = 0; n < jump.frames.size(); ++n) {
    const JumpedFrame& f = jump.frames[n];
    text += fmt::format("{},{},{},{},{},{}\n", n, csv_decimal(f.t), csv_decimal(f.h), csv_decimal(f.height),
                        csv_decimal(f.exact), csv_decimal(f.shortfall));
  }
  return text;
}

}  // namespace shortfall::cli
