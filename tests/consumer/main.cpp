// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <shortfall/shortfall.hpp>

int main() {
  // Something from the headers, something that has to be linked, something that lies in the generated catalogue.
  const shortfall::Rational third(1, 3);
  const bool adds_up = third + third + third == shortfall::Rational(1);
  const bool has_catalogue = !shortfall::catalogue_files().empty();
  return adds_up && has_catalogue ? EXIT_SUCCESS : EXIT_FAILURE;
}
