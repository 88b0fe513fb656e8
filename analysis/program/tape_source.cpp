// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/tape_source.hpp"

namespace shortfall {

int TapeSource::add(const Statement& s) {
  statements_.push_back(s);
  statements_.back().body.clear();
  return static_cast<int>(statements_.size()) - 1;
}

const Statement* TapeSource::statement_of(const Instruction& i) const {
  const auto found = statement_.find(&i);
  return found == statement_.end() || found->second < 0
             ? nullptr
             : &statements_[static_cast<std::size_t>(found->second)];
}

void TapeSource::note(const Block& block, const std::vector<int>& statements) {
  for (std::size_t i = 0; i < statements.size(); ++i) statement_[&block[i]] = statements[i];
}

}  // namespace shortfall
