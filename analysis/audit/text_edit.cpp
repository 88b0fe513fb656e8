// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/text_edit.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "analysis/algebra/characters.hpp"
#include "analysis/audit/slip.hpp"

namespace shortfall {

namespace {

constexpr double kLater = 1e-4;  // of two equal names the later one is the copy

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Where a line's expressions begin: behind `=`, or behind `kick` and `drift`.
std::size_t expression_begin(const std::string& line) {
  const std::string word = trimmed(line).substr(0, trimmed(line).find_first_of(" \t"));
  if (word == "kick" || word == "drift") return line.find(word) + word.size();
  const std::size_t equals = line.find('=');
  return equals == std::string::npos ? line.size() : equals + 1;
}

class Edits {
 public:
  explicit Edits(const std::string& text) : lines_(lines_of(text)) {}

  std::vector<TextEdit> operator()() {
    std::string block;
    std::vector<int> of_block;
    collect_names();
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      std::string line = lines_[i].substr(0, lines_[i].find('#'));
      const std::string word = trimmed(line).substr(0, trimmed(line).find_first_of(" \t"));
      if (word.empty()) continue;
      const int number = static_cast<int>(i) + 1;
      if (word == "approx") {
        approximation(number, line);
        continue;
      }
      if (line.find_first_not_of(" \t") == 0) {
        block = word;
        of_block.clear();
        continue;
      }
      if (block != "start" && block != "step" && block != "finish" && block != "splitting") continue;
      numbers(number, line);
      signs(number, line);
      names(number, line);
      times(number, line);
      kick_or_drift(number, line, word);
      if (!of_block.empty() && of_block.back() == number - 1) neighbours(number);
      of_block.push_back(number);
    }
    all_kicks();
    return std::move(edits_);
  }

 private:
  void add(int number, std::string line, std::string words, double cost) {
    edits_.push_back({{{number, std::move(line)}}, std::move(words), cost, {}, false});
  }

  void collect_names() {
    std::string block;
    for (const std::string& whole : lines_) {
      const std::string line = whole.substr(0, whole.find('#'));
      const std::string word = trimmed(line).substr(0, trimmed(line).find_first_of(" \t"));
      if (word.empty()) continue;
      if (word == "approx" || word == "param" || word == "root") {
        std::size_t i = line.find(word) + word.size();
        while (i < line.size() && line[i] == ' ') ++i;
        std::size_t end = i;
        while (end < line.size() && is_word(line[end])) ++end;
        names_.insert(line.substr(i, end - i));
      }
      if (line.find_first_not_of(" \t") == 0) block = word;
      const std::size_t equals = line.find('=');
      if ((block == "start" || block == "step") && equals != std::string::npos)
        names_.insert(trimmed(line.substr(0, equals)));
    }
    names_.insert({"x", "v"});
  }

  void approximation(int number, const std::string& line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) return;
    const std::size_t begin = line.find_first_not_of(" \t", equals + 1);
    if (begin == std::string::npos) return;
    const std::string decimal = trimmed(line.substr(begin));
    const std::size_t word = line.find("approx");
    const std::string name = trimmed(line.substr(word + 6, equals - word - 6));
    TextEdit edit;
    std::string declared = line;
    declared.replace(word, 6, "param");
    edit.lines.push_back({number, declared});
    edit.unknown = {name, Rational::parse(decimal),       line.substr(0, begin), decimal,
                    "",   TextEdit::Unknown::Form::factor};
    edits_.push_back(std::move(edit));
    add(number, line.substr(0, begin) + (decimal.starts_with('-') ? decimal.substr(1) : "-" + decimal),
        "a sign is the other one", 1);
  }

  void numbers(int number, const std::string& line) {
    for (std::size_t i = expression_begin(line); i < line.size(); ++i) {
      if (!is_digit(line[i])) continue;
      std::size_t begin = i, end = i;
      while (end < line.size() && (is_digit(line[end]) || line[end] == '.')) ++end;
      const bool in_name = begin > 0 && is_word(line[begin - 1]);
      std::size_t back = begin;
      while (back > 0 && line[back - 1] == ' ') --back;
      const char before = back > 0 ? line[back - 1] : ' ';
      if (in_name || before == '^') {
        i = end;
        continue;
      }
      // p/q is one number, unless q belongs to something else.
      if (before != '/' && end + 1 < line.size() && line[end] == '/' && is_digit(line[end + 1])) {
        std::size_t more = end + 1;
        while (more < line.size() && is_digit(line[more])) ++more;
        if (more == line.size() || (line[more] != '^' && !is_word(line[more]))) end = more;
      }
      unknown_number(number, line, before == '/' ? back - 1 : begin, begin, end);
      i = end;
    }
  }

  void unknown_number(int number, const std::string& line, std::size_t from, std::size_t begin,
                      std::size_t end) {
    const std::string digits = line.substr(begin, end - begin);
    const Rational value = Rational::parse(digits);
    if (value.is_zero()) return;
    const bool divides = from != begin;
    TextEdit edit;
    edit.lines.push_back(
        {number, line.substr(0, from) + (divides ? "*(" : "(") + kUnknownName + ")" + line.substr(end)});
    edit.unknown = {
        kUnknownName,         divides ? Rational(1) / value : value,
        line.substr(0, from), line.substr(from, end - from),
        line.substr(end),     divides ? TextEdit::Unknown::Form::divisor : TextEdit::Unknown::Form::factor};
    edits_.push_back(std::move(edit));
  }

  void signs(int number, const std::string& line) {
    const std::size_t first = expression_begin(line);
    for (std::size_t i = first; i < line.size(); ++i) {
      if (line[i] != '+' && line[i] != '-') continue;
      std::string other = line;
      other[i] = line[i] == '+' ? '-' : '+';
      if (trimmed(line.substr(first, i - first)).empty()) other.erase(i, 1);  // a leading sign
      add(number, other, "a sign is the other one", 1);
    }
    const std::size_t value = line.find_first_not_of(" \t", first);
    if (value != std::string::npos && line[value] != '-' && line[value] != '+')
      add(number, line.substr(0, value) + "-" + line.substr(value), "a sign is lost", 1);
  }

  void names(int number, const std::string& line) {
    for (std::size_t i = expression_begin(line); i < line.size(); ++i) {
      if (!std::isalpha(static_cast<unsigned char>(line[i])) || (i > 0 && is_word(line[i - 1]))) continue;
      std::size_t end = i;
      while (end < line.size() && is_word(line[end])) ++end;
      const std::string word = line.substr(i, end - i);
      if (!names_.contains(word) || (end < line.size() && line[end] == '(')) continue;
      for (const std::string& other : names_)
        if (other != word)
          add(number, line.substr(0, i) + other + line.substr(end), word + " stands for " + other,
              1.4 - kLater * static_cast<double>(i));
    }
  }

  /// The third argument of each a(x, v, t).
  void times(int number, const std::string& line) {
    for (std::size_t i = line.find("a("); i != std::string::npos; i = line.find("a(", i + 1)) {
      if (i > 0 && is_word(line[i - 1])) continue;
      std::size_t begin = 0, end = i + 2;
      int depth = 1, commas = 0;
      for (; end < line.size(); ++end) {
        if (line[end] == '(') ++depth;
        if (line[end] == ')' && --depth == 0) break;
        if (line[end] == ',' && depth == 1 && ++commas == 2) begin = end + 1;
      }
      if (commas != 2 || end >= line.size()) continue;
      while (begin < end && line[begin] == ' ') ++begin;
      const std::string printed = line.substr(begin, end - begin);
      const std::string words = "the force is taken at the wrong time";
      for (const std::string time : {"t", "t + h", "t + h/2"})
        if (time != printed) add(number, line.substr(0, begin) + time + line.substr(end), words, 1.2);
      TextEdit edit;
      edit.words = words;
      edit.cost = 1.2;
      edit.lines.push_back(
          {number, line.substr(0, begin) + "t + (" + kUnknownName + ")*h" + line.substr(end)});
      edit.unknown = {kUnknownName, Rational(1, 3),   line.substr(0, begin),
                      printed,      line.substr(end), TextEdit::Unknown::Form::time};
      edits_.push_back(std::move(edit));
    }
  }

  static std::string other_kind(const std::string& line, const std::string& word) {
    std::string result = line;
    result.replace(line.find(word), word.size(), word == "kick" ? "drift" : "kick ");
    return result;
  }

  void kick_or_drift(int number, const std::string& line, const std::string& word) {
    if (word != "kick" && word != "drift") return;
    splitting_.push_back({number, other_kind(line, word)});
    add(number, other_kind(line, word), word + " stands for " + (word == "kick" ? "drift" : "kick"), 1.8);
  }

  void all_kicks() {
    if (splitting_.empty()) return;
    TextEdit edit;
    edit.lines = splitting_;
    edit.words = "kicks and drifts are exchanged";
    edit.cost = 1.2;
    edit.exchanges_kicks = true;
    edits_.push_back(std::move(edit));
  }

  void neighbours(int number) {
    TextEdit edit;
    edit.lines.push_back({number - 1, lines_[number - 1]});
    edit.lines.push_back({number, lines_[number - 2]});
    edit.words = "two lines are exchanged";
    edit.cost = 1.8;
    edits_.push_back(std::move(edit));
  }

  std::vector<std::string> lines_;
  std::set<std::string> names_;
  std::vector<TextEdit::Line> splitting_;
  std::vector<TextEdit> edits_;
};

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
}

std::vector<TextEdit> text_edits(const std::string& text) { return Edits(text)(); }

std::vector<TextEdit> digit_edits(const std::string& text) {
  constexpr std::size_t kLongest = 6;  // of long numbers there are too many neighbours
  std::vector<TextEdit> result;
  for (const TextEdit& edit : text_edits(text)) {
    if (!edit.unknown || edit.unknown->form == TextEdit::Unknown::Form::time) continue;
    const std::string& token = edit.unknown->token;
    if (token.size() > kLongest) continue;
    for (const std::string& before : before_a_slip(token)) {
      if (before.starts_with('-')) continue;  // signs were tried
      const Slip s = slip(token, before);
      result.push_back({{{edit.lines[0].number, edit.unknown->line(before)}}, s.words, s.cost, {}, false});
    }
  }
  return result;
}

std::string edited(const std::string& text, const TextEdit& edit) {
  std::vector<std::string> lines = lines_of(text);
  for (const TextEdit::Line& line : edit.lines) lines[static_cast<std::size_t>(line.number) - 1] = line.text;
  const bool declare = edit.unknown && edit.unknown->name == kUnknownName;
  std::string result;
  for (const std::string& line : lines) {
    result += line + "\n";
    if (declare && line.starts_with("integrator"))
      result += "  param " + kUnknownName + " = " + edit.unknown->printed.str() + "\n";
  }
  return result;
}

}  // namespace shortfall
