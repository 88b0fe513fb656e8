// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/parse.hpp"

#include <algorithm>
#include <cctype>

#include "analysis/program/file_text.hpp"
#include "analysis/program/head.hpp"
#include "analysis/program/splitting.hpp"
#include "analysis/program/statement_reader.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/program/tableau.hpp"
#include "analysis/program/token_reader.hpp"

namespace shortfall {

namespace {

// Functions and not constants: a file may be parsed while another translation unit sets up its own.
const std::vector<std::string>& block_words() {
  static const std::vector<std::string> words{"start", "step", "finish", "tableau", "splitting", "expect"};
  return words;
}
const std::vector<std::string>& claim_words() {
  static const std::vector<std::string> words{
      "exact", "shortfall", "shortfall-velocity", "trace",      "determinant",
      "limit", "order",     "embedded-order",     "symplectic", "symmetric"};
  return words;
}

/// What a force may read, behind `order P if`.
const std::vector<std::string>& force_notations() {
  static const std::vector<std::string> notations{"a(x, v, t)", "a(x, t)", "a(x, v)",
                                                  "a(x)",       "a(t)",    "T(p) + V(q)"};
  return notations;
}

bool is_one_of(const std::string& word, const std::vector<std::string>& words) {
  return std::ranges::find(words, word) != words.end();
}

class FileParser {
 public:
  FileParser(const Source& source) : source_(source) { program_.file = source.file(); }

  Program parsed() {
    while (next_line()) read_line();
    if (const auto* open = statements_.open())
      throw source_.error(open->place, "this " + open->word + " { is never closed");
    if (program_.name.empty()) throw source_.error({1, 1}, "an integrator file begins with: integrator NAME");
    if (!seen_.contains("step") && !program_.tableau && !program_.splitting)
      throw source_.error({source_.line_count(), 1}, "the integrator has no step (and no tableau)");
    if (seen_.contains("step") && program_.step.empty())
      throw source_.error(step_, "the step block is empty");
    if (program_.tableau) lower_tableau(program_, source_);
    if (program_.splitting) lower_splitting(program_, source_);
    check(program_, source_);
    return std::move(program_);
  }

 private:
  /// Moves to the next line that is not blank; remembers comments above `integrator`.
  bool next_line() {
    while (++line_ <= source_.line_count()) {
      const std::string& text = source_.line(line_);
      byte_ = text.find_first_not_of(" \t");
      if (byte_ == std::string::npos) continue;
      if (text[byte_] != '#') return true;
      if (program_.name.empty()) {
        std::size_t from = text.find_first_not_of("# \t", byte_);
        std::string comment = from == std::string::npos ? "" : text.substr(from);
        if (!program_.description.empty()) program_.description += '\n';
        program_.description += comment;
      }
    }
    return false;
  }

  Place here() const { return source_.place(line_, byte_); }
  SyntaxError error(const std::string& what) const { return source_.error(here(), what); }

  /// The word at the cursor: letters, digits, hyphens, underscores.
  std::string word() const {
    const std::string& text = source_.line(line_);
    std::size_t end = byte_;
    while (end < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '-' || text[end] == '_'))
      ++end;
    return text.substr(byte_, end - byte_);
  }

  void skip(std::size_t bytes) {
    byte_ = source_.line(line_).find_first_not_of(" \t", byte_ + bytes);
    if (byte_ == std::string::npos) byte_ = source_.line(line_).size();
  }

  /// What remains of the line, without comment markers being special and without trailing blanks.
  std::string rest(const std::string& what) const {
    std::string text = source_.line(line_).substr(byte_);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.pop_back();
    if (text.empty()) throw error("expected " + what);
    return text;
  }

  TokenReader reader() { return TokenReader(source_, tokens(source_, line_, byte_)); }

  bool at_end_of_line() const {
    return byte_ >= source_.line(line_).size() || source_.line(line_)[byte_] == '#';
  }

  void read_line() {
    const std::string first = word();
    if (first == "integrator") return read_name();
    if (program_.name.empty()) {
      const bool misspelt = !nearest(first, {"integrator"}).empty();
      throw error(misspelt ? "unknown word '" + first + "'; did you mean 'integrator'?"
                           : "an integrator file begins with: integrator NAME");
    }
    const bool assigned = next_is_equals(first);
    if (is_one_of(first, block_words()) && !assigned) return open_block(first);
    if (block_.empty()) return read_head(first);
    if (is_one_of(first, head_words()) && !assigned)
      throw error("'" + first + "' stands at the head of the file, before the blocks");
    if (block_ == "tableau") return read_row(first);
    if (block_ == "splitting") return read_part(first);
    if (block_ == "expect") return read_claim(first);
    read_statement(first);
  }

  bool next_is_equals(const std::string& first) const {
    const std::string& text = source_.line(line_);
    const std::size_t next = text.find_first_not_of(" \t", byte_ + first.size());
    return next != std::string::npos && text[next] == '=';
  }

  void read_name() {
    if (!program_.name.empty())
      throw error("a file holds one integrator; '" + program_.name + "' was begun above");
    skip(10);
    const std::string name = rest("a name after integrator");
    const std::string bare = name.substr(0, name.find('#'));
    const std::string plain = as_name(bare);
    const std::string rule =
        "a name is made of lower-case letters, digits and hyphens and begins with a letter";
    if (plain.empty()) throw error(rule + "; found '" + bare.substr(0, 80) + "'");
    if (plain.size() > Program::kLongestName)
      throw error("a name has at most " + std::to_string(Program::kLongestName) + " characters");
    if (plain != bare.substr(0, bare.find_last_not_of(" \t") + 1)) throw error(rule + ": " + plain);
    program_.name = plain;
  }

  /// What the writer of a name may have meant: lower case, blanks and underscores as hyphens; "" when it is
  /// beyond repair.
  static std::string as_name(const std::string& text) {
    std::string result;
    for (const char c : text) {
      if (std::isalnum(static_cast<unsigned char>(c)))
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      else if (c == ' ' || c == '\t' || c == '_' || c == '-')
        result += '-';
      else
        return "";
    }
    while (result.ends_with('-')) result.pop_back();
    const bool begins_well = !result.empty() && std::isalpha(static_cast<unsigned char>(result[0]));
    return begins_well ? result : "";
  }

  void read_head(const std::string& first) {
    const Place place = here();
    if (first == "alias" || first == "source") {
      skip(first.size());
      (first == "alias" ? program_.aliases : program_.sources).push_back(rest("text after " + first));
      return;
    }
    if (is_one_of(first, head_words())) {
      skip(first.size());
      TokenReader in = reader();
      return read_declaration(program_, first, in, place);
    }
    std::vector<std::string> words = head_words();
    words.insert(words.end(), block_words().begin(), block_words().end());
    static const std::vector<std::string> statement_words{"solve", "substeps", "when", "limit"};
    if (first.empty() || next_is_equals(first) || is_one_of(first, statement_words))
      throw source_.error(place, "a statement stands in a start, step or finish block; none is open");
    if (is_one_of(first, claim_words()))
      throw source_.error(place, "'" + first + "' is a claim and stands in an expect block; none is open");
    throw source_.error(place, "unknown word '" + first + "'" + did_you_mean(first, words));
  }

  void open_block(const std::string& block) {
    if (const auto* open = statements_.open())
      throw source_.error(open->place, "this " + open->word + " { is not closed before '" + block + "'");
    if (!seen_.insert(block).second) throw error("there is already a " + block + " block");
    if ((block == "tableau" || block == "splitting") && seen_.contains("step"))
      throw error("an integrator has a step or a " + block + ", not both");
    if (block == "step" && (seen_.contains("tableau") || seen_.contains("splitting")))
      throw error(seen_.contains("tableau") ? "an integrator has a step or a tableau, not both"
                                            : "an integrator has a step or a splitting, not both");
    if ((block == "tableau" && seen_.contains("splitting")) ||
        (block == "splitting" && seen_.contains("tableau")))
      throw error("an integrator has a tableau or a splitting, not both");
    const Place place = here();
    skip(block.size());
    if (!at_end_of_line())
      throw error("'" + block + "' stands alone on its line; what belongs to it follows below");
    block_ = block;
    if (block == "step") step_ = place;
    if (block == "start") statements_.begin(program_.start, false);
    if (block == "step") statements_.begin(program_.step, true);
    if (block == "finish") statements_.begin(program_.finish, false);
    if (block == "tableau") {
      program_.tableau.emplace();
      program_.tableau->place = place;
    }
    if (block == "splitting") {
      program_.splitting.emplace();
      program_.splitting->place = place;
    }
  }

  void read_statement(const std::string& first) {
    const bool assigned = next_is_equals(first);
    if (is_one_of(first, claim_words()) && !assigned && !(first == "limit" && block_ == "step"))
      throw error("'" + first + "' is a claim and stands in an expect block");
    TokenReader in = reader();
    if (in.peek().kind == Token::Kind::name && !assigned && !nearest(first, block_words()).empty()) {
      TokenReader ahead = in;
      ahead.take();
      if (ahead.at_end()) throw error("unknown word '" + first + "'" + did_you_mean(first, block_words()));
    }
    statements_.read(in, assigned ? "" : first);
  }

  void read_part(const std::string& first) {
    const Place place = here();
    if (first != "kick" && first != "drift")
      throw error("a splitting holds rows such as: kick 1/2, drift 1" +
                  did_you_mean(first, {"kick", "drift"}));
    skip(first.size());
    TokenReader in = reader();
    read_splitting_row(*program_.splitting, first, in, place);
  }

  void read_row(const std::string& first) {
    read_tableau_row(*program_.tableau, source_, line_, byte_, first);
  }

  void read_claim(const std::string& first) {
    if (first.empty() || next_is_equals(first))
      throw error("a statement stands in a start, step or finish block, not in expect");
    if (!is_one_of(first, claim_words()))
      throw error(
          "unknown claim '" + first + "'" + did_you_mean(first, claim_words()) +
          (nearest(first, claim_words()).empty()
               ? "; the claims are exact, shortfall, shortfall-velocity, trace, determinant, limit, order, "
                 "embedded-order, symplectic, symmetric"
               : ""));
    const Place place = here();
    skip(first.size());
    TokenReader in = reader();
    if (first == "symplectic" || first == "symmetric") {
      in.expect_end("the claim");
      program_.claims.push_back({first, nullptr, place});
      return;
    }
    if (in.at_end()) throw in.error("expected a value after '" + first + "', found the end of the line");
    if (first == "order" || first == "embedded-order") return read_order(first, in, place);
    program_.claims.push_back({first, in.expression(), place});
    in.expect_end("the claim");
  }

  /// order 4, order 6 if a(x, t).
  void read_order(const std::string& first, TokenReader& in, const Place& place) {
    const auto number_read = in.signed_number("an order");
    Claim claim{first, number(number_read.value, number_read.place), place};
    if (!in.at_end()) {
      if (in.peek().kind != Token::Kind::name)
        throw in.error(
            "an order is a whole number, with 'if' and what the force may read behind it where it "
            "is not for every force; found " +
            in.found());
      if (in.peek().text != "if")
        throw in.error("expected 'if' and what the force may read, as in: " + first +
                       " 4 if a(x, t); found " + in.found());
      in.take();
      const Place notation_place = in.peek().place;
      std::string notation;
      while (!in.at_end()) notation += in.take().text;
      for (const std::string& known : force_notations()) {
        std::string bare = known;
        std::erase(bare, ' ');
        if (bare == notation) claim.forces = known;
      }
      if (claim.forces.empty())
        throw in.error(
            notation_place,
            "a force is said by what it reads: a(x, v, t), a(x, t), a(x, v), a(x) or a(t); or T(p) + V(q)" +
                did_you_mean(notation, force_notations()));
    }
    program_.claims.push_back(std::move(claim));
  }

  const Source& source_;
  Program program_;
  std::set<std::string> seen_;
  std::string block_;
  StatementReader statements_;
  Place step_;
  int line_ = 0;
  std::size_t byte_ = 0;
};

}  // namespace

Program parse(std::string_view text, const std::string& file) {
  const Source source(file, text);
  FileParser parser(source);
  return parser.parsed();
}

Program parse_file(const std::string& path) { return parse(file_text(path), path); }

Expr parse_formula(std::string_view text, const std::string& origin, const Names& names, const Type& wanted) {
  const Source source(origin, text);
  if (source.line_count() > 1) throw source.error({2, 1}, "a formula stands on one line");
  int line = 1;
  TokenReader in(source, tokens(source, line, 0), names.functions, names.force);
  Expr e = in.expression();
  in.expect_end("the formula");
  const Type type = type_of(e, names, source);
  if (!type.zero && !type.same_as(wanted))
    throw source.error(beginning(e), "the formula is a " + type.str() + ", expected a " + wanted.str());
  return e;
}

const Parameter* Program::parameter(const std::string& name) const {
  for (const Parameter& p : parameters)
    if (p.name == name) return &p;
  return nullptr;
}

}  // namespace shortfall
