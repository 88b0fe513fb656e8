// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>

#include "analysis/algebra/error.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"

namespace shortfall::cli {

namespace {

std::string integrator_template(const std::string& name) {
  return "# One line that says what this method is and where it comes from.\n"
         "integrator " +
         name +
         "\n"
         "\n"
         "# One step of length h: x and v hold position and velocity, t the time at the beginning of the "
         "step;\n"
         "# a(x, v, t) is the force divided by the mass. Statements run in order, a name holds its new value "
         "from then on.\n"
         "step\n"
         "  v = v + h*a(x, v, t)\n"
         "  x = x + h*v\n"
         "\n"
         "# What you claim about it. Exact minus computed position after n steps under a constant "
         "acceleration a, with t = n*h:\n"
         "expect\n"
         "  shortfall -1/2*a*h*t\n";
}

/// The file's name without its ending, made into a name of the language.
std::string name_from(const std::string& path) {
  std::string name;
  for (const char c : std::filesystem::path(path).stem().string()) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9' && !name.empty()))
      name += c;
    else if (c >= 'A' && c <= 'Z')
      name += static_cast<char>(c - 'A' + 'a');
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (name.ends_with('-')) name.pop_back();
  return name.empty() ? "my-own" : name;
}

}  // namespace

void add_new(CLI::App& app, int&) {
  CLI::App* command =
      new_command(app, "Set-up", "new", "A file to begin with.", {"new integrator my-own.integrator"});
  auto kind = std::make_shared<std::string>();
  auto path = std::make_shared<std::string>();
  command->add_option("KIND", *kind, "integrator")->required();
  command->add_option("FILE", *path, "the file to write; it must not exist yet")->required();
  command->callback([kind, path] {
    if (*kind != "integrator")
      throw BadInput("new makes an integrator: shortfall new integrator FILE; found '" + *kind + "'");
    if (!path->ends_with(".integrator"))
      throw BadInput("the file's name ends in .integrator, found '" + *path + "'");
    std::error_code unknown;  // a path that cannot be looked at is not written either, and says so then
    if (std::filesystem::exists(*path, unknown))
      throw OutputError("'" + *path + "' exists already; choose another name or remove it");
    write_output(integrator_template(name_from(*path)), *path);
    say("wrote " + *path + "; now: shortfall derive " + *path);
  });
}

}  // namespace shortfall::cli
