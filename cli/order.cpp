// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/series/separable_order.hpp"
#include "cli/command.hpp"
#include "cli/memory.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "notebooks-export/order_text.hpp"

namespace shortfall::cli {

namespace {

struct OrderOptions : Question {
  std::string forces;
  int highest = 12;
  std::string memory = "500MB";
};

constexpr int kProcessed = 6;  // effective orders are looked for up to here
constexpr int kEnergy = 10;

const ForceClass* class_of(const std::string& word) {
  if (word.empty()) return nullptr;
  std::string bare = word;
  std::erase(bare, ' ');
  return bare == "separable" || bare == "T(p)+V(q)" ? &separable_forces() : &force_class(word);
}

int order_command(const OrderOptions& o) {
  if (o.highest < 1 || o.highest > 100) throw BadInput("--highest takes a whole number from 1 to 100");
  const ForceClass* only = class_of(o.forces);
  const Program program = o.substeps() > 1 ? substepped(o.program(), o.substeps()) : o.program();
  const SeriesSource source(program, o.values());
  ProgressLine line;
  OrderLimits limits;
  limits.highest = o.highest;
  limits.most_bytes = memory_of(o.memory);
  limits.progress = line.progress();
  OrderReport report;
  report.order = order(source, limits, only);
  for (const OrderOfClass& c : report.order.classes)
    if (c.order == 0 && !c.too_many.empty())
      throw Unable(c.too_many + ": no order of " + program.name + " is decided");
  if (!only) {
    report.structure = structure(source);
    report.energy = energy_change(source, kEnergy);
    ProcessingQuestion question;
    question.forces = &force_class("velocity_independent");
    const int plain = report.order.of("velocity_independent").order;
    question.order = std::min(kProcessed, plain + 1);
    if (plain > 0 && plain < kProcessed) report.processing = processing(source, question);
  }
  if (o.json)
    write_output(as_json(report, source).dump(2) + "\n", o.output);
  else
    write_output(as_text(report, source, o.ascii ? Style::language : Style::unicode), o.output);
  return report.cut_short() ? kNotDerivable : kDone;
}

}  // namespace

void add_order(CLI::App& app, int& code) {
  CLI::App* command =
      new_command(app, "Prove", "order",
                  "How many terms of the exact motion a step gets right, for each class of forces; what goes "
                  "wrong first.",
                  {"order forest-ruth", "order my-tableau.json", "order pefrl --force separable",
                   "order dormand-prince --json"});
  auto o = std::make_shared<OrderOptions>();
  add_integrator(*command, *o);
  command
      ->add_option(
          "--force", o->forces,
          "one class of forces only: general or a(x, v, t), a(x, t), a(x, v), a(x), linear, a(t), or "
          "separable for T(p) + V(q)")
      ->type_name("CLASS");
  command->add_option("--highest", o->highest, "the order up to which conditions are looked at (default 12)")
      ->type_name("N");
  add_memory(*command, o->memory);
  add_parameters(*command, *o);
  add_json(*command, *o);
  add_ascii(*command, *o);
  add_output(*command, *o);
  command->callback([o, &code] { code = order_command(*o); });
}

}  // namespace shortfall::cli
