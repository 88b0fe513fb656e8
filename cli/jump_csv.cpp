// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "cli/jump_render.hpp"

namespace shortfall::cli {

namespace {

std::string decimal_or_empty(const std::optional<Surd>& value) { return value ? csv_decimal(*value) : ""; }

}  // namespace

std::string csv_decimal(const Surd& value) {
  constexpr int kDigits = 17;
  if (value.is_zero()) return "0";
  std::string text = value.significant(kDigits);
  if (text.find('e') != std::string::npos || text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string jump_csv(const std::vector<Jump>& jumps) {
  std::string text =
      "target_m,launch_m_per_s,best_frame,best_height_m,shortfall_m,method_m,sampling_m,ideal_time_height_m,"
      "parabola_top_m,"
      "lifts_off,correction_m_per_s,corrected_frame,corrected_shortfall_m,on_frame,on_frame_launch_m_per_s,"
      "binary32_launch_m_per_s,binary32_miss_ulp,damping_m,limit_frame\n";
  for (const Jump& j : jumps) {
    const std::string corrected =
        j.corrected ? fmt::format("{},{},{}", csv_decimal(j.correction.value(j.g)),
                                  j.corrected->best_frame.n.str(), csv_decimal(j.corrected->shortfall.total))
                    : ",,";
    const std::string on_frame =
        j.on_frame ? j.on_frame->top.n.str() + "," + csv_decimal(j.on_frame->launch) : ",";
    const std::string binary32 =
        j.binary32 ? shortest(j.binary32->launch) + "," + csv_decimal(j.binary32->miss) : ",";
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_decimal(j.target),
                    csv_decimal(j.launch_velocity), j.best_frame.n.str(), csv_decimal(j.best_frame.height),
                    csv_decimal(j.shortfall.total), csv_decimal(j.shortfall.method),
                    csv_decimal(j.shortfall.sampling), decimal_or_empty(j.ideal_time_height),
                    decimal_or_empty(j.parabola_top), j.lifts_off ? 1 : 0, corrected, on_frame, binary32,
                    csv_decimal(j.shortfall.damping), j.limit ? std::to_string(j.limit->frame) : "");
  }
  return text;
}

}  // namespace shortfall::cli
