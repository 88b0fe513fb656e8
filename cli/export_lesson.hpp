// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace shortfall::cli {

/// What `export lesson:NAME` may be told besides -o.
struct LessonOptions {
  bool list = false;       ///< --lessons: what there is
  bool exercise = false;   ///< --exercise: without the answers
  bool overwrite = false;  ///< --overwrite: files that are there already
  bool json = false;       ///< --json, of the list
};

/// Adds the options to the command export.
std::shared_ptr<LessonOptions> add_lesson_options(CLI::App& command);

/// Whether the word of the command means a lesson, or the list of them is asked for.
bool is_lesson(const std::string& word, const LessonOptions& options);

/// Writes the list to stdout; or a lesson: to stdout, to a file that ends in .ipynb, or into a folder, which
/// is made.
///
/// throws  BadInput  for an unknown lesson, and for files that are there already
int export_lesson(const std::string& word, const std::string& output, const LessonOptions& options);

}  // namespace shortfall::cli
