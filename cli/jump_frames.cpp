// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/jump_frames.hpp"

#include <fmt/format.h>

#include "analysis/algebra/error.hpp"

namespace shortfall::cli {

ListedJump listed_jump(const Program& program, const FrameOptions& options, FrameJumpQuestion question) {
  ListedJump listed{read_frames(options.file), {}, options.repeat, {}};
  question.steps = listed.list.steps;
  question.repeat = options.repeat;
  listed.jump = jump(program, question);
  const FrameJump& j = listed.jump;
  if (j.end == FrameJump::End::rising) {
    const JumpedFrame& last = j.frames.back();
    const Surd more = j.ideal_time - Surd(last.t);
    const std::string when =
        more.sign() > 0
            ? fmt::format("the exact motion is at its top {} s (rounded) later", more.significant(6))
            : "the exact motion is past its top by then";
    throw SyntaxError(
        options.file, listed.list.last_line, 1,
        fmt::format(
            "the list is over after {} frame{}, at t = {} s (rounded), while the body still rises; {}. Add "
            "frames, or say --repeat to begin the list anew",
            j.frames.size() - 1, j.frames.size() == 2 ? "" : "s", last.t.significant(6), when));
  }
  listed.catalogue = catalogue_exactness();
  return listed;
}

}  // namespace shortfall::cli
