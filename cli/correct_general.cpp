// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/correct_general.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/series/processing.hpp"
#include "analysis/series/twin.hpp"
#include "cli/output.hpp"
#include "notebooks-export/processing_text.hpp"
#include "notebooks-export/series_json.hpp"

namespace shortfall::cli {

namespace {

struct Answer {
  Processing found;
  std::vector<std::string> twins;
};

Processing best(const SeriesSource& source, const ForceClass& forces, int order) {
  ProcessingQuestion question;
  question.forces = &forces;
  question.order = order;
  Processing plain = processing(source, question);
  if (order == 0 || plain.complete) return plain;
  question.correct_force = true;
  Processing corrected = processing(source, question);
  return corrected.effective_order > plain.effective_order ? corrected : plain;
}

/// The weight of the launch when it is a single kick, as far as an identity can be proved with it.
Answer answered(const Program& program, const Values& values, const SeriesSource& source,
                const ForceClass& forces, int order) {
  Answer a{best(source, forces, order), {}};
  const std::vector<FieldTerm>& launch = a.found.launch;
  const bool kick = launch.size() == 1 && launch[0].component == "v" && launch[0].tree == "a" &&
                    launch[0].coefficient.is_constant();
  if (kick && a.found.force.empty() && !source.program().approximate())
    a.twins = processed_twins(program, values, launch[0].coefficient.constant());
  return a;
}

bool same_obstruction(const Processing& a, const Processing& b) {
  return std::ranges::equal(a.residual, b.residual, [](const FieldTerm& s, const FieldTerm& t) {
    return s.tree == t.tree && s.coefficient == t.coefficient;
  });
}

}  // namespace

bool is_force_class(const std::string& force) {
  if (force.starts_with("a(")) return true;
  return std::ranges::any_of(force_classes(), [&](const ForceClass& c) {
    std::string key = force;
    std::ranges::replace(key, '-', '_');
    return c.key == key;
  });
}

int correct_general(const Question& q, int order) {
  const Program program = q.substeps() > 1 ? substepped(q.program(), q.substeps()) : q.program();
  const SeriesSource source(program, q.values());
  const ForceClass& asked = force_class(q.force);
  // Where forces that read the velocity stand in the way, what holds for the others is of interest.
  std::vector<const ForceClass*> classes{&asked};
  if (asked.key == "general")
    for (const char* key : {"velocity_independent", "position_only"}) classes.push_back(&force_class(key));
  std::vector<Answer> answers;
  for (const ForceClass* forces : classes) {
    Answer a = answered(program, q.values(), source, *forces, order);
    // A narrower class is worth a word when more is possible for it, or when another reason stands in the
    // way.
    if (!answers.empty() && a.found.effective_order <= answers.back().found.effective_order &&
        same_obstruction(a.found, answers.back().found))
      continue;
    answers.push_back(std::move(a));
  }
  const bool helped = std::ranges::any_of(answers, [&](const Answer& a) {
    return a.found.effective_order > a.found.plain_order && a.found.effective_order >= order;
  });
  if (q.json) {
    nlohmann::ordered_json json{{"schema", "shortfall.correct-general/1"},
                                {"integrator", program.name},
                                {"force", q.force},
                                {"classes", nlohmann::ordered_json::array()}};
    for (const Answer& a : answers) json["classes"].push_back(as_json(a.found, a.twins, source));
    write_output(json.dump(2) + "\n", q.output);
  } else {
    const Style style = q.ascii ? Style::language : Style::unicode;
    std::string text = program.name + ", for a force that is not chosen yet\n";
    for (const Answer& a : answers) text += as_text(a.found, a.twins, source, style);
    write_output(text, q.output);
  }
  return helped ? kDone : kNotDerivable;
}

}  // namespace shortfall::cli
