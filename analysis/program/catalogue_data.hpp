// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace shortfall {

/// One .integrator file of the catalogue, as it lay in integrators/ when the library was built.
struct CatalogueFile {
  /// Relative to integrators/, with forward slashes: "euler/symplectic-euler.integrator".
  std::string_view path;
  std::string_view text;
};

/// The whole catalogue, sorted by path.
std::span<const CatalogueFile> catalogue_files();

}  // namespace shortfall
