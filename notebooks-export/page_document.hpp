// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/program/embedded_file.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// A self-contained page of HTML as it grows: everything that it needs stands in it, nothing is fetched, and
/// it reads without scripts, too. Light and dark, by keyboard, printed.
///
/// Texts that are given as `html` are markup; all others are escaped. The same calls give the same bytes.
class PageDocument {
 public:
  PageDocument(std::string title, std::string description)
      : title_(std::move(title)), description_(std::move(description)) {}

  void html(const std::string& markup) { body_ += markup + "\n"; }
  void section(const std::string& heading);
  void paragraph(const std::string& text);
  void formula(const std::string& latex);  ///< displayed
  void code(const std::string& source);
  void table(const std::string& caption, const std::vector<std::string>& heads,
             const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& numbers);
  /// Code in tabs with buttons that copy: titles and sources.
  void tabs(const std::string& what, const std::vector<std::pair<std::string, std::string>>& sources);
  /// A drawing in SVG as it is.
  void figure(const std::string& svg, const std::string& caption);
  /// A script of this page alone, run after the others.
  void script(const std::string& javascript) { scripts_.push_back(javascript); }

  /// The file. Formulas are set by KaTeX where it is found on this machine; else their LaTeX stands in their
  /// place.
  std::string text() const;

 private:
  std::string title_, description_, body_;
  std::vector<std::string> scripts_;
  int tabs_ = 0;
};

std::string html_escaped(const std::string& text);
/// A formula within a line, as markup.
std::string inline_formula(const std::string& latex);

/// Where KaTeX is read from: SHORTFALL_KATEX, or where Debian's package libjs-katex puts it; empty when it is
/// not there.
std::string katex_folder();

/// The style sheet and the scripts of pages, by file name.
std::span<const EmbeddedFile> page_texts();
/// The style sheet or script of that name.
inline std::string page_text(std::string_view name) { return std::string(embedded_text(page_texts(), name)); }

}  // namespace shortfall
