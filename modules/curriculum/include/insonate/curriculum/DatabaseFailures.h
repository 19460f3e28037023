#pragma once

#include <string>
#include <vector>

namespace insonate {

/// Collects the database failures that occur on the thread that made the object, while the object exists. A failure
/// means that the database cannot be reached, read or written, or that it refuses a statement. A refusal by the program
/// itself (missing permission, wrong password) is no failure. The functions of the stores return both as an Error. A
/// server must not show a browser the sentence of a failure, since the sentence names the place of the database. If a
/// thread has several such objects, only the innermost one collects.
class DatabaseFailures {
 public:
  DatabaseFailures();
  ~DatabaseFailures();
  DatabaseFailures(const DatabaseFailures&) = delete;
  DatabaseFailures& operator=(const DatabaseFailures&) = delete;

  /// Returns the sentences of the failures, in their order.
  const std::vector<std::string>& sentences() const { return sentences_; }
  /// Called by the stores of this module for each failure on this thread.
  void add(const std::string& sentence) { sentences_.push_back(sentence); }

 private:
  std::vector<std::string> sentences_;
  DatabaseFailures* outer_;
};

}  // namespace insonate
