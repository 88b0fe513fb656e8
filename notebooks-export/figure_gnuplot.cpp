// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_gnuplot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/general_text.hpp"
#include "notebooks-export/figure_palette.hpp"

namespace shortfall {

namespace {

using Ink = Figure::Ink;

// Pixels.
constexpr int kHeight = 540;
constexpr int kBelow = 72;   // tics and label of the x axis
constexpr int kAbove = 108;  // titles
constexpr int kLeft = 84;    // tics and label of the y axis
constexpr int kRight = 28;
constexpr int kPlotHeight = kHeight - kBelow - kAbove;
constexpr int kPlotWidth = 480;
constexpr int kNarrowest = 300;  // leaves room for a title
constexpr int kWidest = 560;

/// How wide a panel's plot is.
int plot_width(const Figure::Panel& p) {
  if (!p.equal_scales) return kPlotWidth;
  const double width = kPlotHeight * (p.x.high - p.x.low) / (p.y.high - p.y.low);
  return std::clamp(static_cast<int>(std::lround(width)), kNarrowest, kWidest);
}

/// The colour mixed with white, as gnuplot reads it.
std::string rgb(const Colour& c, double strength = 1) {
  const auto mixed = [&](int part) {
    return static_cast<unsigned>(std::lround(255 - strength * (255 - part)));
  };
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "'#%02x%02x%02x'", mixed(c.red), mixed(c.green), mixed(c.blue));
  return text.data();
}

std::string number_text(double value) { return general_text(value, 7); }

std::string gnuplot_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  }
  return result + "'";
}

std::string axis_label(const Figure::Axis& axis) {
  return axis.label + (axis.unit.empty() ? "" : " (" + axis.unit + ")");
}

/// Names and writes the blocks of data, and the commands that draw them.
class PanelWriter {
 public:
  PanelWriter(const Figure::Panel& panel, int index)
      : panel_(panel), prefix_("$p" + std::to_string(index) + "_") {
    for (const Figure::Region& r : panel.regions) add_region(r);
    for (const Figure::Curve& c : panel.curves) add_curve(c);
    for (const Figure::Mark& m : panel.marks)
      plots_.push_back(block({{m.at}}) + " using 1:2 with points pt 7 ps " + number_text(m.size) +
                       " lc rgb " + rgb(colour(m.ink)) + " notitle");
  }

  const std::string& data() const { return data_; }

  /// param   title  of the whole figure; empty except above the first panel
  std::string commands(const std::string& title) const {
    std::string text = "unset label\n" + heading(panel_.title, panel_.note.empty() ? 14 : 34, "", Ink::black);
    if (!panel_.note.empty()) text += heading(panel_.note, 14, " font ',11'", Ink::dark);
    if (!title.empty()) text += heading(title, 66, " font ',16'", Ink::black);
    text += axis("x", panel_.x) + axis("y", panel_.y);
    text += panel_.equal_scales ? "set size ratio -1\n" : "set size noratio\n";
    for (const Figure::Label& l : panel_.labels) text += label(l);
    text += "plot ";
    for (std::size_t i = 0; i < plots_.size(); ++i) text += (i ? ", \\\n     " : "") + plots_[i];
    return text + (plots_.empty() ? "NaN notitle\n" : "\n");
  }

 private:
  std::string block(const std::vector<Figure::Path>& paths) {
    std::string name = prefix_ + std::to_string(count_++);
    data_ += name + " << END_OF_DATA\n";
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (i > 0) data_ += "\n";
      for (const Figure::Point& p : paths[i]) data_ += number_text(p.x) + " " + number_text(p.y) + "\n";
    }
    data_ += "END_OF_DATA\n";
    return name;
  }

  void add_region(const Figure::Region& r) {
    for (const Figure::Path& path : r.outlines)
      plots_.push_back(block({path}) +
                       " using 1:2 with filledcurves closed fillstyle solid noborder fillcolor rgb " +
                       rgb(colour(r.ink), r.strength) + " notitle");
  }

  void add_curve(const Figure::Curve& c) {
    if (c.paths.empty()) return;
    plots_.push_back(block(c.paths) + " using 1:2 with lines lw " + number_text(c.width) +
                     (c.dashed ? " dt (6,5)" : " dt solid") + " lc rgb " + rgb(colour(c.ink)) + " notitle");
  }

  /// A line of text above the panel, so many pixels up.
  static std::string heading(const std::string& text, int up, const std::string& font, Ink ink) {
    return "set label " + gnuplot_quoted(text) + " at graph 0,graph " +
           number_text(1 + up / static_cast<double>(kPlotHeight)) + " left" + font + " textcolor rgb " +
           rgb(text_colour(ink)) + " front\n";
  }

  static std::string axis(const std::string& which, const Figure::Axis& a) {
    return "set " + which + "label " + gnuplot_quoted(axis_label(a)) + " textcolor rgb " +
           rgb(text_colour(Ink::black)) + "\n" + (a.logarithmic ? "set" : "unset") + " logscale " + which +
           "\n" + "set " + which + "range [" + number_text(a.low) + ":" + number_text(a.high) + "]\n" +
           tics(which, a);
  }

  /// On a logarithmic axis powers of ten, as many as have room for their numbers.
  static std::string tics(const std::string& which, const Figure::Axis& a) {
    if (!a.logarithmic || which != "x") return "set format " + which + "\nset " + which + "tics autofreq\n";
    constexpr double kMostTics = 7;
    const double each = std::max(1.0, std::ceil(std::log10(a.high / a.low) / kMostTics));
    return "set format x '%g'\nset xtics " + number_text(std::pow(10, each)) + "\n";
  }

  static std::string label(const Figure::Label& l) {
    const char* align = l.align == Figure::Align::left    ? "left"
                        : l.align == Figure::Align::right ? "right"
                                                          : "center";
    return "set label " + gnuplot_quoted(l.text) + " at " + number_text(l.at.x) + "," + number_text(l.at.y) +
           " " + align + " offset 0," + number_text(l.up) + " textcolor rgb " + rgb(text_colour(l.ink)) +
           " front\n";
  }

  const Figure::Panel& panel_;
  std::string prefix_;
  int count_ = 0;
  std::string data_;
  std::vector<std::string> plots_;
};

std::string terminal(ImageFormat format, int width) {
  const std::string pixels = std::to_string(width) + "," + std::to_string(kHeight);
  switch (format) {
    case ImageFormat::svg:
      return "set terminal svg size " + pixels +
             " dynamic noenhanced font 'Helvetica,13' background rgb 'white'\n";
    case ImageFormat::png:  // twice the pixels, for sharp screens
      return "set terminal pngcairo size " + std::to_string(2 * width) + "," + std::to_string(2 * kHeight) +
             " noenhanced font 'DejaVu Sans,11' fontscale 2 linewidth 2 pointscale 2\n";
    case ImageFormat::pdf:
      return "set terminal pdfcairo size " + number_text(width / 100.0) + "in," +
             number_text(kHeight / 100.0) + "in noenhanced font 'DejaVu Sans,11' linewidth 1.4\n";
  }
  return "";
}

}  // namespace

ImageFormat image_format(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == "svg") return ImageFormat::svg;
  if (ending == "png") return ImageFormat::png;
  if (ending == "pdf") return ImageFormat::pdf;
  throw BadInput("'" + path.substr(0, 200) +
                 "': a figure is written to a file that ends in .svg, .png or .pdf");
}

std::string gnuplot_script(const Figure& figure, ImageFormat format) {
  int width = 0;
  for (const Figure::Panel& p : figure.panels) width += kLeft + plot_width(p) + kRight;
  width = std::max(width, kLeft + kPlotWidth + kRight);
  std::string script = "set encoding utf8\n" + terminal(format, width);
  std::string drawing;
  int left = 0;
  const auto across = [&](int pixels) { return number_text(static_cast<double>(pixels) / width); };
  const std::string upright = "set bmargin at screen " + number_text(static_cast<double>(kBelow) / kHeight) +
                              "\nset tmargin at screen " +
                              number_text(1 - static_cast<double>(kAbove) / kHeight) + "\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const PanelWriter writer(figure.panels[i], static_cast<int>(i));
    script += writer.data();
    left += kLeft;
    drawing += "set lmargin at screen " + across(left) + "\nset rmargin at screen " +
               across(left + plot_width(figure.panels[i])) + "\n" +
               writer.commands(i == 0 ? figure.title : "");
    left += plot_width(figure.panels[i]) + kRight;
  }
  script += "set border 3 lw 1 lc rgb " + rgb(colour(Ink::grey)) +
            "\nset tics nomirror out scale 0.6 textcolor rgb " + rgb(text_colour(Ink::black)) +
            "\nset key off\nset clip one\nset clip two\n" + upright;
  return script + "set multiplot\n" + drawing + "unset multiplot\n";
}

}  // namespace shortfall
