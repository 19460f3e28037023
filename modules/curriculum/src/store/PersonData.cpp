#include "store/KeptRecordings.h"
#include "store/PeopleRows.h"
#include "store/PersonRows.h"
#include "store/Session.h"
#include "store/ZipFile.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/PersonData.h>

#include <nlohmann/json.hpp>

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

GatheredData gather(Transaction& transaction, const store::Core& core, const std::string& person) {
  nlohmann::ordered_json json{{"about",
                               "All data that Insonate holds on one person. Times (_us) are microseconds since 1970, "
                               "UTC. The recordings of attempts are in the folder recordings."},
                              {"exported_us", core.now_us()}};
  json.update(store::rowsOfPerson(transaction, person));
  GatheredData data;
  data.entries = {{.name = "person.json", .bytes = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace)},
                  {.name = "attempts.csv", .bytes = store::attemptsOfPerson(transaction, person)}};
  for (const Row& row : transaction.rows("SELECT id FROM attempts WHERE person = ? ORDER BY arrival", person)) {
    ++data.counts.attempts;
    const auto file = store::keptRecording(core.recordings(), row.text(0));
    std::error_code error;
    if (core.recordings().empty() || !std::filesystem::is_regular_file(file, error)) continue;
    ++data.counts.recordings;
    data.entries.push_back({.name = "recordings/" + file.filename().string(), .source = file});
  }
  return data;
}

}  // namespace

Result<PersonExport> PersonData::exportTo(const std::string& person, const std::filesystem::path& file,
                                          const Progress& progress) const {
  const store::Core& core = by_.session()->core();
  const auto data = by_.session()->read({.act = Act::ExportPerson, .person = person},
                                        [&](Transaction& transaction, const Actor&) -> Result<GatheredData> {
                                          if (!store::findPerson(transaction, person)) return store::unknownPerson();
                                          return gather(transaction, core, person);
                                        });
  if (!data) return tl::unexpected(data.error());
  const auto written = writeAtomically(file, [&](const std::filesystem::path& beside) {
    return store::writeZip(beside, data->entries, core.now_us(), progress);
  });
  if (!written) return tl::unexpected(written.error());
  return data->counts;
}

}  // namespace insonate
