#include "store/AuditChain.h"
#include "store/Core.h"

#include <insonate/curriculum/AuditAnchors.h>

#include <fcntl.h>
#include <unistd.h>

#include <QDateTime>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>

namespace insonate {
namespace {

using store::Transaction;
using store::Way;

tl::unexpected<Error> cannotWrite(const std::filesystem::path& file) {
  return fail(file.string() + " cannot be written: " + std::generic_category().message(errno) +
              ". Name a file in a folder that the server may write (audit-anchors).");
}

/// One call for each line: lines of several servers do not mix.
Result<void> appendLine(const std::filesystem::path& file, const std::string& line) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0640);
  if (opened < 0) return cannotWrite(file);
  const bool isWritten = ::write(opened, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const bool isStored = isWritten && ::fsync(opened) == 0;
  Result<void> done;
  if (!isStored) done = cannotWrite(file);
  ::close(opened);
  return done;
}

}  // namespace

Result<void> AuditAnchors::append() {
  store::Core& core = *store_.core_;
  const auto now = store::inTransaction(
      core, Way::Read, [](Transaction& transaction) -> Result<AuditAnchor> { return store::auditEnd(transaction); });
  if (!now) return tl::unexpected(now.error());
  if (*now == last_) return {};
  const std::string time =
      QDateTime::fromMSecsSinceEpoch(core.now_us() / 1000, Qt::UTC).toString(Qt::ISODate).toStdString();
  // An empty log has no anchor, but the file must exist.
  const std::string line = now->number == 0 ? "" : time + " " + std::to_string(now->number) + ":" + now->hash + "\n";
  if (auto done = appendLine(file_, line); !done) return done;
  last_ = *now;
  return {};
}

Result<AuditAnchor> parseAuditAnchor(const std::string& text) {
  AuditAnchor anchor;
  const auto end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, anchor.number);
  if (error != std::errc() || rest == end || *rest != ':' || rest + 1 == end)
    return fail("'" + text.substr(0, 100) +
                "' is not an anchor. Give the anchor NUMBER:HASH that an earlier 'curriculum verify' printed.");
  anchor.hash.assign(rest + 1, end);
  return anchor;
}

Result<std::vector<AuditAnchor>> readAuditAnchors(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return fail(file.string() + " cannot be read. Name the file that the server writes (key audit-anchors).");
  std::vector<AuditAnchor> anchors;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (in.eof()) break;  // without an end of the line
    if (line.empty()) continue;
    const auto anchor = parseAuditAnchor(line.substr(line.rfind(' ') + 1));
    if (!anchor)
      return fail(file.string() + ", line " + std::to_string(number) + ": '" + line.substr(0, 100) +
                  "' is not an anchor, TIME NUMBER:HASH.");
    anchors.push_back(*anchor);
  }
  return anchors;
}

}  // namespace insonate
