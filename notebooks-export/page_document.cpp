// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/page_document.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>

#include "notebooks-export/base64.hpp"

namespace shortfall {

namespace {

std::optional<std::string> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// KaTeX's style sheet with its fonts inside; only the compact ones, which every browser of the last ten
/// years reads.
std::string with_fonts(const std::string& css, const std::string& folder) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = css.find("src:"); at != std::string::npos; at = css.find("src:", done)) {
    const std::size_t end = css.find_first_of(";}", at);
    const std::size_t open = css.find("url(", at), close = css.find(')', open);
    std::string name = css.substr(open + 4, close - open - 4);
    std::erase_if(name, [](char c) { return c == '"' || c == '\''; });
    const auto font = bytes_of(folder + "/" + name);
    result += css.substr(done, at - done);
    if (font && name.ends_with(".woff2"))
      result += "src:url(data:font/woff2;base64," + base64(*font) + ") format(\"woff2\")";
    else
      result += css.substr(at, end - at);
    done = end;
  }
  return result + css.substr(done);
}

/// A script as it may stand in a page: no end of the element in it.
std::string script_element(std::string javascript) {
  for (std::size_t at = javascript.find("</"); at != std::string::npos; at = javascript.find("</", at + 3))
    javascript.replace(at, 2, "<\\/");
  return "<script>\n" + javascript + "</script>\n";
}

}  // namespace

std::string html_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        // Control characters have no place in HTML.
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') result += c;
    }
  return result;
}

std::string inline_formula(const std::string& latex) {
  return "<span data-tex=\"" + html_escaped(latex) + "\">" + html_escaped(latex) + "</span>";
}

std::string katex_folder() {
  std::vector<std::string> places{"/usr/share/javascript/katex", "/usr/share/nodejs/katex/dist"};
  if (const char* given = std::getenv("SHORTFALL_KATEX"); given && *given)
    places.insert(places.begin(), given);
  for (const std::string& place : places)
    if (std::ifstream(place + "/katex.min.js") && std::ifstream(place + "/katex.min.css")) return place;
  return {};
}

void PageDocument::section(const std::string& heading) { html("<h2>" + html_escaped(heading) + "</h2>"); }

void PageDocument::paragraph(const std::string& text) { html("<p>" + html_escaped(text) + "</p>"); }

void PageDocument::formula(const std::string& latex) {
  html("<div class=\"formula\" tabindex=\"0\" data-tex=\"" + html_escaped(latex) + "\">" +
       html_escaped(latex) + "</div>");
}

void PageDocument::code(const std::string& source) {
  html("<pre tabindex=\"0\"><code>" + html_escaped(source) + "</code></pre>");
}

void PageDocument::table(const std::string& caption, const std::vector<std::string>& heads,
                         const std::vector<std::vector<std::string>>& rows,
                         const std::vector<bool>& numbers) {
  const auto cell = [&](const char* name, std::size_t column, const std::string& text) {
    const bool number = column < numbers.size() && numbers[column];
    return std::string("<") + name + (name[1] == 'h' ? " scope=\"col\"" : "") +
           (number ? " class=\"number\"" : "") + ">" + html_escaped(text) + "</" + name + ">";
  };
  std::string markup = "<div class=\"table\" tabindex=\"0\"><table><caption>" + html_escaped(caption) +
                       "</caption>\n<thead><tr>";
  for (std::size_t c = 0; c < heads.size(); ++c) markup += cell("th", c, heads[c]);
  markup += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    markup += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) markup += cell("td", c, row[c]);
    markup += "</tr>\n";
  }
  html(markup + "</tbody></table></div>");
}

void PageDocument::tabs(const std::string& what,
                        const std::vector<std::pair<std::string, std::string>>& sources) {
  const std::string group = "tabs-" + std::to_string(++tabs_);
  std::string buttons, panels;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::string id = group + "-" + std::to_string(i);
    buttons += "<button role=\"tab\" id=\"" + id + "-tab\" aria-controls=\"" + id + "\">" +
               html_escaped(sources[i].first) + "</button>\n";
    panels += "<div class=\"panel\" role=\"tabpanel\" id=\"" + id + "\" aria-labelledby=\"" + id +
              "-tab\">\n<h3>" + html_escaped(sources[i].first) +
              "</h3>\n<button class=\"copy\" hidden>Copy</button>\n<pre tabindex=\"0\"><code>" +
              html_escaped(sources[i].second) + "</code></pre></div>\n";
  }
  html("<div class=\"tabs\">\n<div role=\"tablist\" aria-label=\"" + html_escaped(what) + "\">\n" + buttons +
       "</div>\n" + panels + "</div>");
}

void PageDocument::figure(const std::string& svg, const std::string& caption) {
  const std::size_t begin = svg.find("<svg");  // without the prologue of a file
  html("<figure class=\"drawn\">" + svg.substr(begin == std::string::npos ? 0 : begin) + "<figcaption>" +
       html_escaped(caption) + "</figcaption></figure>");
}

std::string PageDocument::text() const {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'unsafe-inline'; font-src data:; img-src data:\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>" +
      html_escaped(title_) + "</title>\n<meta name=\"description\" content=\"" + html_escaped(description_) +
      "\">\n";
  const std::string folder = katex_folder();
  std::string katex;
  if (!folder.empty()) {
    page += "<style>\n" + with_fonts(*bytes_of(folder + "/katex.min.css"), folder) + "\n</style>\n";
    katex = script_element(*bytes_of(folder + "/katex.min.js") + "\n");
  }
  page += "<style>\n" + page_text("page.css") + "</style>\n</head>\n<body>\n";
  page += "<a class=\"skip\" href=\"#content\">To the content</a>\n<header><h1>" + html_escaped(title_) +
          "</h1><button id=\"theme\" hidden aria-label=\"Dark colours\" aria-pressed=\"false\">light / "
          "dark</button></header>\n";
  page += "<main id=\"content\">\n" + body_ + "</main>\n" + katex + script_element(page_text("page.js"));
  for (const std::string& s : scripts_) page += script_element(s);
  return page + "</body>\n</html>\n";
}

}  // namespace shortfall
