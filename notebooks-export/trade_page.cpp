// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/comma_list.hpp"
#include "notebooks-export/figure_gnuplot.hpp"
#include "notebooks-export/page_document.hpp"
#include "notebooks-export/trade_text.hpp"

namespace shortfall {

namespace {

std::string step_words(const Trade& trade, const SceneOutcome& o) {
  if (o.tolerance > 0) return "tolerance " + error_text(o.tolerance, "");
  return short_number(o.choice.frame) + " " + trade.scene.units.time +
         (o.choice.substeps > 1 ? " / " + std::to_string(o.choice.substeps) : "");
}

void tell_answer(PageDocument& page, const Trade& trade) {
  const auto best = cheapest(trade);
  std::string text = "<div class=\"answer\"><p>";
  if (!best) {
    page.html(text + "Nothing that was tried meets all tolerances of this scene.</p></div>");
    return;
  }
  const TradeSeries& s = trade.series[best->series];
  const SceneOutcome& o = s.points[best->point];
  text += "The cheapest that meets every tolerance: <strong>" + html_escaped(s.label) +
          "</strong> with a step of " + html_escaped(step_words(trade, o)) + ": " +
          std::to_string(o.evaluations) + " evaluations of the force" +
          (trade.timed ? ", " + html_escaped(duration_text(o.nanoseconds)) + " for the whole scene"
                       : std::string()) +
          ".</p>\n<ul>\n";
  for (std::size_t i = 0; i < trade.scene.observables.size(); ++i) {
    const SceneObservable& w = trade.scene.observables[i];
    text += "<li>" + html_escaped(w.name) + ": error " + html_escaped(error_text(o.errors[i], w.unit)) +
            ", tolerance " + html_escaped(error_text(w.tolerance.to_double(), w.unit)) + "</li>\n";
  }
  page.html(text + "</ul></div>");
}

void tell_points(PageDocument& page, const Trade& trade) {
  std::vector<std::string> heads{"", "step", "steps", "evaluations"};
  std::vector<bool> numbers{false, false, true, true};
  if (trade.timed) heads.emplace_back("time");
  for (const SceneObservable& w : trade.scene.observables)
    heads.push_back(w.name + (w.unit.empty() ? "" : " (" + w.unit + ")"));
  numbers.resize(heads.size(), true);
  std::vector<std::vector<std::string>> rows;
  for (const TradeSeries& s : trade.series)
    for (const SceneOutcome& o : s.points) {
      std::vector<std::string> row{s.label, step_words(trade, o), std::to_string(o.steps),
                                   std::to_string(o.evaluations)};
      if (trade.timed) row.push_back(o.failed ? "" : duration_text(o.nanoseconds));
      for (std::size_t i = 0; i < trade.scene.observables.size(); ++i)
        row.push_back(o.failed ? (i == 0 ? o.why : std::string()) : error_text(o.errors[i], ""));
      rows.push_back(std::move(row));
    }
  page.html("<details><summary>Every point</summary>");
  page.table("Errors are exact minus computed; of places, paths and energies their size.", heads, rows,
             numbers);
  page.html("</details>");
}

}  // namespace

std::string trade_page(const Trade& trade, const std::string& command) {
  const std::string title = trade.scene.title.empty() ? trade.scene.name : trade.scene.title;
  PageDocument page(
      title, "Accuracy against speed: what each way of stepping this scene costs, and what error it makes");
  tell_answer(page, trade);
  if (gnuplot_is_here()) {
    page.section("Error against cost");
    page.figure(image(trade_figure(trade), ImageFormat::svg),
                "A panel for each observable. Shaded: within the tolerance. The lower and the further left, "
                "the better.");
  }
  page.section("The cheapest of each");
  const CheapestPoints table = cheapest_points(trade);
  if (table.rows.size() > 1)
    page.table("Within all tolerances; * the cheapest of all", table.rows.front(),
               {table.rows.begin() + 1, table.rows.end()},
               {false, false, true, true, true, true, true, true, true, true, true, true});
  if (!table.unable.empty()) {
    page.paragraph("Not within the tolerances at any step that was tried: " + comma_list(table.unable) + ".");
  }
  tell_points(page, trade);
  page.section("How these numbers are known");
  page.paragraph("The truth is known by " + trade.reference.how + ".");
  if (trade.timed)
    page.paragraph(
        "Times are processor times on the machine where this page was written: the least of repeated runs of "
        "compiled code, "
        "interleaved. Steppers of other libraries call the same force.");
  page.code(command);
  return page.text();
}

}  // namespace shortfall
