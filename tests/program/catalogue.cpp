// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/catalogue.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "analysis/algebra/error.hpp"
#include "tests/program/find_refusal.hpp"
#include "tests/scratch_folder.hpp"

using namespace shortfall;

using testing::refusal;

TEST_CASE(
    "every integrator of the catalogue is found by its name and by each of its aliases, however they are "
    "spelt") {
  for (const Program& program : catalogue()) {
    CHECK(find_integrator(program.name).name == program.name);
    for (std::string alias : program.aliases) {
      CAPTURE(alias);
      CHECK(find_integrator(alias).name == program.name);
      std::ranges::transform(alias, alias.begin(), [](unsigned char c) { return std::toupper(c); });
      CHECK(find_integrator(alias).name == program.name);
    }
  }
}

TEST_CASE("the catalogue is sorted, and each file is named after its integrator and lies in its family") {
  CHECK(std::ranges::is_sorted(catalogue(), {}, &Program::file));
  for (const Program& program : catalogue())
    CHECK(program.file == family(program) + "/" + program.name + ".integrator");
  CHECK(family(find_integrator("rk4")) == "runge-kutta");
}

TEST_CASE("an integrator is found under the names that people use") {
  CHECK(find_integrator("Runge-Kutta 4").name == "rk4");
  CHECK(find_integrator("RK4").name == "rk4");
  CHECK(find_integrator("3/8 rule").name == "rk38");
  CHECK(find_integrator("3/8 Rule").name == "rk38");
  CHECK(find_integrator("semi implicit euler").name == "symplectic-euler");
  CHECK(find_integrator("velocity_verlet").name == "velocity-verlet");
  CHECK(find_integrator("Dormand-Prince 5(4)").name == "dormand-prince");
}

TEST_CASE("an unknown name is refused with what may have been meant") {
  const std::string list = " (shortfall list shows all; a file ends in .integrator or .json)";
  CHECK(refusal("rk5") == "unknown integrator 'rk5'; did you mean 'rk4'?" + list);
  CHECK(refusal("simplectic-euler") ==
        "unknown integrator 'simplectic-euler'; did you mean 'symplectic-euler'?" + list);
  CHECK(refusal("velocity-varlet") ==
        "unknown integrator 'velocity-varlet'; did you mean 'velocity-verlet'?" + list);
  CHECK(refusal("Crank-Nicholson") ==
        "unknown integrator 'Crank-Nicholson'; did you mean 'Crank-Nicolson'?" + list);
  CHECK(refusal("quaternion") == "unknown integrator 'quaternion'" + list);
  CHECK(refusal("") == "unknown integrator ''" + list);
  CHECK(refusal("?") == "unknown integrator '?'" + list);
}

TEST_CASE("a path is a path: what cannot be read is refused") {
  CHECK(refusal("no-such.integrator") == "cannot read the file 'no-such.integrator'");
  CHECK(refusal("no/such/file") == "cannot read the file 'no/such/file'");
  CHECK(refusal("./rk4") == "cannot read the file './rk4'");
  CHECK(refusal("./") == "cannot read the file './'");
}

TEST_CASE("a file of the user is read, an endless one is not read for ever") {
  const ScratchFolder folder;
  folder.write("own.integrator", "integrator my-own\nstep\n  x = x + h*v\n");
  const Program own = find_integrator(folder.path("own.integrator"));
  CHECK(own.name == "my-own");
  CHECK(word_for(own) == folder.path("own.integrator"));
  CHECK(word_for(find_integrator("Verlet")) == find_integrator("Verlet").name);
  CHECK_THROWS_AS(find_integrator("/dev/zero"), SyntaxError);
  CHECK_THROWS_AS(find_integrator("/dev/null"), SyntaxError);
}
