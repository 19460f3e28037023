#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Copies the end of the audit log to a file outside of the database, so that AuditLog::verify() can detect that a
/// person who owns the database has rewritten the log. The file is a text with a line "TIME NUMBER:HASH" for each
/// anchor. Several servers may write to one file. For one thread.
class AuditAnchors {
 public:
  AuditAnchors(CurriculumStore store, std::filesystem::path file) : store_(std::move(store)), file_(std::move(file)) {}

  /// Appends the present anchor and returns when it is on the disk. Creates a missing file. Does nothing if the log has
  /// not changed since this object's last anchor.
  Result<void> append();

 private:
  CurriculumStore store_;
  std::filesystem::path file_;
  std::optional<AuditAnchor> last_{};
};

/// Reads an anchor from the text "NUMBER:HASH".
Result<AuditAnchor> parseAuditAnchor(const std::string& text);
/// Reads the file of AuditAnchors. A last line that was not written to its end is ignored.
Result<std::vector<AuditAnchor>> readAuditAnchors(const std::filesystem::path& file);

}  // namespace insonate
