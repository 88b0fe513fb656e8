// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/program/version.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"

namespace shortfall::cli {

namespace {

std::string first_sentence(const std::string& description) {
  std::string text;
  for (char c : description) text += c == '\n' ? ' ' : c;
  // A sentence ends at a point or a colon that a blank follows.
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if ((text[i] == '.' || text[i] == ':' || text[i] == ';') && text[i + 1] == ' ') return text.substr(0, i);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::vector<std::string> families() {
  std::vector<std::string> names;
  for (const Program& p : catalogue())
    if (names.empty() || names.back() != family(p)) names.push_back(family(p));
  return names;
}

/// The integrators of one family, or all.
std::vector<Program> chosen(const std::string& wanted) {
  std::vector<Program> programs;
  for (const Program& p : catalogue())
    if (wanted.empty() || family(p) == wanted) programs.push_back(p);
  if (!programs.empty()) return programs;
  const std::vector<std::string> names = families();
  std::string hint = did_you_mean(wanted, names);
  if (hint.empty()) hint = "; there are " + fmt::format("{}", fmt::join(names, ", "));
  throw BadInput("unknown family '" + wanted + "'" + hint);
}

std::vector<std::string> version_texts(const Program& program) {
  std::vector<std::string> texts;
  for (const SoftwareVersion& v : versions(program)) texts.push_back(v.text);
  return texts;
}

std::string as_text(const std::vector<Program>& programs) {
  std::string text;
  std::string group;
  for (const Program& p : programs) {
    if (family(p) != group) {
      group = family(p);
      text += (text.empty() ? "" : "\n") + group + "\n";
    }
    std::string read_in;
    for (const SoftwareVersion& v : versions(p)) read_in += (read_in.empty() ? " [" : ", ") + v.text;
    text += fmt::format("  {:<30} {}{}\n", p.name, first_sentence(p.description),
                        read_in.empty() ? "" : read_in + "]");
  }
  return text + "\nshortfall show NAME prints one; shortfall new integrator FILE begins one of your own.\n";
}

std::string as_json(const std::vector<Program>& programs) {
  nlohmann::ordered_json json{{"schema", "shortfall.list/1"}, {"integrators", nlohmann::json::array()}};
  for (const Program& p : programs) {
    nlohmann::ordered_json parameters = nlohmann::json::array();
    for (const Parameter& parameter : p.parameters)
      parameters.push_back({{"name", parameter.name}, {"default", print(parameter.fallback)}});
    json["integrators"].push_back({{"name", p.name},
                                   {"family", family(p)},
                                   {"description", p.description},
                                   {"aliases", p.aliases},
                                   {"versions", version_texts(p)},
                                   {"parameters", parameters}});
  }
  return json.dump(2) + "\n";
}

}  // namespace

void add_list(CLI::App& app, int&) {
  CLI::App* command = new_command(app, "Set-up", "list", "The integrators that come with shortfall.",
                                  {"list", "list engines", "list --json"});
  auto q = std::make_shared<Question>();
  auto wanted = std::make_shared<std::string>();
  command->add_option("FAMILY", *wanted, "One family: engines, verlet, ...");
  add_json(*command, *q);
  command->callback([q, wanted] {
    const std::vector<Program> programs = chosen(*wanted);
    write_output(q->json ? as_json(programs) : as_text(programs));
  });
}

}  // namespace shortfall::cli
