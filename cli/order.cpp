// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/program/transform.hpp"
#include "cli/command.hpp"
#include "cli/memory.hpp"
#include "cli/output.hpp"
#include "notebooks-export/order_text.hpp"

namespace shortfall::cli {

namespace {

struct OrderOptions : Question {
  int highest = 12;
  std::string memory = "500MB";
};

constexpr int kProcessed = 6;  // effective orders are looked for up to here

void order_command(const OrderOptions& o) {
  if (o.highest < 1 || o.highest > 100) throw BadInput("--highest takes a whole number from 1 to 100");
  const Program program = o.substeps() > 1 ? substepped(o.program(), o.substeps()) : o.program();
  const SeriesSource source(program, o.values());
  OrderLimits limits;
  limits.highest = o.highest;
  limits.most_bytes = memory_of(o.memory);
  OrderReport report{order(source, limits), structure(source), {}};
  ProcessingQuestion question;
  question.forces = &force_class("velocity_independent");
  question.order = std::min(kProcessed, report.order.of("velocity_independent").order + 1);
  if (report.order.of("velocity_independent").order > 0 &&
      report.order.of("velocity_independent").order < kProcessed)
    report.processing = processing(source, question);
  if (o.json)
    write_output(as_json(report, source).dump(2) + "\n", o.output);
  else
    write_output(as_text(report, source, o.ascii ? Style::language : Style::unicode), o.output);
}

}  // namespace

void add_order(CLI::App& app, int&) {
  CLI::App* command =
      new_command(app, "Prove", "order",
                  "How many terms of the exact motion a step gets right, for each class of forces; what goes "
                  "wrong first.",
                  {"order forest-ruth", "order my-tableau.json", "order dormand-prince --json"});
  auto o = std::make_shared<OrderOptions>();
  add_integrator(*command, *o);
  command->add_option("--highest", o->highest, "the order up to which conditions are looked at (default 12)")
      ->type_name("N");
  add_memory(*command, o->memory);
  add_parameters(*command, *o);
  add_json(*command, *o);
  add_ascii(*command, *o);
  add_output(*command, *o);
  command->callback([o] { order_command(*o); });
}

}  // namespace shortfall::cli
