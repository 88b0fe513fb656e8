// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace shortfall::cli {

/// Writes files below a folder, which is made, all or none: names relative to it, and their texts.
///
/// throws  OutputError  when the folder exists and is not empty, unless `overwrite`: then these files are
/// replaced and
///         others are left alone
void write_folder(const std::map<std::string, std::string>& files, const std::string& folder, bool overwrite);

/// A name for a file: letters, digits, '.', '-', '_' of the text, hyphens for the rest.
std::string file_name(const std::string& text);

}  // namespace shortfall::cli
