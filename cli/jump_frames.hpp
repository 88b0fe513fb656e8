// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/correction/jump_frames.hpp"
#include "analysis/motion/frame_list.hpp"
#include "cli/jump_render.hpp"

namespace shortfall::cli {

/// What `jump --dt-file` asks besides the height.
struct FrameOptions {
  std::string file;
  bool repeat = false;
};

/// The frames that a file lists, and the jump over them.
struct ListedJump {
  FrameList list;
  FrameJump jump;
  bool repeat = false;
  std::vector<ListExactness> catalogue;
};

/// throws  SyntaxError  when the list is over before the body is at its top: then there is no answer
ListedJump listed_jump(const Program& program, const FrameOptions& options, FrameJumpQuestion question);

/// The answer first, then why, why no launch helps, and what does.
std::string frames_text(const ListedJump& jump, const JumpWords& words);

/// Schema shortfall.jump/1 with an object `frames`; metres and seconds.
nlohmann::ordered_json frames_json(const ListedJump& jump);

/// One line a frame.
std::string frames_csv(const FrameJump& jump);

}  // namespace shortfall::cli
