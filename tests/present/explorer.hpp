// SPDX-License-Identifier: MIT
//
// Runs a program through all interleavings with its interrupts.
//
// Rule: the program is run again and again from its start. Wherever something may happen it asks what does;
// the answers of the last run are repeated up to the last of them that had another possibility, which is then
// taken. A state that was met before isn't gone on from, for what follows is the same. So the program must be
// a function of the answers alone, and its state is told completely.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <unordered_set>
#include <vector>

namespace explore {

class Explorer {
 public:
  /// What may happen now, a bit each, at least one; `state` is the whole state of the world. Answers the
  /// index of one bit.
  int choose(unsigned possible, const std::function<std::string()>& state) {
    const int first = lowest(possible);
    if ((possible & (possible - 1U)) == 0) return first;
    if (depth_ < path_.size()) return path_[depth_++].taken;
    if (known_) return first;
    if (!seen_.insert(state()).second) {
      known_ = true;
      return first;
    }
    path_.push_back({first, possible & (possible - 1U)});
    ++depth_;
    return first;
  }

  /// Runs `program` until nothing is left to try or it answers something but an empty string: what is wrong.
  std::string explore(const std::function<std::string()>& program) {
    for (;;) {
      depth_ = 0;
      known_ = false;
      ++runs_;
      if (std::string wrong = program(); !wrong.empty()) return wrong;
      while (!path_.empty() && path_.back().left == 0) path_.pop_back();
      if (path_.empty()) return {};
      Decision& last = path_.back();
      last.taken = lowest(last.left);
      last.left &= last.left - 1U;
    }
  }

  [[nodiscard]] std::size_t states() const { return seen_.size(); }
  [[nodiscard]] std::size_t runs() const { return runs_; }

 private:
  struct Decision {
    int taken = 0;
    unsigned left = 0;
  };

  static int lowest(unsigned bits) {
    int index = 0;
    while ((bits >> static_cast<unsigned>(index) & 1U) == 0) ++index;
    return index;
  }

  std::vector<Decision> path_;
  std::size_t depth_ = 0;
  bool known_ = false;
  std::unordered_set<std::string> seen_;
  std::size_t runs_ = 0;
};

}  // namespace explore
