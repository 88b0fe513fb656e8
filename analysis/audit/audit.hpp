// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/progress.hpp"
#include "analysis/program/source.hpp"

namespace shortfall {

/// One claim about a method, and what became of it.
struct AuditClaim {
  enum class Verdict { holds, refuted, undecided };

  std::string claim;  ///< "order 4", "c = A 1", "exact 0"
  Verdict verdict = Verdict::undecided;
  std::string found;  ///< what is true: "order 4", "order 2"; the reason when it is undecided
  /// Why it is refuted: the first condition that fails, with its defect; further ones.
  std::vector<std::string> reasons;
  int digits = 0;      ///< 0: proved; otherwise it holds to so many digits after the point
  bool proved = true;  ///< false: what was looked at contradicts nothing, and `found` says what that was
  bool stated = true;  ///< by the file; c = A 1 is not, it goes without saying
  Place place;
};

/// How many of the conditions that fail are told as reasons.
inline constexpr std::size_t kMostReasons = 3;

/// One place of a file as it is and as it may have been meant.
struct Change {
  std::string where;  ///< "A[4][2]", "c", "line 7"
  std::string printed;
  std::string right;
};

/// What a mend restores when no claim is refuted with it.
inline constexpr const char* kEveryClaim = "every claim";

/// A change after which more of the claims hold. Never more than probable: the author alone knows what was
/// meant.
struct Mend {
  enum class Kind { entry, entries, everywhere, exchange, line, exact_value, claim };

  Kind kind = Kind::entry;
  std::vector<Change> changes;
  std::string slip;      ///< what would have happened: "two digits change places"; may be empty
  std::string restores;  ///< kEveryClaim, "order 3"
  /// How many conditions depend on what is changed, beyond those from which its value was found: each of them
  /// would fail for a wrong guess.
  int checks = 0;
  int digits = 0;   ///< 0: what it restores is proved; otherwise to so many digits after the point
  double cost = 0;  ///< how improbable the slip is; they are ranked by it
};

/// How many mends are told at most; a reader tries no more of them.
inline constexpr std::size_t kMostMends = 8;

/// What a file says about its method, held against its coefficients.
struct Audit {
  std::string name;
  std::string file;
  std::string kind;  ///< "Runge-Kutta tableau", "Nystroem tableau", "splitting", "integrator"
  std::vector<AuditClaim> claims;
  std::vector<std::string> facts;  ///< worth knowing and not claimed
  std::vector<Mend> mends;         ///< the most probable first
  std::vector<std::string> notes;
  int digits = 0;  ///< 0: coefficients are exact; otherwise they are printed to so many digits

  bool refuted() const;
  bool undecided() const;
};

struct AuditLimits {
  double most_bytes = 500e6;  ///< for trees
  Progress progress;
};

inline bool Audit::refuted() const {
  for (const AuditClaim& c : claims)
    if (c.verdict == AuditClaim::Verdict::refuted) return true;
  return false;
}
inline bool Audit::undecided() const {
  for (const AuditClaim& c : claims)
    if (c.verdict == AuditClaim::Verdict::undecided) return true;
  return false;
}

}  // namespace shortfall
