#include "store/PeopleRows.h"
#include "store/PersonErasure.h"
#include "store/PersonRows.h"
#include "store/Session.h"
#include "store/StoredRecordings.h"
#include "store/ZipFile.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/PersonData.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <system_error>
#include <vector>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Row;
using store::Transaction;
using store::ZipEntry;

/// The entries of the ZIP file, with the recordings last.
struct GatheredData {
  PersonExport counts{};
  std::vector<ZipEntry> entries{};
};

std::vector<std::string> attemptsOf(Transaction& transaction, const std::string& person) {
  std::vector<std::string> ids;
  for (const Row& row : transaction.rows("SELECT id FROM attempts WHERE person = ? ORDER BY arrival", person))
    ids.push_back(row.text(0));
  return ids;
}

GatheredData gather(Transaction& transaction, const store::Core& core, const std::string& person) {
  nlohmann::ordered_json json{{"about",
                               "All data that Insonate holds on one person. Times (_us) are microseconds since 1970, "
                               "UTC. The recordings of attempts are in the folder recordings."},
                              {"exported_us", core.now_us()}};
  json.update(store::rowsOfPerson(transaction, person));
  GatheredData data;
  data.entries = {{.name = "person.json", .bytes = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace)},
                  {.name = "attempts.csv", .bytes = store::attemptsOfPerson(transaction, person)}};
  for (const std::string& attempt : attemptsOf(transaction, person)) {
    ++data.counts.attempts;
    if (!store::isRecordingKept(core.recordings(), attempt)) continue;
    ++data.counts.recordings;
    const auto file = store::storedRecording(core.recordings(), attempt);
    data.entries.push_back({.name = "recordings/" + file.filename().string(), .source = file});
  }
  return data;
}

/// Recordings are stored in the ZIP file as they are; the other entries are small.
Result<void> checkRoom(const std::filesystem::path& file, const std::vector<ZipEntry>& entries, int roomFactor) {
  std::error_code error;
  std::uintmax_t needed_bytes = 0;
  for (const ZipEntry& entry : entries) {
    if (entry.source.empty()) continue;
    const std::uintmax_t size_bytes = std::filesystem::file_size(entry.source, error);
    if (!error) needed_bytes += size_bytes * static_cast<std::uintmax_t>(roomFactor);
  }
  const auto space = std::filesystem::space(std::filesystem::absolute(file, error).parent_path(), error);
  // A folder that cannot be read is told when the file is written.
  if (error || space.available >= needed_bytes) return {};
  constexpr std::uintmax_t kMegabyte_bytes = 1'000'000;
  return fail("The disk has no room for " + file.string() + ": free " +
              std::to_string((needed_bytes - space.available) / kMegabyte_bytes + 1) + " MB, or choose another disk.");
}

}  // namespace

Result<PersonExport> PersonData::exportTo(const std::string& person, const std::filesystem::path& file,
                                          const Progress& progress, int roomFactor) const {
  store::Core& core = by_.session()->core();
  // Logs first: the whole log is read below, while others can write.
  const auto allowed = by_.session()->write({.act = Act::ExportPerson, .person = person},
                                            [&](Transaction& transaction, const Actor&) -> Result<void> {
                                              if (!store::findPerson(transaction, person))
                                                return store::unknownPerson();
                                              return {};
                                            });
  if (!allowed) return tl::unexpected(allowed.error());
  const auto data = inTransaction(core, store::Way::Read, [&](Transaction& transaction) -> Result<GatheredData> {
    return gather(transaction, core, person);
  });
  if (!data) return tl::unexpected(data.error());
  if (auto ok = checkRoom(file, data->entries, roomFactor); !ok) return tl::unexpected(ok.error());
  const auto written = writeAtomically(file, [&](const std::filesystem::path& beside) {
    return store::writeZip(beside, data->entries, core.now_us(), progress);
  });
  if (!written) return tl::unexpected(written.error());
  return data->counts;
}

Result<PersonExtent> PersonData::previewErasure(const std::string& person) const {
  const store::Core& core = by_.session()->core();
  return by_.session()->read(
      {.act = Act::ErasePerson, .person = person, .detail = "preview"},
      [&](Transaction& transaction, const Actor&) -> Result<PersonExtent> {
        if (!store::findPerson(transaction, person)) return store::unknownPerson();
        const std::vector<std::string> attempts = attemptsOf(transaction, person);
        return PersonExtent{
            .attempts = std::ssize(attempts),
            .recordings = std::ranges::count_if(
                attempts, [&](const std::string& id) { return store::isRecordingKept(core.recordings(), id); }),
            .comments = transaction.number("SELECT COUNT(*) FROM comments JOIN attempts ON attempts.id = attempt WHERE "
                                           "person = ? AND removed_us IS NULL",
                                           person),
            .forms = transaction.number("SELECT COUNT(*) FROM forms WHERE person = ?", person),
            .isErased = store::isErased(transaction, person)};
      });
}

Result<void> PersonData::erase(const std::string& person) const {
  const store::Core& core = by_.session()->core();
  std::vector<std::string> attempts;
  auto erased = by_.session()->write({.act = Act::ErasePerson, .person = person},
                                     [&](Transaction& transaction, const Actor& actor) -> Result<void> {
                                       attempts = attemptsOf(transaction, person);
                                       return store::erasePerson(transaction, core, person, actor.id);
                                     });
  return erased ? store::removeRecordings(core.recordings(), attempts) : erased;
}

}  // namespace insonate
