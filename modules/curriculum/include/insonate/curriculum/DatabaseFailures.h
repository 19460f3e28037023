#pragma once

#include <string>
#include <vector>

namespace insonate {

/// Collects the failures of databases on the thread that made the object, while the object exists: the database cannot
/// be reached, read or written, or refused a statement. What the program itself refuses (a permission, a wrong
/// password) is no failure. The functions of the stores return both as an Error; a server must not show the sentence
/// of a failure, which names the place of the database, to a browser. The innermost object of a thread collects.
class DatabaseFailures {
 public:
  DatabaseFailures();
  ~DatabaseFailures();
  DatabaseFailures(const DatabaseFailures&) = delete;
  DatabaseFailures& operator=(const DatabaseFailures&) = delete;

  /// Returns the sentences of the failures, in their order.
  const std::vector<std::string>& sentences() const { return sentences_; }
  void add(const std::string& sentence) { sentences_.push_back(sentence); }

 private:
  std::vector<std::string> sentences_;
  DatabaseFailures* outer_;
};

}  // namespace insonate
