// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/export_lesson.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "notebooks-export/lesson.hpp"

namespace shortfall::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "lesson:";

std::string as_text() {
  std::string text;
  int minutes = 0;
  for (const Lesson& lesson : lessons()) {
    text +=
        fmt::format("  {}  {:<18} {:>2} min  {}\n", lesson.place, lesson.name, lesson.minutes, lesson.title);
    minutes += lesson.minutes;
  }
  return text + fmt::format(
                    "\n{} lessons, {} minutes. shortfall export lesson:NAME -o FOLDER/ writes one; "
                    "--exercise leaves the "
                    "answers out.\n",
                    lessons().size(), minutes);
}

std::string as_json() {
  nlohmann::ordered_json json{{"schema", "shortfall.lessons/1"}, {"lessons", nlohmann::json::array()}};
  for (const Lesson& lesson : lessons())
    json["lessons"].push_back({{"name", lesson.name},
                               {"title", lesson.title},
                               {"about", lesson.about},
                               {"place", lesson.place},
                               {"minutes", lesson.minutes}});
  return json.dump(2) + "\n";
}

void refuse_existing(const fs::path& file, const LessonOptions& options) {
  std::error_code ignored;
  if (!options.overwrite && fs::exists(file, ignored))
    throw BadInput("'" + file.string() +
                   "' is there already, perhaps with somebody's answers; --overwrite replaces it");
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw OutputError("cannot make the folder '" + folder.string() + "'" +
                      (error ? ": " + error.message() : ""));
}

}  // namespace

std::shared_ptr<LessonOptions> add_lesson_options(CLI::App& command) {
  auto options = std::make_shared<LessonOptions>();
  command.add_flag("--lessons", options->list,
                   "the lessons that there are; lesson:NAME in place of INTEGRATOR exports one");
  command.add_flag("--exercise", options->exercise, "a lesson without the answers, for pupils");
  command.add_flag("--json", options->json, "the list of lessons as JSON");
  return options;
}

bool is_lesson(const std::string& word, const LessonOptions& options) {
  if (options.list || word.starts_with(kPrefix)) return true;
  if (options.exercise || options.json)
    throw BadInput("--exercise and --json belong to lessons: export lesson:NAME, export --lessons");
  return false;
}

int export_lesson(const std::string& word, const std::string& output, const LessonOptions& options) {
  if (options.list) {
    write_output(options.json ? as_json() : as_text(), output);
    return kDone;
  }
  const std::string wanted = word.substr(std::string(kPrefix).size());
  const Lesson& lesson = find_lesson(wanted);
  const LessonFor reader = options.exercise ? LessonFor::pupil : LessonFor::teacher;
  const std::string text = notebook(lesson, reader);
  if (output.empty()) {
    write_output(text);
    return kDone;
  }
  if (output.ends_with(".ipynb")) {
    refuse_existing(output, options);
    write_output(text, output);
    return kDone;
  }
  const fs::path folder = output;
  const fs::path file = folder / (lesson.name + ".ipynb");
  const fs::path page = folder / (lesson.name + ".md");
  refuse_existing(file, options);
  refuse_existing(page, options);
  make_folder(folder);
  write_output(text, file.string());
  write_output(lesson_readme(lesson, reader), page.string());
  return kDone;
}

}  // namespace shortfall::cli
