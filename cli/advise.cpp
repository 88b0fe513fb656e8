// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/advice.hpp"
#include "cli/command.hpp"
#include "cli/language.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/scene.hpp"
#include "notebooks-export/advice_code.hpp"
#include "notebooks-export/advice_text.hpp"

namespace shortfall::cli {

namespace {

struct AdviseOptions {
  std::string scene, integrators, until, language, output;
  double margin = 2;
  bool why = false, json = false;
};

int advise_command(const AdviseOptions& o) {
  std::optional<Language> language;
  if (!o.language.empty()) language = language_of(o.language);
  AdviceQuestion question;
  question.margin = o.margin;
  question.integrators = words_of(o.integrators);
  const Scene scene = scene_from(o.scene, o.until);
  Advice advice;
  {
    ProgressLine line;
    advice = advise(scene, question, line.progress());
  }
  std::string text = o.json ? as_json(advice).dump(2) + "\n" : as_text(advice, o.why);
  if (language && advice.best) text += "\n" + advice_code(advice, *language);
  write_output(text, o.output);
  return advice.best ? kDone : kRefuted;
}

}  // namespace

void add_advise(CLI::App& app, int& code) {
  CLI::App* command =
      new_command(app, "Scenes", "advise",
                  "The cheapest thing that is good enough for a scene: what to model, how to step it.",
                  {"advise scenes/grenade.toml", "advise scenes/swing.toml --why --lang csharp",
                   "advise scenes/jump.toml --margin 4 --json"});
  auto o = std::make_shared<AdviseOptions>();
  command->add_option("SCENE", o->scene, "a scene's file; see docs/scenes.md")->required();
  command->add_option("--margin", o->margin, "errors may be the tolerance over this")
      ->type_name("M")
      ->check(CLI::Range(1.0, 1e6));
  command->add_option("--integrators", o->integrators, "names to choose from, separated by commas")
      ->type_name("LIST");
  command->add_option("--until", o->until, "end the scene there instead")->type_name("TIME");
  command->add_flag("--why", o->why, "the tables behind the advice too");
  command
      ->add_option("--lang", o->language,
                   "the step as code too: csharp, cpp, gdscript, python, rust, javascript")
      ->type_name("L");
  command->add_flag("--json", o->json, "as JSON");
  command->add_option("-o,--output", o->output, "write to a file")->type_name("FILE");
  command->callback([o, &code] { code = advise_command(*o); });
}

}  // namespace shortfall::cli
